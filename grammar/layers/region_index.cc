#include "grammar/layers/region_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parti::grammar {
namespace {

constexpr double kMostCells = 1024;  // along an axis

uint32_t CellOf(double offset, double per_cell, uint32_t cells) {
  return static_cast<uint32_t>(std::clamp(std::floor(offset * per_cell), 0.0, cells - 1.0));
}

}  // namespace

RegionIndex::RegionIndex(const Box2& bounds, size_t count) : bounds_(bounds) {
  const double side = std::sqrt(static_cast<double>(count));
  side_ = static_cast<uint32_t>(std::clamp(side, 1.0, kMostCells));
  per_cell_ = Vec2(side_, side_) / glm::max(bounds.high - bounds.low, Vec2(1e-9, 1e-9));
  cells_.resize(static_cast<size_t>(side_) * side_);
}

RegionIndex::Cells RegionIndex::CellsOf(const Box2& box) const {
  const Vec2 low = box.low - bounds_.low, high = box.high - bounds_.low;
  return {CellOf(low.x, per_cell_.x, side_), CellOf(high.x, per_cell_.x, side_),
          CellOf(low.y, per_cell_.y, side_), CellOf(high.y, per_cell_.y, side_)};
}

void RegionIndex::Add(uint32_t number, const Box2& box) {
  if (number >= found_in_.size()) found_in_.resize(number + 1, 0);
  const Cells cells = CellsOf(box);
  for (uint32_t row = cells.bottom; row <= cells.top; ++row) {
    for (uint32_t column = cells.left; column <= cells.right; ++column) {
      cells_[row * side_ + column].push_back(number);
    }
  }
}

const std::vector<uint32_t>& RegionIndex::Near(const Box2& box) {
  near_.clear();
  ++search_;
  const Cells cells = CellsOf(box);
  for (uint32_t row = cells.bottom; row <= cells.top; ++row) {
    for (uint32_t column = cells.left; column <= cells.right; ++column) {
      for (const uint32_t number : cells_[row * side_ + column]) {
        if (std::exchange(found_in_[number], search_) != search_) near_.push_back(number);
      }
    }
  }
  std::sort(near_.begin(), near_.end());
  return near_;
}

}  // namespace parti::grammar
