#include "app/batch.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/commands/commands.h"

namespace parti::app {
namespace {

std::string Explain(const Error& error, int line) {
  const std::string where = error.place
                                ? fmt::format("line {}, column {}", line, error.place->column)
                                : fmt::format("line {}", line);
  return error.hint.empty() ? fmt::format("{}: {}", where, error.message)
                            : fmt::format("{}: {} ({})", where, error.message, error.hint);
}

// The id of a task, null where it has none; what other kinds of value stand there is not echoed.
BatchAnswer IdOf(const Result<Json>& task) {
  if (!task || !task->is_object()) return nullptr;
  const auto id = task->find("id");
  if (id == task->end() || !(id->is_string() || id->is_number())) return nullptr;
  return BatchAnswer(*id);
}

Result<BatchAnswer> Answer(const Result<Json>& task, const BatchAnswer& id,
                           const AnswerTask& answer) {
  if (!task) return Fail(task);
  if (!task->is_object()) return Fail(ErrorCode::kBadText, "this is not a JSON object");
  if (id.is_null()) {
    return Fail(ErrorCode::kBadText, "\"id\" is missing", "give every line a string or a number");
  }
  return answer(*task);
}

bool IsBlank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

Error NotRead(const std::string& path, const std::string& why) {
  return {ErrorCode::kFile, fmt::format("can't read {}: {}", path, why),
          "check the name and that you may read it"};
}

int Conclude(const BatchTally& tally, const std::string& path) {
  if (!std::cout.flush()) {
    return Report(Error{ErrorCode::kFile, "the answers could not be written to standard output",
                        "check that the disk has room"});
  }
  const int tasks = tally.answered + tally.failed;
  if (tasks == 0) {
    return Report(Error{ErrorCode::kNothingMade, fmt::format("{} holds no task", path),
                        "one JSON object a line is wanted"});
  }
  if (tally.failed == 0) return kDone;
  return Report(Error{ErrorCode::kBadText,
                      fmt::format("{} of {} lines of {} failed", tally.failed, tasks, path),
                      "their answers have an \"error\""});
}

}  // namespace

BatchTally AnswerLines(std::istream& in, std::ostream& out, const AnswerTask& answer) {
  BatchTally tally;
  int number = 0;
  for (std::string line; std::getline(in, line) && out;) {
    ++number;
    if (IsBlank(line)) continue;
    const Result<Json> task = ParseJson(line);
    BatchAnswer row{{"id", IdOf(task)}};
    const Result<BatchAnswer> answered = Answer(task, row["id"], answer);
    if (answered) {
      row.update(*answered);
    } else {
      row["error"] = Explain(answered.error(), number);
    }
    ++(answered ? tally.answered : tally.failed);
    out << row.dump(-1, ' ', false, BatchAnswer::error_handler_t::replace) << '\n';
  }
  return tally;
}

int RunBatch(const std::string& path, const AnswerTask& answer) {
  if (path == "-") return Conclude(AnswerLines(std::cin, std::cout, answer), "standard input");
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return Report(NotRead(path, "it is a folder"));
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) return Report(NotRead(path, std::strerror(errno)));
  const BatchTally tally = AnswerLines(in, std::cout, answer);
  if (in.bad()) return Report(NotRead(path, std::strerror(errno)));
  return Conclude(tally, path);
}

}  // namespace parti::app
