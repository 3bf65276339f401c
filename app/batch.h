// Batches: one JSON object a line in, one answer a line out, in order (`parti segment`, `parti
// suggest --batch`). A bad line never costs the others. Knows nothing of what the answers mean.
#pragma once

#include <functional>
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

#include "base/json.h"

namespace parti::app {

/// An answer's fields, printed in the order in which they were put in. Without "id": the batch
/// writes the task's id in front.
using BatchAnswer = nlohmann::ordered_json;

/// Answers one task: a JSON object that has an "id" (a string or a number).
using AnswerTask = std::function<Result<BatchAnswer>(const Json& task)>;

/// How a batch went.
struct BatchTally {
  int answered = 0;
  int failed = 0;  ///< lines that gave {"id", "error"}
};

/// Reads tasks line by line and writes each answer before it reads the next line. Empty lines are
/// passed over. A line that is no JSON object, has no id, or that `answer` fails on becomes
/// {"id": its id or null, "error": "line 3: what is wrong (the remedy)"}.
BatchTally AnswerLines(std::istream& in, std::ostream& out, const AnswerTask& answer);

/// A whole command: answers the file at `path` ("-" for standard input) on standard output.
/// returns  kDone; kFailed when the file can't be read, holds no task, a line failed, or the
///          answers could not be written; each is said on standard error.
int RunBatch(const std::string& path, const AnswerTask& answer);

}  // namespace parti::app
