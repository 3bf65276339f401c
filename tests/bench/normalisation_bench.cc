// One façade normalised: placed shapes over five layers, each layer over the others. 10,000 shapes
// should take about 200 ms, and 40,000 at most five times that.
#include <benchmark/benchmark.h>

#include "base/check.h"
#include "tests/grammar/layers/scene_support.h"

namespace parti::grammar::tests {
namespace {

enum class Windows : uint8_t { kRectangles, kArches };

/// side x side tiles of 3 m: the tile, a window, its sill, a balcony and a pilaster, each in a
/// layer of its own. Windows, sills and balconies are moved a little, so that no two lie on one
/// line.
TestScene FacadeOf(int side, Windows windows) {
  TestScene scene(3.0 * side, 3.0 * side);
  const auto layers =
      scene.Layers("layers(\"a\", \"b\", \"c\", \"d\", \"e\") { A | B | C | D | E }");
  Random random(1);
  for (int i = 0; i < side * side; ++i) {
    const int column = i % side, row = i / side;
    const Vec2 tile(3.0 * column, 3.0 * row);
    const Vec2 at = tile + Vec2(random.Uniform(0.5, 0.9), random.Uniform(0.8, 1.2));
    scene.Add(layers[0], tile, tile + Vec2(3, 3));
    if (windows == Windows::kArches) {
      scene.AddPolygon(layers[1], Arch(at, Vec2(1.4, 1.5)));
    } else {
      scene.Add(layers[1], at, at + Vec2(1.4, 1.5));
    }
    scene.Add(layers[2], at + Vec2(-0.1, -0.1), at + Vec2(1.5, 0.2));
    scene.Add(layers[3], at + Vec2(-0.2, -0.4), at + Vec2(1.6, 0.4), i % 3 == 0);
    scene.Add(layers[4], tile, tile + Vec2(0.2, 3));
  }
  return scene;
}

void Run(benchmark::State& state, Windows windows) {
  const TestScene scene = FacadeOf(static_cast<int>(state.range(0)), windows);
  size_t pieces = 0;
  for (auto _ : state) {
    ShapeTree tree = scene.tree;
    const auto normalised = Normalise(&tree, scene.planar, scene.shapes);
    CHECK(normalised.has_value(), "the facade is normalised");
    pieces = normalised->pieces.size();
    benchmark::DoNotOptimize(pieces);
  }
  state.counters["shapes"] = static_cast<double>(scene.shapes.size());
}

void BenchNormaliseRectangles(benchmark::State& state) { Run(state, Windows::kRectangles); }
void BenchNormaliseArches(benchmark::State& state) { Run(state, Windows::kArches); }

BENCHMARK(BenchNormaliseRectangles)->Arg(45)->Arg(90)->Unit(benchmark::kMillisecond);
BENCHMARK(BenchNormaliseArches)->Arg(45)->Arg(90)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::grammar::tests
