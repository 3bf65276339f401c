// rotateScope(xAngle, yAngle, zAngle): the scope turned, geometry where it was.
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/row_parts.h"
#include "grammar/reframe.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyRotateScope(const Item& item, const Action& action) {
  const Vec3 angles_deg(std::get<double>(action.arguments[0]),
                        std::get<double>(action.arguments[1]),
                        std::get<double>(action.arguments[2]));
  return std::vector<Product>{{Reframed(item, TurnedAxes(NamedScope(item), angles_deg)), -1}};
}

const std::array<Parameter, 3> kParameters = {
    TurnParameter("xAngle", "around the scope's x, first"),
    TurnParameter("yAngle", "around its y, as it was before; then"),
    TurnParameter("zAngle", "around its z, as it was before")};

}  // namespace

constinit const Operation kRotateScope = {
    .name = "rotateScope",
    .word = "RotateScope",
    .doc =
        "Turns the scope and leaves the geometry where it is: what is left becomes the front. A "
        "planar shape's scope stays in its plane.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyRotateScope,
};

}  // namespace parti::grammar
