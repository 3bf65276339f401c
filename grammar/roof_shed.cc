// Shed roofs: one plane over everything, and walls up to it.
#include <algorithm>
#include <utility>

#include "grammar/roof_plan.h"

namespace parti::grammar {
namespace {

/// Corners that the plane passes nearer than this share of the roof's height are on the ground.
constexpr double kOnGround = 1e-9;

class Shed {
 public:
  explicit Shed(const Polygon& polygon) : polygon_(polygon) {
    Add(polygon.outer);
    for (const Ring& hole : polygon.holes) Add(hole);
  }

  /// How far the corners lie behind the line of the edge, from the foremost on.
  double MeasureFrom(size_t edge) {
    const Ring& ring = polygon_.outer;
    const Vec2 along = glm::normalize(ring[(edge + 1) % ring.size()] - ring[edge]);
    double low = 0, high = 0;
    for (const Vec3& p : mesh_.points) {
      depth_.push_back(Cross(along, Vec2(p) - ring[edge]));
      low = std::min(low, depth_.back());
      high = std::max(high, depth_.back());
    }
    for (double& depth : depth_) depth -= low;
    return high - low;
  }

  Mesh Raise(double slope, double deepest) {
    const size_t count = mesh_.points.size();
    for (size_t i = 0; i < count; ++i) {
      const Vec3& p = mesh_.points[i];
      const bool grounded = depth_[i] <= kOnGround * deepest;
      above_.push_back(static_cast<uint32_t>(grounded ? i : mesh_.points.size()));
      if (!grounded) mesh_.points.emplace_back(p.x, p.y, slope * depth_[i]);
    }
    mesh_.faces.push_back(BottomOf(polygon_));
    MeshFace top;
    size_t first = 0;
    top.loop = LoopAbove(&first, polygon_.outer.size());
    for (const Ring& hole : polygon_.holes) top.holes.push_back(LoopAbove(&first, hole.size()));
    mesh_.faces.push_back(std::move(top));
    first = 0;
    AddWalls(&first, polygon_.outer.size());
    for (const Ring& hole : polygon_.holes) AddWalls(&first, hole.size());
    return std::move(mesh_);
  }

 private:
  void Add(const Ring& ring) {
    for (const Vec2& p : ring) mesh_.points.emplace_back(p, 0);
  }

  std::vector<uint32_t> LoopAbove(size_t* first, size_t count) const {
    const auto begin = above_.begin() + static_cast<std::ptrdiff_t>(*first);
    *first += count;
    return {begin, begin + static_cast<std::ptrdiff_t>(count)};
  }

  void AddWalls(size_t* first, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      const auto a = static_cast<uint32_t>(*first + i);
      const auto b = static_cast<uint32_t>(*first + (i + 1) % count);
      if (above_[a] == a && above_[b] == b) continue;
      std::vector<uint32_t> loop = {a, b};
      if (above_[b] != b) loop.push_back(above_[b]);
      if (above_[a] != a) loop.push_back(above_[a]);
      mesh_.faces.push_back({std::move(loop), {}});
    }
    *first += count;
  }

  const Polygon& polygon_;
  Mesh mesh_;
  std::vector<double> depth_;
  std::vector<uint32_t> above_;  ///< the point over a corner; the corner itself on the ground
};

}  // namespace

Result<Mesh> ShedRoof(const Polygon& polygon, const RoofPitch& pitch, size_t low_edge) {
  Shed shed(polygon);
  const double deepest = shed.MeasureFrom(low_edge);
  const auto slope = SlopeOf(pitch, deepest);
  if (!slope) return Fail(slope);
  return shed.Raise(*slope, deepest);
}

}  // namespace parti::grammar
