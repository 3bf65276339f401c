#include "grammar/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parti::grammar {
namespace {

Segment3 Edge(const Triangle& t, size_t i) { return {t[i], t[(i + 1) % 3]}; }

/// Twice the area, along the normal.
Vec3 AreaVector(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

/// Whether p, projected along the normal, falls into the triangle.
bool Covers(const Triangle& t, const Vec3& normal, const Vec3& p) {
  for (size_t i = 0; i < 3; ++i) {
    const Segment3 edge = Edge(t, i);
    if (glm::dot(glm::cross(edge.b - edge.a, p - edge.a), normal) < 0) return false;
  }
  return true;
}

}  // namespace

Box3 BoundsOf(const std::vector<Triangle>& triangles) {
  Box3 box{triangles.front()[0], triangles.front()[0]};
  for (const Triangle& t : triangles) {
    for (const Vec3& p : t) {
      box.low = glm::min(box.low, p);
      box.high = glm::max(box.high, p);
    }
  }
  return box;
}

double Distance(const Box3& a, const Box3& b) {
  const Vec3 gap = glm::max(Vec3(0), glm::max(a.low - b.high, b.low - a.high));
  return glm::length(gap);
}

Vec3 NearestOn(const Segment3& segment, const Vec3& point) {
  const Vec3 along = segment.b - segment.a;
  const double squared = glm::dot(along, along);
  if (!(squared > 0)) return segment.a;
  const double t = std::clamp(glm::dot(point - segment.a, along) / squared, 0.0, 1.0);
  return segment.a + along * t;
}

Vec3 NearestOn(const Triangle& triangle, const Vec3& point) {
  const Vec3 normal = AreaVector(triangle);
  const double squared = glm::dot(normal, normal);
  if (squared > 0 && Covers(triangle, normal, point)) {
    return point - normal * (glm::dot(point - triangle[0], normal) / squared);
  }
  Vec3 nearest = triangle[0];
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < 3; ++i) {
    const Vec3 candidate = NearestOn(Edge(triangle, i), point);
    const double distance = glm::distance(candidate, point);
    if (distance >= best) continue;
    best = distance;
    nearest = candidate;
  }
  return nearest;
}

Vec3 NearestOn(const Scope& scope, const Vec3& point) {
  const Vec3 local = scope.ToLocal(point);
  return scope.ToWorld(glm::clamp(local, Vec3(0), glm::max(scope.size, Vec3(0))));
}

double Distance(const Segment3& a, const Segment3& b) {
  // The unbounded lines' nearest points, if both lie on the segments; else an end is nearest.
  const Vec3 u = a.b - a.a;
  const Vec3 v = b.b - b.a;
  const Vec3 w = a.a - b.a;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
  const double denominator = uu * vv - uv * uv;
  double best =
      std::min({glm::distance(a.a, NearestOn(b, a.a)), glm::distance(a.b, NearestOn(b, a.b)),
                glm::distance(b.a, NearestOn(a, b.a)), glm::distance(b.b, NearestOn(a, b.b))});
  if (!(denominator > 1e-12 * uu * vv)) return best;  // parallel
  const double uw = glm::dot(u, w), vw = glm::dot(v, w);
  const double s = (uv * vw - vv * uw) / denominator;
  const double t = (uu * vw - uv * uw) / denominator;
  if (s < 0 || s > 1 || t < 0 || t > 1) return best;
  return std::min(best, glm::distance(a.a + u * s, b.a + v * t));
}

bool Pierces(const Segment3& segment, const Triangle& triangle) {
  const Vec3 normal = AreaVector(triangle);
  const double from = glm::dot(segment.a - triangle[0], normal);
  const double to = glm::dot(segment.b - triangle[0], normal);
  if (from * to > 0 || from == to) return false;
  const Vec3 crossing = segment.a + (segment.b - segment.a) * (from / (from - to));
  return Covers(triangle, normal, crossing);
}

double Distance(const Triangle& a, const Triangle& b) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < 3; ++i) {
    if (Pierces(Edge(a, i), b) || Pierces(Edge(b, i), a)) return 0;
    best = std::min(best, glm::distance(a[i], NearestOn(b, a[i])));
    best = std::min(best, glm::distance(b[i], NearestOn(a, b[i])));
    for (size_t j = 0; j < 3; ++j) best = std::min(best, Distance(Edge(a, i), Edge(b, j)));
  }
  return best;
}

double WindingNumber(const std::vector<Triangle>& surface, const Vec3& point) {
  double angle = 0;
  for (const Triangle& t : surface) {
    const Vec3 a = t[0] - point, b = t[1] - point, c = t[2] - point;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double numerator = glm::dot(a, glm::cross(b, c));
    const double denominator =
        la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    angle += 2 * std::atan2(numerator, denominator);
  }
  return angle / (4 * kPi);
}

}  // namespace parti::grammar
