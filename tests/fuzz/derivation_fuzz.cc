// Rules from any bytes, derived on a small lot within budgets of shapes, depth and steps: an error
// or a tree, the same twice, never a crash or a hang. The first byte is the seed.
#include <cstdint>

#include "base/check.h"
#include "grammar/rules/rule_derivation.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

Item Lot() {
  const Vec3 up(0, 1, 0);
  const auto lot = PlanarFrom({{{0, 0, 8}, {8, 0, 8}, {8, 0, 0}, {0, 0, 0}}}, &up);
  CHECK(lot.has_value(), "the lot is one");
  return *lot;
}

void Try(uint8_t seed, std::string_view text) {
  static const Item lot = Lot();
  const auto rules = ParseRules(text, "fuzz.cga",
                                {.importer = {}, .style = {}, .skip_unknown = true, .start = {}});
  if (!rules) return;
  RuleSettings settings;
  settings.seed = seed;
  settings.limits.shapes = 300;
  settings.limits.steps = 5000;
  const auto trees =
      DeriveRules(*rules, settings, {&lot, 1}, {1, nullptr, nullptr, nullptr, nullptr});
  const auto again =
      DeriveRules(*rules, settings, {&lot, 1}, {1, nullptr, nullptr, nullptr, nullptr});
  CHECK(trees.has_value() == again.has_value(), "rules do the same twice");
  if (!trees) {
    (void)FormatError(trees.error());
    return;
  }
  CHECK(trees->front().size() == again->front().size(), "and make the same");
  for (const ShapeIndex leaf : trees->front().Leaves()) (void)AreaOf(trees->front()[leaf].item);
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  parti::grammar::Try(data[0], {reinterpret_cast<const char*>(data + 1), size - 1});
  return 0;
}
