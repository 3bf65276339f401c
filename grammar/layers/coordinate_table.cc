#include "grammar/layers/coordinate_table.h"

#include <algorithm>

namespace parti::grammar {
namespace {

/// Clusters grow from neighbour to neighbour, but not without end.
constexpr double kWidestCluster = 4;

}  // namespace

void CoordinateTable::Merge(double tolerance) {
  std::sort(given_.begin(), given_.end(), [](const Given& a, const Given& b) {
    return a.value != b.value ? a.value < b.value : a.leading > b.leading;
  });
  bool led = false;
  for (size_t i = 0; i < given_.size(); ++i) {
    const Given& given = given_[i];
    const bool near = i > 0 && given.value - given_[i - 1].value <= tolerance &&
                      given.value - lows_.back() <= kWidestCluster * tolerance;
    if (!near) {
      lows_.push_back(given.value);
      values_.push_back(given.value);
    } else if (given.leading && !led) {
      values_.back() = given.value;
    }
    led = given.leading || (near && led);
  }
  given_.clear();
  given_.shrink_to_fit();
}

uint32_t CoordinateTable::IndexOf(double given) const {
  const auto after = std::upper_bound(lows_.begin(), lows_.end(), given);
  return static_cast<uint32_t>(after - lows_.begin()) - 1;
}

}  // namespace parti::grammar
