// What one operation costs: on rectangles and boxes, which most shapes are, and on a footprint with
// corners. The terminals per second of a derivation can't be more than these.
#include <benchmark/benchmark.h>

#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

constexpr const char* kRectangle = "0,0 20,0 20,12 0,12";
/// Footprint of a real house: 12 corners, concave.
constexpr const char* kHouse =
    "0,0 9.2,0 9.2,2.1 14.5,2.1 14.5,0.4 21,0.4 21,11.8 12.3,11.8 12.3,9.7 8.1,9.7 8.1,12 0,12";

void Run(benchmark::State& state, const Action& action, const Item& item) {
  size_t products = 0;
  for (auto _ : state) {
    const auto made = Apply(action, item);
    products = made->size();
    benchmark::DoNotOptimize(made->data());
  }
  state.counters["products"] = static_cast<double>(products);
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * products));
}

Item MassOf(const char* outline) { return Apply(Extrude(12), Lot(outline))->front().item; }

const Action kFloors = Split(Axis::kY, {Metres(4, "Ground"), Group({Floating(3, "Floor")})});
const Action kTiles = Repeat(Axis::kX, {Floating(0.2, "Tile")});

void BenchExtrudeRectangle(benchmark::State& s) { Run(s, Extrude(12), Lot(kRectangle)); }
void BenchExtrudeHouse(benchmark::State& s) { Run(s, Extrude(12), Lot(kHouse)); }
void BenchCompBox(benchmark::State& s) { Run(s, AllFaces(), MassOf(kRectangle)); }
void BenchCompHouse(benchmark::State& s) { Run(s, AllFaces(), MassOf(kHouse)); }
void BenchSplitBox(benchmark::State& s) { Run(s, kFloors, MassOf(kRectangle)); }
void BenchSplitHouse(benchmark::State& s) { Run(s, kFloors, MassOf(kHouse)); }
void BenchTile100Rectangle(benchmark::State& s) { Run(s, kTiles, Lot(kRectangle)); }
void BenchTile105House(benchmark::State& s) { Run(s, kTiles, Lot(kHouse)); }
void BenchOffsetRectangle(benchmark::State& s) { Run(s, OffsetBy(-1), Lot(kRectangle)); }
void BenchOffsetHouse(benchmark::State& s) { Run(s, OffsetBy(-1), Lot(kHouse)); }
void BenchOffsetHouseOutward(benchmark::State& s) { Run(s, OffsetBy(1), Lot(kHouse)); }

BENCHMARK(BenchExtrudeRectangle);
BENCHMARK(BenchExtrudeHouse);
BENCHMARK(BenchCompBox);
BENCHMARK(BenchCompHouse);
BENCHMARK(BenchSplitBox);
BENCHMARK(BenchSplitHouse);
BENCHMARK(BenchTile100Rectangle);
BENCHMARK(BenchTile105House);
BENCHMARK(BenchOffsetRectangle);
BENCHMARK(BenchOffsetHouse)->Unit(benchmark::kMicrosecond);
BENCHMARK(BenchOffsetHouseOutward)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace parti::grammar::tests
