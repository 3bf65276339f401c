// The two scenes that grammar engines are timed with, as rules in our own words: 400 houses of 295
// terminals each, and a wall of 15,000. How long they take on one thread and on two.
#include <benchmark/benchmark.h>

#include "base/check.h"
#include "grammar/rules/rule_derivation.h"
#include "grammar/rules/rule_text.h"
#include "grammar/rules/rule_workers.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kHouses = R"(
  Lot    --> extrude(10) comp(f) { top: Top | vertical: Side }
  Top    --> color("#8b5a3c") roofHip(40, 0.5) Tiles
  Side   --> split(y) { ~3: split(x) { ~3: Bay }* }*
  Bay    --> color("#e6e0d4") split(y) { ~1: Plaster | 1.2: Row | ~1: Plaster }
  Row    --> split(x) { ~1: Plaster | 0.4: Wing | 0.8: Pane | 0.4: Wing | ~1: Plaster }
  Wing   --> extrude(0.08) color("#4f6f52") Shutter
  Pane   --> color("#9fc0d6") Glass
)";
constexpr std::string_view kWall = R"(
  Lot   --> extrude(0.5) comp(f) { top: split(y) { ~3: Storey }* }
  Storey --> split(x) { ~3: split(x) { ~1: Brick | 1.2: Pane | ~1: Brick } }*
)";

Item LotAt(double x, double z, double width, double depth) {
  const Vec3 up(0, 1, 0);
  const auto lot = PlanarFrom(
      {{{x, 0, z + depth}, {x + width, 0, z + depth}, {x + width, 0, z}, {x, 0, z}}}, &up);
  CHECK(lot.has_value(), "the lot is one");
  return *lot;
}

/// 20 by 20 lots of a village.
std::vector<Item> Village() {
  std::vector<Item> lots;
  for (int i = 0; i < 400; ++i) {
    const int column = i % 20, row = i / 20;
    lots.push_back(LotAt(column * 12.0, row * 15.0, 8, 11));
  }
  return lots;
}

void Derive(benchmark::State& state, std::string_view text, const std::vector<Item>& lots) {
  const auto rules = ParseRules(text, "bench.cga");
  CHECK(rules.has_value(), "the scene parses");
  AwaitRuleWorkers();
  size_t terminals = 0, bytes = 0;
  for (auto _ : state) {
    const auto trees = DeriveRules(
        *rules, {}, lots, {static_cast<int>(state.range(0)), nullptr, nullptr, nullptr, nullptr});
    CHECK(trees.has_value(), "the scene derives");
    terminals = bytes = 0;
    for (const ShapeTree& tree : *trees) {
      terminals += tree.Leaves().size();
      bytes += tree.size() * (sizeof(Shape) + sizeof(ShapeNode));
    }
  }
  state.counters["terminals"] = static_cast<double>(terminals);
  state.counters["bytes/terminal"] = static_cast<double>(bytes) / static_cast<double>(terminals);
  state.counters["terminals/s"] = benchmark::Counter(static_cast<double>(terminals),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

void DeriveHouses(benchmark::State& state) { Derive(state, kHouses, Village()); }
void DeriveWall(benchmark::State& state) { Derive(state, kWall, {LotAt(0, 0, 300, 150)}); }
BENCHMARK(DeriveHouses)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(DeriveWall)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::grammar
