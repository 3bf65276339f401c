// What a sketch costs, from strokes to ranked operations, and what finding its shape costs.
#include <benchmark/benchmark.h>

#include "app/sketch_task.h"
#include "base/json.h"
#include "base/text_file.h"
#include "sketch/suggestion.h"
#include "sketch/target.h"
#include "tests/support/data.h"

namespace parti::sketch {
namespace {

Result<app::SketchTask> TaskNamed(const std::string& name) {
  const auto text = ReadFile(tests::SourceFile("tests/fuzz/corpus/tasks/" + name));
  if (!text) return Fail(text);
  const auto json = ParseJson(*text);
  if (!json) return Fail(json);
  return app::SketchTaskFrom(*json);
}

void BenchSuggest(benchmark::State& state, const std::string& name) {
  const auto task = TaskNamed(name);
  if (!task) return state.SkipWithError(task.error().message.c_str());
  for (auto _ : state) {
    auto found = SuggestFromStrokes(task->strokes, task->item, task->camera);
    if (!found) return state.SkipWithError(found.error().message.c_str());
    benchmark::DoNotOptimize(found->data());
  }
}
BENCHMARK_CAPTURE(BenchSuggest, extrude, "extrude")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BenchSuggest, split, "split")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BenchSuggest, comp, "comp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(BenchSuggest, concave, "concave")->Unit(benchmark::kMillisecond);

/// n x n lots in a plane, of which the task's is one.
void BenchRankTargets(benchmark::State& state) {
  const auto task = TaskNamed("extrude");
  if (!task) return state.SkipWithError(task.error().message.c_str());
  const int n = static_cast<int>(state.range(0));
  std::vector<grammar::Item> items;
  for (int i = 0; i < n * n; ++i) {
    items.push_back(task->item);
    const int column = i % n, row = i / n;
    items.back().scope.origin += Vec3(24.0 * column, 0, -16.0 * row);
  }
  for (auto _ : state) {
    auto ranked = RankTargets(task->strokes, task->camera, items);
    if (!ranked) return state.SkipWithError(ranked.error().message.c_str());
    benchmark::DoNotOptimize(ranked->data());
  }
}
BENCHMARK(BenchRankTargets)->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::sketch
