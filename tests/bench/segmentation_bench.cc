// Time of segmenting one stroke: real strokes (segmentation alone, nothing read or written), and
// how it grows with the samples.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <vector>

#include "base/json.h"
#include "base/random.h"
#include "sketch/segmentation.h"
#include "tests/support/data.h"

namespace parti::sketch {
namespace {

std::vector<Stroke> RealStrokes(const std::string& path) {
  std::vector<Stroke> strokes;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const auto json = ParseJson(line);
    const auto stroke = StrokeFrom(json ? (*json)["points"] : Json(), "points");
    if (stroke) strokes.push_back(*stroke);
  }
  return strokes;
}

double MicrosecondsOf(const Stroke& stroke) {
  const auto start = std::chrono::steady_clock::now();
  benchmark::DoNotOptimize(SegmentStroke(stroke));
  const std::chrono::duration<double, std::micro> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

// One iteration is all strokes once; median and p95 are per stroke, of the last iteration.
void SegmentRealStrokes(benchmark::State& state, const char* name) {
  const std::string path = tests::DataFile(name);
  if (path.empty()) {
    state.SkipWithError("no data: set PARTI_DATA, or put shared/ beside the project");
    return;
  }
  const std::vector<Stroke> strokes = RealStrokes(path);
  std::vector<double> times_us(strokes.size());
  for (auto _ : state) {
    for (size_t i = 0; i < strokes.size(); ++i) times_us[i] = MicrosecondsOf(strokes[i]);
  }
  std::sort(times_us.begin(), times_us.end());
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(strokes.size()));
  state.counters["median_us"] = times_us[times_us.size() / 2];
  state.counters["p95_us"] = times_us[times_us.size() * 95 / 100];
  state.counters["max_us"] = times_us.back();
}
BENCHMARK_CAPTURE(SegmentRealStrokes, gestures, "strokes/unistrokes-dev.jsonl")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SegmentRealStrokes, handwriting, "strokes/wacom-ink-dev.jsonl")
    ->Unit(benchmark::kMillisecond);

void SegmentScribble(benchmark::State& state) {
  Random random(1);
  Stroke stroke;
  for (int64_t i = 0; i < state.range(0); ++i) {
    stroke.push_back(
        {Vec2(random.Uniform(0, 900), random.Uniform(0, 900)), 0.005 * static_cast<double>(i)});
  }
  for (auto _ : state) benchmark::DoNotOptimize(SegmentStroke(stroke));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(SegmentScribble)->Range(100, 100'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace parti::sketch
