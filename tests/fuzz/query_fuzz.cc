// Queries from any bytes: parsed, printed, read back as the same value, and run on a small house.
#include <cstdint>
#include <cstdlib>

#include "base/check.h"
#include "grammar/selection_action.h"

namespace parti::grammar {
namespace {

ShapeTree House() {
  const Vec3 up(0, 1, 0);
  const auto lot = PlanarFrom({{{0, 0, 8}, {8, 0, 8}, {8, 0, 0}, {0, 0, 0}}}, &up);
  const auto trees = ParseTrees(R"(tree t {
    .Lot --> extrude(6) Mass
    .Mass --> comp(f) { side: Facade | top: Roof }
    .Facade:south --> split(y) { ~3: tag("t") Floor }*
  })");
  CHECK(lot && trees, "the house parses");
  const auto derivation = Derive(*trees, ShapeTree(*lot));
  CHECK(derivation.has_value(), "the house derives");
  return derivation->tree;
}

void Try(std::string_view text) {
  static const ShapeTree house = House();
  const auto query = ParseQuery(text);
  if (!query) {
    CHECK(query.error().place.has_value(), "an error in a text has a place");
    (void)FormatError(query.error());
    return;
  }
  const auto again = ParseQuery(TextOf(*query));
  CHECK(again.has_value() && *again == *query, "a query reads back");
  const auto product = ProductOf(*query, house);
  CHECK(product.has_value(), "what parses runs");
  for (size_t i = 1; i < product->size(); ++i) {
    CHECK((*product)[i - 1] < (*product)[i], "each shape once, in creation order");
  }
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::grammar::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
