// Any bytes as a sketching task: suggestions that can be applied and printed, or an error.
#include <cstdint>
#include <string_view>

#include "app/sketch_task.h"
#include "base/check.h"
#include "grammar/operation.h"
#include "sketch/suggestion.h"
#include "sketch/target.h"

namespace {

void CheckError(const parti::Error& error) {
  CHECK(!parti::FormatError(error).empty(), "an error says what is wrong");
}

void CheckSuggestion(const parti::sketch::Suggestion& suggestion,
                     const parti::grammar::Item& item) {
  CHECK(std::isfinite(suggestion.score) && std::isfinite(suggestion.error), "scores are finite");
  CHECK(parti::grammar::Apply(suggestion.action, item).has_value(), "suggestions can be applied");
  CHECK(!parti::app::AnswerOf(suggestion, item).dump().empty(), "suggestions can be printed");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto json =
      parti::ParseJson(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz");
  if (!json) return 0;
  const auto task = parti::app::SketchTaskFrom(*json);
  if (!task) {
    CheckError(task.error());
    return 0;
  }
  const auto found = parti::sketch::SuggestFromStrokes(task->strokes, task->item, task->camera);
  if (!found) CheckError(found.error());
  if (found) {
    for (const auto& suggestion : *found) CheckSuggestion(suggestion, task->item);
  }
  const auto targets = parti::sketch::RankTargets(task->strokes, task->camera, {&task->item, 1});
  if (!targets) CheckError(targets.error());
  return 0;
}
