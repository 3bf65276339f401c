// Selection-action trees from any bytes: parsed, printed, read back as the same value, and derived
// on a small lot, from scratch and on top of the same derivation.
#include <cstdint>

#include "base/check.h"
#include "grammar/selection_action.h"

namespace parti::grammar {
namespace {

ShapeTree Lot() {
  const Vec3 up(0, 1, 0);
  const auto lot = PlanarFrom({{{0, 0, 8}, {8, 0, 8}, {8, 0, 0}, {0, 0, 0}}}, &up);
  CHECK(lot.has_value(), "the lot is one");
  return ShapeTree(*lot);
}

void Try(std::string_view text) {
  static const ShapeTree lot = Lot();
  const auto trees = ParseTrees(text);
  if (!trees) {
    CHECK(!trees.error().empty(), "a failure has an error");
    for (const Error& error : trees.error()) {
      CHECK(error.place.has_value(), "an error in a text has a place");
      (void)FormatError(error);
    }
    return;
  }
  const auto again = ParseTrees(TextOf(*trees));
  CHECK(again.has_value() && *again == *trees, "trees read back");
  const Limits limits{.shapes = 500};
  const auto derivation = Derive(*trees, lot, limits);
  if (!derivation) return;
  const auto shared = Derive(*trees, lot, limits, &*derivation);
  CHECK(shared && shared->tree.SharesAllWith(
                      derivation->nodes.empty() ? derivation->lot : derivation->nodes.back().after),
        "a derivation of the same trees is shared whole");
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::grammar::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
