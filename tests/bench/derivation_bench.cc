// The facade that design/peers.md times, as a selection-action tree: 50 floors of 100 tiles, 15,000
// terminals; and what an edit at its end costs when all before it is shared.
#include <benchmark/benchmark.h>

#include "base/check.h"
#include "grammar/selection_action.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kFacade = R"(tree facade {
  .Lot --> extrude(0.5) Slab
  .Slab --> comp(f) { top: Floors }
  .Floors --> split(y) { ~3: Floor }*
  .Floor --> split(x) { ~3: Tile }*
  .Tile --> split(x) { ~1: Wall | 1.2: Glass | ~1: Wall }
  .Glass:first --> tag("end")
})";
constexpr size_t kTerminals = 15'000;

ShapeTree Lot() {
  const Vec3 up(0, 1, 0);
  const auto lot = PlanarFrom({{{0, 0, 150}, {300, 0, 150}, {300, 0, 0}, {0, 0, 0}}}, &up);
  CHECK(lot.has_value(), "the lot is one");
  return ShapeTree(*lot);
}

Trees FacadeTrees() {
  auto trees = ParseTrees(kFacade);
  CHECK(trees.has_value(), "the facade parses");
  return *trees;
}

void DeriveFacade(benchmark::State& state) {
  const ShapeTree lot = Lot();
  const Trees trees = FacadeTrees();
  for (auto _ : state) {
    const auto derivation = Derive(trees, lot);
    CHECK(derivation && derivation->tree.Leaves().size() == kTerminals, "the facade of peers.md");
  }
  state.counters["terminals/s"] = benchmark::Counter(static_cast<double>(kTerminals),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(DeriveFacade)->Unit(benchmark::kMillisecond);

void DeriveFacadeAfterALateEdit(benchmark::State& state) {
  const ShapeTree lot = Lot();
  const Trees trees = FacadeTrees();
  const auto before = Derive(trees, lot);
  Trees edited = trees;
  edited[0].nodes.back().action.arguments[0] = std::string("changed");
  for (auto _ : state) benchmark::DoNotOptimize(Derive(edited, lot, {}, &*before));
}
BENCHMARK(DeriveFacadeAfterALateEdit)->Unit(benchmark::kMillisecond);

void SelectInFacade(benchmark::State& state, const char* text) {
  const auto derivation = Derive(FacadeTrees(), Lot());
  const auto query = ParseQuery(text);
  CHECK(derivation && query, "the query parses");
  size_t selected = 0;
  for (auto _ : state) selected = ProductOf(*query, derivation->tree)->size();
  state.counters["selected"] = static_cast<double>(selected);
}
BENCHMARK_CAPTURE(SelectInFacade, BySymbol, ".Glass")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SelectInFacade, ByRelations, ".Floor:even > .Tile:odd / .Wall:first")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(SelectInFacade, ByDistance, ".Glass:within(.Floor:first, 10)")
    ->Unit(benchmark::kMillisecond);

void PrintAndReadTrees(benchmark::State& state) {
  const Trees trees = FacadeTrees();
  for (auto _ : state) benchmark::DoNotOptimize(ParseTrees(TextOf(trees)));
}
BENCHMARK(PrintAndReadTrees)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace parti::grammar
