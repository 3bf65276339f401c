#include "grammar/layers/vertex_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parti::grammar {
namespace {

constexpr uint32_t kMostCells = 2048;  // along an axis

uint32_t CellOf(double offset, double per_cell, uint32_t cells) {
  const double cell = std::floor(offset * per_cell);
  return static_cast<uint32_t>(std::clamp(cell, 0.0, static_cast<double>(cells - 1)));
}

}  // namespace

VertexGrid::VertexGrid(std::span<const Vec2> vertices) : vertices_(vertices) {
  if (vertices.empty()) return;
  bounds_ = {vertices[0], vertices[0]};
  for (const Vec2& v : vertices) {
    bounds_.low = glm::min(bounds_.low, v);
    bounds_.high = glm::max(bounds_.high, v);
  }
  const auto side = static_cast<uint32_t>(std::sqrt(static_cast<double>(vertices.size())));
  columns_ = rows_ = std::clamp(side, 1u, kMostCells);
  const Vec2 size = glm::max(bounds_.high - bounds_.low, Vec2(1e-9, 1e-9));
  per_cell_ = Vec2(columns_, rows_) / size;
  starts_.assign(static_cast<size_t>(columns_) * rows_ + 1, 0);
  const auto cell_of = [&](const Vec2& v) { return RowOf(v.y) * columns_ + ColumnOf(v.x); };
  for (const Vec2& v : vertices) ++starts_[cell_of(v) + 1];
  for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
  numbers_.resize(vertices.size());
  for (uint32_t i = 0; i < vertices.size(); ++i) numbers_[next[cell_of(vertices[i])]++] = i;
}

uint32_t VertexGrid::ColumnOf(double x) const {
  return CellOf(x - bounds_.low.x, per_cell_.x, columns_);
}
uint32_t VertexGrid::RowOf(double y) const { return CellOf(y - bounds_.low.y, per_cell_.y, rows_); }

std::vector<uint32_t> VertexGrid::Along(uint32_t from, uint32_t to, double tolerance) const {
  const Vec2 &a = vertices_[from], &b = vertices_[to];
  const double length = glm::distance(a, b);
  const Vec2 along = (b - a) / length;
  const Vec2 low = glm::min(a, b) - tolerance, high = glm::max(a, b) + tolerance;
  std::vector<std::pair<double, uint32_t>> found;
  for (uint32_t row = RowOf(low.y); row <= RowOf(high.y); ++row) {
    const uint32_t first = row * columns_;
    const uint32_t end = starts_[first + ColumnOf(high.x) + 1];
    for (uint32_t i = starts_[first + ColumnOf(low.x)]; i < end; ++i) {
      const Vec2 offset = vertices_[numbers_[i]] - a;
      const double t = glm::dot(offset, along);
      if (numbers_[i] == from || numbers_[i] == to || t <= 0 || t >= length) continue;
      if (std::abs(Cross(along, offset)) <= tolerance) found.emplace_back(t, numbers_[i]);
    }
  }
  std::sort(found.begin(), found.end());
  std::vector<uint32_t> numbers;
  numbers.reserve(found.size());
  for (const auto& [t, number] : found) numbers.push_back(number);
  return numbers;
}

}  // namespace parti::grammar
