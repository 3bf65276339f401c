// r(xAngle, yAngle, zAngle): a shape turned with its scope, around its origin or its middle.
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/row_parts.h"
#include "grammar/reframe.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kAboutOrigin = "scopeOrigin";
constexpr std::string_view kAboutCenter = "scopeCenter";

Result<std::vector<Product>> ApplyRotate(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  const Vec3 angles_deg(std::get<double>(action.arguments[1]),
                        std::get<double>(action.arguments[2]),
                        std::get<double>(action.arguments[3]));
  Scope turned = TurnedAxes(named, angles_deg);
  if (std::get<std::string>(action.arguments[0]) == kAboutCenter) {
    turned.origin += named.ToWorld(named.size * 0.5) - turned.ToWorld(named.size * 0.5);
  }
  return std::vector<Product>{{Placed(item, turned), -1}};
}

constexpr std::array<std::string_view, 2> kCenters = {kAboutOrigin, kAboutCenter};

const std::array<Parameter, 4> kParameters = {
    Parameter{.name = "center",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kAboutOrigin),
              .required = false,
              .doc = "what stays where it is; may be left out",
              .words = kCenters},
    TurnParameter("xAngle", "around the scope's x, first"),
    TurnParameter("yAngle", "around its y, as it was before; then"),
    TurnParameter("zAngle", "around its z, as it was before")};

}  // namespace

constinit const Operation kRotate = {
    .name = "r",
    .word = "Rotate",
    .doc = "Turns a shape, and its scope's axes with it.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyRotate,
};

}  // namespace parti::grammar
