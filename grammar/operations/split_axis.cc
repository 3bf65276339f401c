#include "grammar/operations/split_axis.h"

#include <fmt/format.h>

#include <cmath>

#include "grammar/operation.h"

namespace parti::grammar {

Result<int> AxisIn(const Item& item, const Action& action) {
  const int axis = static_cast<int>(std::get<Axis>(action.arguments[0]));
  if (item.type == ItemType::kEdge && axis != 0) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("an Edge has no extent along {}", NameOf(static_cast<Axis>(axis))),
                fmt::format("{} along x", action.operation->name));
  }
  if (!IsFlat(item.type) || axis < 2) return axis;
  constexpr double kLevel = 0.70710678118654752;  // elevation of 45 deg, as for :up (errata 10)
  if (std::abs(item.scope.z.y) >= kLevel - 1e-9) return 1;
  return Fail(ErrorCode::kBadArguments,
              fmt::format("an upright {} has no extent along z, so that {} can't cut it there",
                          NameOf(item.type), action.operation->name),
              fmt::format("{} along x or y", action.operation->name));
}

}  // namespace parti::grammar
