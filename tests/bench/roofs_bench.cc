// Roofs and offsets over random, jittered and real outlines: milliseconds per shape, all operations
// of grammar/roof.h and polygon.h's Offset.
#include <benchmark/benchmark.h>

#include "grammar/inner_rectangle.h"
#include "grammar/polygon_setback.h"
#include "grammar/roof.h"
#include "tests/grammar/roof_shapes.h"

namespace parti::grammar {
namespace {

constexpr int kOutlines = 20;

/// Outlines of one kind: 0 a rectangle, 1 a random 24-gon, 2 an L with 2 cm jitter, 3 a comb with
/// 8 points per edge and 5 cm jitter (160 corners).
std::vector<Polygon> Outlines(int64_t kind) {
  std::vector<Polygon> outlines;
  for (uint64_t seed = 0; seed < kOutlines; ++seed) {
    Random random(seed);
    if (kind == 0) outlines.push_back(Rectangle(Vec2(20, 12)));
    if (kind == 1) outlines.push_back({tests::RandomTangle(24, &random), {}});
    if (kind == 2) {
      const Ring ring = tests::LetterRing(tests::Letter::kL, &random);
      outlines.push_back({tests::Surveyed(ring, 1, 0.02, &random), {}});
    }
    if (kind == 3) {
      const Ring ring = tests::LetterRing(tests::Letter::kComb, &random);
      outlines.push_back({tests::Surveyed(ring, 8, 0.05, &random), {}});
    }
  }
  return outlines;
}

template <typename Make>
void OverOutlines(benchmark::State& state, const Make& make) {
  const std::vector<Polygon> outlines = Outlines(state.range(0));
  size_t at = 0;
  for (auto _ : state) {
    const auto made = make(outlines[at++ % outlines.size()]);
    if (!made) state.SkipWithError("an operation failed");
    benchmark::DoNotOptimize(made);
  }
}

void BenchHipRoof(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return HipRoof(p, {false, 35}, 0); });
}
void BenchHipRoofWithOverhang(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return HipRoof(p, {false, 35}, 0.6); });
}
void BenchGableRoof(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return GableRoof(p, {false, 35}, {}, Vec2(0, -1)); });
}
void BenchInset(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return Offset(p, 0.8); });
}
void BenchOutset(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return Offset(p, -0.8); });
}
void BenchSetbackOfHalfTheEdges(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) {
    std::vector<EdgeSetback> edges(p.outer.size());
    for (size_t i = 0; i < edges.size(); i += 2) edges[i] = {1.5, 0};
    return Setback(p, edges);
  });
}
void BenchInnerRectangle(benchmark::State& state) {
  OverOutlines(state, [](const Polygon& p) { return InnerRectangle(p, Vec2(1, 0)); });
}

BENCHMARK(BenchHipRoof)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchHipRoofWithOverhang)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchGableRoof)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchInset)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchOutset)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchSetbackOfHalfTheEdges)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchInnerRectangle)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::grammar
