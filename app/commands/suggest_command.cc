// parti suggest --batch TASKS.jsonl: the operations meant by sketches, as JSON lines.
#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <chrono>
#include <memory>

#include "app/batch.h"
#include "app/commands/commands.h"
#include "app/sketch_task.h"

namespace parti::app {
namespace {

Result<BatchAnswer> Answer(const Json& json) {
  const auto task = SketchTaskFrom(json);
  if (!task) return Fail(task);
  const auto start = std::chrono::steady_clock::now();
  const auto suggestions = sketch::SuggestFromStrokes(task->strokes, task->item, task->camera);
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  if (!suggestions) return Fail(suggestions);
  BatchAnswer list = BatchAnswer::array();
  for (const sketch::Suggestion& s : *suggestions) list.push_back(AnswerOf(s, task->item));
  return BatchAnswer{{"ms", ms.count()}, {"suggestions", std::move(list)}};
}

}  // namespace

void AddSuggestCommand(CLI::App& app, Run* run) {
  CLI::App* command =
      app.add_subcommand("suggest", "operations meant by sketches; answers on standard output");
  command->footer(
      "Example:\n  parti suggest --batch tasks.jsonl > answers.jsonl\n"
      "A task a line: {\"id\", \"shape\", \"camera\", \"strokes\"}; docs/inference.md has the "
      "rest.");
  const auto path = std::make_shared<std::string>();
  command->add_option("--batch", *path, "sketching tasks, one a line; - for standard input")
      ->required()
      ->type_name("TASKS.jsonl");
  command->callback([path, run] { *run = [path] { return RunBatch(*path, &Answer); }; });
}

}  // namespace parti::app
