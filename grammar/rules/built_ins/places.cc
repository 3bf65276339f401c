// scope.sx, split.index, initialShape.area …: where a shape stands, and which of several it is.
#include <algorithm>
#include <cmath>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

/// Of what lies, y and z are both the second axis in its plane, as for split.
template <int kAxis>
Value Size(Values, const Situation& situation) {
  const Item& item = *situation.item;
  constexpr double kLevel = 0.70710678118654752;  // elevation of 45 deg, as for :up (errata 10)
  const bool lies = IsFlat(item.type) && std::abs(item.scope.z.y) >= kLevel - 1e-9;
  const bool has_depth = item.scope.size.z > 0;
  const int axis = lies && !has_depth ? std::min(kAxis, 1) : kAxis;
  return item.scope.size[axis];
}

/// From the lot's origin, along the world's axes.
template <int kAxis>
Value Offset(Values, const Situation& situation) {
  return situation.item->scope.origin[kAxis] - situation.lot->scope.origin[kAxis];
}

/// The angles by which the world's axes are turned about x, then y, then z, to become the scope's.
template <int kAxis>
Value Rotation(Values, const Situation& situation) {
  const Scope& s = situation.item->scope;
  const double y = std::asin(std::clamp(-s.x.z, -1.0, 1.0));
  if (kAxis == 1) return Angle::Radians(y).degrees();
  constexpr double kLocked = 1 - 1e-9;
  if (std::abs(s.x.z) > kLocked) {
    return kAxis == 0 ? Angle::Radians(std::atan2(-s.z.y, s.y.y)).degrees() : 0.0;
  }
  return Angle::Radians(kAxis == 0 ? std::atan2(s.y.z, s.z.z) : std::atan2(s.x.y, s.x.x)).degrees();
}

template <Turn Situation::*kTurn>
Value Index(Values, const Situation& situation) {
  return static_cast<double>((situation.*kTurn).index);
}

template <Turn Situation::*kTurn>
Value Total(Values, const Situation& situation) {
  return static_cast<double>((situation.*kTurn).total);
}

template <int kAxis>
Value LotOrigin(Values, const Situation& situation) {
  return situation.lot->scope.origin[kAxis];
}

constexpr BuiltIn kRows[] = {
    {"scope.sx", {}, kNumber, "size of the scope along its x axis, in metres", Size<0>},
    {"scope.sy", {}, kNumber, "the same along y", Size<1>},
    {"scope.sz",
     {},
     kNumber,
     "the same along z; of what lies its depth, else 0 for what is flat",
     Size<2>},
    {"scope.tx",
     {},
     kNumber,
     "where the scope begins, eastward from where the lot does",
     Offset<0>},
    {"scope.ty", {}, kNumber, "the same, upward", Offset<1>},
    {"scope.tz", {}, kNumber, "the same, southward", Offset<2>},
    {"scope.rx",
     {},
     kNumber,
     "how far the scope is turned about the world's x axis, in degrees",
     Rotation<0>},
    {"scope.ry", {}, kNumber, "the same about y", Rotation<1>},
    {"scope.rz", {}, kNumber, "the same about z", Rotation<2>},
    {"scope.elevation",
     {},
     kNumber,
     "height over the world's origin where the scope begins",
     [](Values, const Situation& situation) -> Value { return situation.item->scope.origin.y; }},
    {"split.index",
     {},
     kNumber,
     "which piece of the last split it is or is in, from 0",
     Index<&Situation::split>},
    {"split.total", {}, kNumber, "of how many", Total<&Situation::split>},
    {"comp.index",
     {},
     kNumber,
     "which part of the last comp it is or is in, from 0",
     Index<&Situation::comp>},
    {"comp.total", {}, kNumber, "of how many", Total<&Situation::comp>},
    {"initialShape.origin.px",
     {},
     kNumber,
     "where the lot begins in the world, eastward",
     LotOrigin<0>},
    {"initialShape.origin.py", {}, kNumber, "the same, upward", LotOrigin<1>},
    {"initialShape.origin.pz", {}, kNumber, "the same, southward", LotOrigin<2>},
    {"initialShape.area",
     {},
     kNumber,
     "the lot's area in square metres",
     [](Values, const Situation& situation) -> Value { return AreaOf(*situation.lot); }},
};

}  // namespace

std::span<const BuiltIn> Places() { return kRows; }

}  // namespace parti::grammar::built_ins
