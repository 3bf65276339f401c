// alignScopeToAxes(axis): the scope turned to the world's axes, geometry where it was.
#include <array>
#include <utility>

#include "grammar/operations/rows.h"
#include "grammar/reframe.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kAll = "all", kX = "x", kY = "y", kZ = "z";
constexpr double kFlat = 0.70710678118654752;  // elevation of 45 deg, as for :up (errata 10)
constexpr Vec3 kUp{0, 1, 0};

Vec3 AtRightAngles(const Vec3& v, const Vec3& to) { return v - to * glm::dot(v, to); }

/// Axes with number `axis` along the world's, and the one after it as near to where it was as that
/// leaves it.
Scope WithAxis(const Scope& scope, int axis) {
  Vec3 axes[3] = {scope.x, scope.y, scope.z};
  const int next = axis == 1 ? 0 : 1, last = 3 - axis - next;
  Vec3 along(0, 0, 0);
  along[axis] = 1;
  axes[axis] = along;
  Vec3 kept = AtRightAngles(axes[next], along);
  if (glm::length(kept) < kLengthTolerance_m) kept = AtRightAngles(axes[last], along);
  axes[next] = glm::normalize(kept);
  const bool is_cyclic = (axis + 1) % 3 == next;
  axes[last] = is_cyclic ? glm::cross(along, axes[next]) : glm::cross(axes[next], along);
  Scope turned = scope;
  turned.x = axes[0];
  turned.y = axes[1];
  turned.z = axes[2];
  return turned;
}

/// Of a planar shape only x counts: level on upright ones, so that y rises; along the world's x on
/// those that lie, unless only y was meant, which is their normal.
Scope AxesFor(const Item& item, std::string_view word) {
  const Scope world;
  if (item.type == ItemType::kVolume) {
    if (word == kAll) return world;
    return WithAxis(item.scope, word == kX ? 0 : word == kY ? 1 : 2);
  }
  Scope axes = item.scope;
  const bool lies = std::abs(item.scope.z.y) >= kFlat - 1e-9;
  if (lies && word == kY) return axes;
  const bool is_upright = !lies && word != kX && word != kZ;
  axes.x = is_upright ? glm::cross(kUp, item.scope.z) : world.x;
  return axes;
}

Result<std::vector<Product>> ApplyAlign(const Item& item, const Action& action) {
  const Scope axes = AxesFor(item, std::get<std::string>(action.arguments[0]));
  return std::vector<Product>{{Reframed(item, axes), -1}};
}

constexpr std::array<std::string_view, 4> kAxes = {kAll, kX, kY, kZ};

const std::array<Parameter, 1> kParameters = {{{
    .name = "axis",
    .kind = ParameterKind::kWord,
    .default_value = std::string(kAll),
    .required = false,
    .doc = "the one that has to be the world's; left out: all three",
    .words = kAxes,
}}};

}  // namespace

constinit const Operation kAlignToAxes = {
    .name = "alignScopeToAxes",
    .word = "AlignScopeToAxes",
    .doc =
        "Turns the scope to the world's axes and leaves the geometry where it is. A planar shape's "
        "scope stays in its plane.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyAlign,
};

}  // namespace parti::grammar
