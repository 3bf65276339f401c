// r(xAngle, yAngle, zAngle): a shape turned with its scope, around its origin or its middle.
#include <array>
#include <cmath>

#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kAboutOrigin = "scopeOrigin";
constexpr std::string_view kAboutCenter = "scopeCenter";

/// `v` turned around axis i by the angle, right-handed.
Vec3 Around(int i, const Angle& angle, const Vec3& v) {
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  const double cosine = std::cos(angle.radians()), sine = std::sin(angle.radians());
  Vec3 turned = v;
  turned[j] = cosine * v[j] - sine * v[k];
  turned[k] = sine * v[j] + cosine * v[k];
  return turned;
}

Result<std::vector<Product>> ApplyRotate(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  const auto turn = [&](Vec3 v) {
    for (int i = 0; i < 3; ++i) {
      const double degrees = std::get<double>(action.arguments[static_cast<size_t>(i) + 1]);
      if (degrees != 0) v = Around(i, Angle::Degrees(degrees), v);
    }
    return named.x * v.x + named.y * v.y + named.z * v.z;
  };
  Scope turned = named;
  turned.x = turn(Vec3(1, 0, 0));
  turned.y = turn(Vec3(0, 1, 0));
  turned.z = turn(Vec3(0, 0, 1));
  if (std::get<std::string>(action.arguments[0]) == kAboutCenter) {
    turned.origin += named.ToWorld(named.size * 0.5) - turned.ToWorld(named.size * 0.5);
  }
  return std::vector<Product>{{Placed(item, turned), -1}};
}

constexpr std::array<std::string_view, 2> kCenters = {kAboutOrigin, kAboutCenter};

Parameter About(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kAngle,
          .low = -3600,
          .high = 3600,
          .default_value = 0.0,
          .doc = doc};
}

const std::array<Parameter, 4> kParameters = {
    Parameter{.name = "center",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kAboutOrigin),
              .required = false,
              .doc = "what stays where it is; may be left out",
              .words = kCenters},
    About("xAngle", "around the scope's x, first"),
    About("yAngle", "around its y, as it was before; then"),
    About("zAngle", "around its z, as it was before")};

}  // namespace

constinit const Operation kRotate = {
    .name = "r",
    .word = "Rotate",
    .doc = "Turns a shape, and its scope's axes with it.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kNone,
    .selectors = {},
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .apply = ApplyRotate,
};

}  // namespace parti::grammar
