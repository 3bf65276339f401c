#include "app/weld.h"

#include <cmath>

namespace parti::app {
namespace {

/// Beyond this, 10 micrometres are less than a double's last digits. [m]
constexpr double kFarthest_m = 1e9;

bool IsWeldable(const Vec3& p) {
  return std::abs(p.x) < kFarthest_m && std::abs(p.y) < kFarthest_m && std::abs(p.z) < kFarthest_m;
}

/// Points lie in cells as wide as kWeld_m, so that a point's neighbours are in its own or in one of
/// the 26 around it; 16 cells in each direction are a block, and mostly all 27 are in the same one.
/// The table holds blocks. Where a block ends is chosen so that round numbers (whole millimetres
/// are whole multiples of 4 cells, or rounded to just below) lie inside.
int64_t BlockOf(int64_t cell) { return (cell + 14) >> 4; }

}  // namespace

Welder::Cell Welder::CellOf(const Vec3& p) {
  const auto part = [](double v) { return static_cast<int64_t>(std::floor(v / kWeld_m)); };
  return {part(p.x), part(p.y), part(p.z)};
}

uint64_t Welder::HashOf(const Cell& block) {
  uint64_t hash = 0;
  for (const int64_t part : block) hash = IndexTable::Mixed(hash, static_cast<uint64_t>(part));
  return hash;
}

/// Where several points are near, the one in the first cell wins (x runs fastest, then y), and the
/// latest in it; that is what `rank` compares.
void Welder::Search(const Cell& block, const Cell& home, const Vec3& p, int* rank,
                    uint32_t* found) const {
  for (uint32_t i = table_.First(HashOf(block)); i != IndexTable::kNone; i = table_.Next(i)) {
    const Vec3& q = part_.points[i];
    if (!(glm::length(q - p) <= kWeld_m)) continue;
    const Cell cell = CellOf(q);
    int at = 0;
    bool is_beside = true;
    for (int axis = 2; axis >= 0; --axis) {
      const int64_t step = cell[axis] - home[axis];
      is_beside = is_beside && std::abs(step) <= 1;
      at = 3 * at + static_cast<int>(step) + 1;
    }
    if (!is_beside || at >= *rank) continue;
    *rank = at;
    *found = i;
  }
}

/// The number of the point that `p` is welded to; it becomes one where there is none.
uint32_t Welder::IndexOf(const Vec3& p) {
  const Cell home = CellOf(p);
  const Cell block = {BlockOf(home[0]), BlockOf(home[1]), BlockOf(home[2])};
  const uint64_t hash = HashOf(block);
  // A point has no other within kWeld_m, or it would not have become one: nothing goes before it.
  for (uint32_t i = table_.First(hash); i != IndexTable::kNone; i = table_.Next(i)) {
    if (part_.points[i] == p) return i;
  }
  int rank = 27;
  uint32_t found = IndexTable::kNone;
  for (int64_t z = BlockOf(home[2] - 1); z <= BlockOf(home[2] + 1); ++z) {
    for (int64_t y = BlockOf(home[1] - 1); y <= BlockOf(home[1] + 1); ++y) {
      for (int64_t x = BlockOf(home[0] - 1); x <= BlockOf(home[0] + 1); ++x) {
        Search({x, y, z}, home, p, &rank, &found);
      }
    }
  }
  if (found != IndexTable::kNone) return found;
  part_.points.push_back(p);
  table_.Add(hash);
  return static_cast<uint32_t>(part_.points.size() - 1);
}

const WeldedPart& Welder::Weld(const std::vector<Vec3>& corners) {
  part_.points.clear();
  part_.triangles.clear();
  part_.normals.clear();
  part_.sources.clear();
  table_.Reset(corners.size() / 2);
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vec3* p = &corners[i];
    if (!IsWeldable(p[0]) || !IsWeldable(p[1]) || !IsWeldable(p[2])) continue;
    std::array<uint32_t, 3> at{};
    for (int k = 0; k < 3; ++k) at[k] = IndexOf(p[k]);
    const auto& q = part_.points;
    const Vec3 normal = glm::cross(q[at[1]] - q[at[0]], q[at[2]] - q[at[0]]);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    part_.triangles.insert(part_.triangles.end(), at.begin(), at.end());
    part_.normals.push_back(normal / length);
    part_.sources.push_back(static_cast<uint32_t>(i / 3));
  }
  return part_;
}

WeldedPart Weld(const std::vector<Vec3>& corners) { return Welder().Weld(corners); }

}  // namespace parti::app
