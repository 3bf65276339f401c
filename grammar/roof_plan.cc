#include "grammar/roof_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "grammar/lexer.h"

namespace parti::grammar {
namespace {

using Loop = std::vector<uint32_t>;
/// Planes that differ by less, at the points of both faces, are one; m per metre of the extent.
constexpr double kSamePlane = 5e-7;

Loop ReversedLoop(size_t first, size_t count) {
  Loop loop(count);
  for (size_t i = 0; i < count; ++i) loop[i] = static_cast<uint32_t>(first + (count - i) % count);
  std::rotate(loop.begin(), loop.end() - 1, loop.end());
  return loop;
}

Vec3 NormalOf(const std::vector<Vec3>& points, const Loop& loop) {
  Vec3 sum(0, 0, 0);
  for (size_t i = 2; i < loop.size(); ++i) {
    sum += glm::cross(points[loop[i - 1]] - points[loop[0]], points[loop[i]] - points[loop[0]]);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : sum;
}

/// Whether all points of b lie in the plane of a, and it looks the same way.
bool InOnePlane(const std::vector<Vec3>& points, const Loop& a, const Loop& b, double tolerance) {
  const Vec3 normal = NormalOf(points, a);
  if (glm::dot(normal, NormalOf(points, b)) < 0.5) return false;
  return std::all_of(b.begin(), b.end(), [&](uint32_t i) {
    return std::abs(glm::dot(normal, points[i] - points[a[0]])) <= tolerance;
  });
}

/// Two loops that share edges as one; empty where that would be more than one loop, or touch
/// itself.
Loop Joined(const Loop& a, const Loop& b) {
  std::map<std::pair<uint32_t, uint32_t>, bool> edges;
  for (const Loop* loop : {&a, &b}) {
    for (size_t i = 0; i < loop->size(); ++i) {
      const uint32_t from = (*loop)[i], to = (*loop)[(i + 1) % loop->size()];
      if (edges.erase({to, from}) == 0) edges[{from, to}] = true;
    }
  }
  std::map<uint32_t, uint32_t> next;
  for (const auto& [edge, unused] : edges) {
    if (!next.emplace(edge.first, edge.second).second) return {};
  }
  Loop joined;
  for (uint32_t at = a[0]; next.count(at) == 1;) {
    joined.push_back(at);
    const uint32_t to = next[at];
    next.erase(at);
    at = to;
  }
  return next.empty() ? joined : Loop();
}

double ExtentOf(const std::vector<Vec3>& points) {
  Vec3 low = points[0], high = low;
  for (const Vec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(high - low);
}

/// Joins faces in one plane that share an edge, into the first of them.
void JoinFaces(const std::vector<Vec3>& points, std::vector<Loop>* faces) {
  const double tolerance = kSamePlane * ExtentOf(points);
  std::map<std::pair<uint32_t, uint32_t>, size_t> owner;
  const auto own = [&](size_t f) {
    const Loop& loop = (*faces)[f];
    for (size_t i = 0; i < loop.size(); ++i) owner[{loop[i], loop[(i + 1) % loop.size()]}] = f;
  };
  for (size_t f = 0; f < faces->size(); ++f) own(f);
  for (size_t f = 0; f < faces->size(); ++f) {
    for (size_t i = 0; i < (*faces)[f].size(); ++i) {
      const Loop& loop = (*faces)[f];
      const auto other = owner.find({loop[(i + 1) % loop.size()], loop[i]});
      if (other == owner.end() || other->second <= f) continue;
      const size_t g = other->second;
      if ((*faces)[g].empty() || !InOnePlane(points, loop, (*faces)[g], tolerance)) continue;
      Loop joined = Joined(loop, (*faces)[g]);
      if (joined.empty()) continue;
      (*faces)[f] = std::move(joined);
      (*faces)[g].clear();
      own(f);
      i = static_cast<size_t>(-1);  // its edges are others now
    }
  }
}

/// Leaves out the points that no face names.
void DropUnused(Mesh* mesh) {
  constexpr uint32_t kUnused = UINT32_MAX;
  std::vector<uint32_t> number(mesh->points.size(), kUnused);
  std::vector<Vec3> kept;
  const auto renumber = [&](Loop* loop) {
    for (uint32_t& i : *loop) {
      if (number[i] == kUnused) {
        number[i] = static_cast<uint32_t>(kept.size());
        kept.push_back(mesh->points[i]);
      }
      i = number[i];
    }
  };
  for (MeshFace& face : mesh->faces) {
    renumber(&face.loop);
    for (Loop& hole : face.holes) renumber(&hole);
  }
  mesh->points = std::move(kept);
}

}  // namespace

Result<double> SlopeOf(const RoofPitch& pitch, double furthest_m) {
  if (pitch.by_height) {
    const double slope = pitch.value / furthest_m;
    if (pitch.value > kLengthTolerance_m && std::isfinite(slope)) return slope;
    return Fail(ErrorCode::kBadNumber, fmt::format("a roof is {} m high", RoundedText(pitch.value)),
                "give a height above 0");
  }
  if (pitch.value >= kFlattestRoof_deg && pitch.value <= kSteepestRoof_deg) {
    return std::tan(Angle::Degrees(pitch.value).radians());
  }
  return Fail(
      ErrorCode::kBadNumber, fmt::format("a roof rises by {} degrees", RoundedText(pitch.value)),
      fmt::format("give an angle from {:g} to {:g} degrees", kFlattestRoof_deg, kSteepestRoof_deg));
}

double Furthest(const Skeleton& skeleton) {
  double furthest = 0;
  for (const auto& face : skeleton.faces) {
    for (const uint32_t i : face) furthest = std::max(furthest, skeleton.nodes[i].distance_m);
  }
  return furthest;
}

RoofPlan Lifted(Skeleton skeleton, double slope, double lowered_m) {
  RoofPlan plan;
  plan.polygon = std::move(skeleton.polygon);
  plan.points.reserve(skeleton.nodes.size());
  for (const SkeletonNode& node : skeleton.nodes) {
    plan.points.emplace_back(node.at, slope * (node.distance_m - lowered_m));
  }
  plan.faces = std::move(skeleton.faces);
  return plan;
}

MeshFace BottomOf(const Polygon& polygon) {
  MeshFace bottom{ReversedLoop(0, polygon.outer.size()), {}};
  size_t first = polygon.outer.size();
  for (const Ring& hole : polygon.holes) {
    bottom.holes.push_back(ReversedLoop(first, hole.size()));
    first += hole.size();
  }
  return bottom;
}

Mesh MeshOf(const RoofPlan& plan) {
  Mesh mesh;
  mesh.points = plan.points;
  mesh.faces.push_back(BottomOf(plan.polygon));
  std::vector<Loop> faces = plan.faces;
  JoinFaces(plan.points, &faces);
  for (Loop& loop : faces) {
    if (loop.size() >= 3) mesh.faces.push_back({std::move(loop), {}});
  }
  DropUnused(&mesh);
  return mesh;
}

}  // namespace parti::grammar
