#include "grammar/query_volume.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "grammar/query_region.h"

namespace parti::grammar {
namespace {

constexpr double kNear = kRegionTolerance_m;

/// The part of a convex polygon with sign * coordinate <= sign * bound.
std::vector<Vec3> Clip(const std::vector<Vec3>& polygon, int axis, double bound, double sign) {
  std::vector<Vec3> kept;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    const double over_a = sign * (a[axis] - bound);
    const double over_b = sign * (b[axis] - bound);
    if (over_a <= 0) kept.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0)) {
      kept.push_back(a + (b - a) * (over_a / (over_a - over_b)));
    }
  }
  return kept;
}

/// The distance from a point to a convex polygon, both seen from above.
double DistanceFromAbove(const std::vector<Vec3>& polygon, const Vec3& point) {
  const auto flat = [](const Vec3& p) { return Vec3(p.x, 0, p.z); };
  double best = glm::distance(flat(polygon[0]), flat(point));
  for (size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Triangle t{flat(polygon[0]), flat(polygon[i]), flat(polygon[i + 1])};
    best = std::min(best, glm::distance(NearestOn(t, flat(point)), flat(point)));
  }
  return best;
}

}  // namespace

QueryVolume::QueryVolume(const Filter& filter) {
  const std::vector<double>& n = filter.numbers;
  CHECK(n.size() == NumbersOfVolume(filter.volume) && n.size() >= 4, "a checked volume");
  kind_ = filter.volume == "sphere" ? Kind::kSphere
          : filter.volume == "box"  ? Kind::kBox
                                    : Kind::kCylinder;
  at_ = Vec3(n[0], n[1], n[2]);
  size_ = Vec3(n[3], n.size() > 4 ? n[4] : 0, n.size() > 5 ? n[5] : 0);
}

bool QueryVolume::Contains(const Vec3& point) const {
  const Vec3 d = point - at_;
  switch (kind_) {
    case Kind::kSphere:
      return glm::length(d) <= size_.x + kNear;
    case Kind::kBox:
      return glm::all(glm::greaterThanEqual(d, Vec3(-kNear))) &&
             glm::all(glm::lessThanEqual(d, size_ + kNear));
    case Kind::kCylinder:
      break;
  }
  return std::hypot(d.x, d.z) <= size_.x + kNear && d.y >= -kNear && d.y <= size_.y + kNear;
}

bool QueryVolume::Meets(const Triangle& triangle) const {
  if (kind_ == Kind::kSphere) return Contains(NearestOn(triangle, at_));
  std::vector<Vec3> part(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3; ++axis) {
    if (kind_ == Kind::kCylinder && axis != 1) continue;
    part = Clip(part, axis, at_[axis] + size_[axis] + kNear, 1);
    part = Clip(part, axis, at_[axis] - kNear, -1);
    if (part.empty()) return false;
  }
  return kind_ == Kind::kBox || DistanceFromAbove(part, at_) <= size_.x + kNear;
}

Vec3 QueryVolume::middle() const {
  if (kind_ == Kind::kSphere) return at_;
  if (kind_ == Kind::kBox) return at_ + size_ * 0.5;
  return at_ + Vec3(0, size_.y / 2, 0);
}

}  // namespace parti::grammar
