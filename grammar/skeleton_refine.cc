#include "grammar/skeleton_refine.h"

#include <algorithm>
#include <glm/matrix.hpp>
#include <numeric>
#include <utility>

namespace parti::grammar {
namespace {

/// Nodes nearer than this many cells along an edge, once they are where the edges say, are one.
constexpr double kJoinCells = 2;
/// Nodes move by at most this many cells.
constexpr double kMoveCells = 2000;
/// Weights of staying where one is, against 1 for each plane: the first by which a node does not
/// move too far. Along nearly parallel fronts it is badly determined, and stays.
constexpr double kHolds[] = {1e-7, 1e-4, 1e-1};

constexpr int kRounds = 3;

/// The plane that an edge sweeps: distance = dot(inward, p) - offset.
struct Front {
  Vec2 inward;
  double offset;
};

std::vector<Front> FrontsOf(const Polygon& polygon, const Vec2& origin) {
  std::vector<Front> fronts;
  const auto add = [&](const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
      const Vec2 along = glm::normalize(b - a);
      const Vec2 inward(-along.y, along.x);
      fronts.push_back({inward, (glm::dot(inward, a) + glm::dot(inward, b)) / 2});
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return fronts;
}

std::vector<Vec2> CornersOf(const Polygon& polygon) {
  std::vector<Vec2> corners = polygon.outer;
  for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
  return corners;
}

/// Which node stands for each.
class Groups {
 public:
  explicit Groups(size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  uint32_t Of(uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void Join(uint32_t a, uint32_t b) { parent_[std::max(Of(a), Of(b))] = std::min(Of(a), Of(b)); }

 private:
  std::vector<uint32_t> parent_;
};

/// Joins the ends of short edges inside, and drops the repetitions from the faces.
void JoinNodes(size_t corners, double nearer_than, Skeleton* skeleton) {
  Groups groups(skeleton->nodes.size());
  for (const auto& face : skeleton->faces) {
    for (size_t i = 0; i < face.size(); ++i) {
      const uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (a < corners || b < corners) continue;
      const SkeletonNode &u = skeleton->nodes[a], &v = skeleton->nodes[b];
      if (glm::distance(u.at, v.at) <= nearer_than) groups.Join(a, b);
    }
  }
  for (auto& face : skeleton->faces) {
    for (uint32_t& i : face) i = groups.Of(i);
    face.erase(std::unique(face.begin(), face.end()), face.end());
  }
}

std::vector<std::vector<uint32_t>> FacesAtNodes(const Skeleton& skeleton) {
  std::vector<std::vector<uint32_t>> faces(skeleton.nodes.size());
  for (size_t f = 0; f < skeleton.faces.size(); ++f) {
    for (const uint32_t i : skeleton.faces[f]) faces[i].push_back(static_cast<uint32_t>(f));
  }
  return faces;
}

/// The step from (at, distance) that best fits the fronts; (x, y, distance).
Vec3 StepTo(const std::vector<Front>& fronts, const std::vector<uint32_t>& meeting, const Vec2& at,
            double distance, double hold) {
  glm::dmat3 normal(hold);
  Vec3 right(0, 0, 0);
  for (const uint32_t f : meeting) {
    const Vec3 row(fronts[f].inward, -1);
    const double off = distance - (glm::dot(fronts[f].inward, at) - fronts[f].offset);
    normal += glm::outerProduct(row, row);
    right += row * off;
  }
  return glm::inverse(normal) * right;
}

/// Moves each node inside to where the fronts of its faces meet.
void MoveNodes(const std::vector<Front>& fronts, const Vec2& origin, size_t corners,
               double furthest, Skeleton* skeleton) {
  const auto meeting = FacesAtNodes(*skeleton);
  for (size_t i = corners; i < skeleton->nodes.size(); ++i) {
    SkeletonNode& node = skeleton->nodes[i];
    if (meeting[i].size() < 3) continue;
    for (const double hold : kHolds) {
      Vec2 at = node.at - origin;
      double distance = node.distance_m;
      for (int round = 0; round < kRounds; ++round) {
        const Vec3 step = StepTo(fronts, meeting[i], at, distance, hold);
        at += Vec2(step);
        distance += step.z;
      }
      if (!(glm::distance(at + origin, node.at) <= furthest)) continue;
      node = {at + origin, distance};
      break;
    }
  }
}

}  // namespace

void Refine(const Polygon& polygon, double grid_m, Skeleton* skeleton) {
  const std::vector<Vec2> corners = CornersOf(polygon);
  for (size_t i = 0; i < corners.size(); ++i) skeleton->nodes[i].at = corners[i];
  // Near the origin: map coordinates would cost the sums their digits.
  const Vec2 origin = corners[0];
  const std::vector<Front> fronts = FrontsOf(polygon, origin);
  MoveNodes(fronts, origin, corners.size(), kMoveCells * grid_m, skeleton);
  JoinNodes(corners.size(), kJoinCells * grid_m, skeleton);
  MoveNodes(fronts, origin, corners.size(), kJoinCells * grid_m, skeleton);
}

}  // namespace parti::grammar
