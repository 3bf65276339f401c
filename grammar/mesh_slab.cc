// Cutting closed meshes by planes of one coordinate (Slab), with caps.
//
// As in polygon_slab.cc, corners on the cut count as outside, and each face is cut on its own into
// chains that are joined along the cut. New points are made once per mesh edge, so that neighbours
// share them and the mesh stays closed. What a face gained along the cut, run backwards, is the
// border of the cap. Open meshes get no caps: what a face gained bounds nothing there.
#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "grammar/mesh.h"
#include "grammar/mesh_edges.h"
#include "grammar/polygon_nesting.h"

namespace parti::grammar {
namespace {

using Loop = std::vector<uint32_t>;
using DirectedEdge = std::pair<uint32_t, uint32_t>;
constexpr uint32_t kNone = UINT32_MAX;

/// Kept are the points with sign * coordinate < sign * at.
struct Cut {
  int axis;
  double at;
  double sign;

  double Depth(const Vec3& p) const { return sign * (at - p[axis]); }
  Vec3 Outward() const {
    Vec3 v(0, 0, 0);
    v[axis] = sign;
    return v;
  }
};

/// In-plane coordinates in which loops that are counter-clockwise seen from outside stay so.
struct Flat {
  Vec3 u, v;
  explicit Flat(const Vec3& normal) {
    const Vec3 helper = std::abs(normal.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    u = glm::normalize(glm::cross(helper, normal));
    v = glm::cross(normal, u);
  }
  Ring Of(const std::vector<Vec3>& points, const Loop& loop) const {
    Ring ring;
    for (const uint32_t i : loop) ring.emplace_back(glm::dot(points[i], u), glm::dot(points[i], v));
    return ring;
  }
};

/// Loops to faces: outlines with the holes that lie in them. Rings travel with their loops by
/// corner number, so that faces share points by index.
std::vector<MeshFace> FacesFrom(const std::vector<Vec3>& points, const Vec3& normal,
                                std::vector<Loop> outlines, std::vector<Loop> holes) {
  std::vector<MeshFace> faces;
  faces.reserve(outlines.size());
  for (Loop& outline : outlines) faces.push_back({std::move(outline), {}, 0});
  if (holes.empty()) return faces;
  if (faces.size() == 1) {
    faces[0].holes = std::move(holes);
    return faces;
  }
  const Flat flat(normal);
  std::vector<Polygon> flat_faces;
  flat_faces.reserve(faces.size());
  for (const MeshFace& face : faces) flat_faces.push_back({flat.Of(points, face.loop), {}});
  for (Loop& hole : holes) {
    const size_t owner = OutlineAround(flat.Of(points, hole), flat_faces);
    if (owner < faces.size()) faces[owner].holes.push_back(std::move(hole));
  }
  return faces;
}

class Clip {
 public:
  Clip(const Mesh& mesh, const Cut& cut, double tolerance)
      : mesh_(mesh), cut_(cut), tolerance_(tolerance), kept_(mesh.points.size(), kNone) {}

  Mesh Run() {
    result_.closed = mesh_.closed;
    for (const MeshFace& face : mesh_.faces) CutFace(face);
    if (mesh_.closed) AddCaps();
    return std::move(result_);
  }

 private:
  bool IsInside(uint32_t i) const { return cut_.Depth(mesh_.points[i]) > tolerance_; }
  bool IsOn(uint32_t i) const { return std::abs(cut_.Depth(mesh_.points[i])) <= tolerance_; }

  uint32_t Kept(uint32_t i) {
    if (kept_[i] == kNone) {
      kept_[i] = static_cast<uint32_t>(result_.points.size());
      result_.points.push_back(mesh_.points[i]);
      if (IsOn(i)) result_.points.back()[cut_.axis] = cut_.at;
    }
    return kept_[i];
  }

  /// The point where the edge from `in` to `out` meets the cut.
  uint32_t Crossing(uint32_t in, uint32_t out) {
    if (IsOn(out)) return Kept(out);
    const uint64_t key = (uint64_t{std::min(in, out)} << 32) | std::max(in, out);
    const auto [place, is_new] = crossings_.try_emplace(key, result_.points.size());
    if (is_new) {
      const Vec3 &a = mesh_.points[in], &b = mesh_.points[out];
      const double t = cut_.Depth(a) / (cut_.Depth(a) - cut_.Depth(b));
      result_.points.push_back(a + (b - a) * t);
      result_.points.back()[cut_.axis] = cut_.at;
    }
    return place->second;
  }

  /// Cuts a loop into chains; false: it lies inside as a whole.
  bool AddLoop(const Loop& loop, std::vector<Loop>* chains) {
    const size_t n = loop.size();
    const auto outside =
        std::find_if(loop.begin(), loop.end(), [&](uint32_t i) { return !IsInside(i); });
    if (outside == loop.end()) return false;
    const auto start = static_cast<size_t>(outside - loop.begin());
    for (size_t k = 1; k <= n; ++k) {
      const uint32_t before = loop[(start + k - 1) % n], here = loop[(start + k) % n];
      if (IsInside(here) && !IsInside(before)) chains->push_back({Crossing(here, before)});
      if (IsInside(here)) chains->back().push_back(Kept(here));
      if (!IsInside(here) && IsInside(before)) chains->back().push_back(Crossing(before, here));
    }
    return true;
  }

  /// The number of a face's paint in the result, which has only those that its faces wear.
  uint32_t KeptPaint(uint32_t paint) {
    if (paint == 0) return 0;
    const auto [place, is_new] = paints_.try_emplace(paint, result_.paints.size() + 1);
    if (is_new) result_.paints.push_back(mesh_.paints[paint - 1]);
    return place->second;
  }

  Loop KeptLoop(const Loop& loop) {
    Loop kept;
    kept.reserve(loop.size());
    for (const uint32_t i : loop) kept.push_back(Kept(i));
    return kept;
  }

  /// Joins chains along the cut into loops; what they gain there is owed to the cap.
  std::vector<Loop> Join(const std::vector<Loop>& chains, const Vec3& normal) {
    const Vec3 along = glm::cross(normal, cut_.Outward());
    const auto position = [&](uint32_t i) { return glm::dot(result_.points[i], along); };
    const size_t n = chains.size();
    std::vector<size_t> by_exit(n), by_entry(n), next(n);
    for (size_t i = 0; i < n; ++i) by_exit[i] = by_entry[i] = i;
    std::stable_sort(by_exit.begin(), by_exit.end(), [&](size_t a, size_t b) {
      return position(chains[a].back()) < position(chains[b].back());
    });
    std::stable_sort(by_entry.begin(), by_entry.end(), [&](size_t a, size_t b) {
      return position(chains[a].front()) < position(chains[b].front());
    });
    for (size_t i = 0; i < n; ++i) next[by_exit[i]] = by_entry[i];
    std::vector<bool> used(n, false);
    std::vector<Loop> loops;
    for (size_t first = 0; first < n; ++first) {
      if (used[first]) continue;
      Loop loop;
      for (size_t i = first; !used[i]; i = next[i]) {
        used[i] = true;
        loop.insert(loop.end(), chains[i].begin(), chains[i].end());
        const uint32_t exit = chains[i].back(), entry = chains[next[i]].front();
        if (exit != entry) cap_edges_.emplace_back(entry, exit);
        if (exit == entry) loop.pop_back();
      }
      loops.push_back(std::move(loop));
    }
    return loops;
  }

  void CutFace(const MeshFace& face) {
    std::vector<Loop> chains, outlines, holes;
    if (!AddLoop(face.loop, &chains)) outlines.push_back(KeptLoop(face.loop));
    for (const Loop& hole : face.holes) {
      if (!AddLoop(hole, &chains)) holes.push_back(KeptLoop(hole));
    }
    if (!chains.empty()) {
      const Vec3 normal = Normal(mesh_, face);
      Vec3 direction = BottomDirection(normal);
      if (direction == Vec3(0, 0, 0)) {
        direction = glm::normalize(mesh_.points[face.loop[1]] - mesh_.points[face.loop[0]]);
      }
      for (Loop& loop : Join(chains, normal)) {
        StartAlong(result_.points, direction, &loop);
        outlines.push_back(std::move(loop));
      }
    }
    if (outlines.empty()) return;
    for (MeshFace& part :
         FacesFrom(result_.points, Normal(mesh_, face), std::move(outlines), std::move(holes))) {
      part.paint = KeptPaint(face.paint);
      result_.faces.push_back(std::move(part));
    }
  }

  /// Where two faces meet in the cut itself (a ridge that touches it), what they owe cancels.
  void CancelOpposites() {
    std::sort(cap_edges_.begin(), cap_edges_.end());
    std::vector<bool> gone(cap_edges_.size(), false);
    for (size_t i = 0; i < cap_edges_.size(); ++i) {
      if (gone[i]) continue;
      const DirectedEdge opposite(cap_edges_[i].second, cap_edges_[i].first);
      auto at = std::lower_bound(cap_edges_.begin(), cap_edges_.end(), opposite);
      while (at != cap_edges_.end() && *at == opposite &&
             gone[static_cast<size_t>(at - cap_edges_.begin())]) {
        ++at;
      }
      if (at == cap_edges_.end() || *at != opposite) continue;
      gone[i] = gone[static_cast<size_t>(at - cap_edges_.begin())] = true;
    }
    std::vector<DirectedEdge> left;
    for (size_t i = 0; i < cap_edges_.size(); ++i) {
      if (!gone[i]) left.push_back(cap_edges_[i]);
    }
    cap_edges_ = std::move(left);
  }

  /// The unused edge from `at` that bounds the same region as the edge arriving from `from`: the
  /// first one clockwise from where it came. Parts of a cap that touch stay apart that way.
  size_t NextEdge(uint32_t from, uint32_t at, const Flat& flat, const std::vector<bool>& used) {
    const auto first = std::lower_bound(cap_edges_.begin(), cap_edges_.end(), DirectedEdge(at, 0));
    size_t best = SIZE_MAX;
    double best_turn = 0;
    const Ring back = flat.Of(result_.points, {at, from});
    for (auto i = first; i != cap_edges_.end() && i->first == at; ++i) {
      const auto number = static_cast<size_t>(i - cap_edges_.begin());
      if (used[number]) continue;
      const Ring out = flat.Of(result_.points, {at, i->second});
      const Vec2 a = back[1] - back[0], b = out[1] - out[0];
      double turn = -std::atan2(Cross(a, b), glm::dot(a, b));
      if (turn <= 0) turn += 2 * kPi;
      if (best != SIZE_MAX && turn >= best_turn) continue;
      best = number;
      best_turn = turn;
    }
    return best;
  }

  void AddCaps() {
    CancelOpposites();
    const Vec3 normal = cut_.Outward();
    const Flat flat(normal);
    std::vector<bool> used(cap_edges_.size(), false);
    std::vector<Loop> outlines, holes;
    for (size_t first = 0; first < cap_edges_.size(); ++first) {
      if (used[first]) continue;
      Loop loop;
      for (size_t i = first; i != SIZE_MAX && !used[i];) {
        used[i] = true;
        loop.push_back(cap_edges_[i].first);
        i = NextEdge(cap_edges_[i].first, cap_edges_[i].second, flat, used);
      }
      (SignedArea(flat.Of(result_.points, loop)) >= 0 ? outlines : holes)
          .push_back(std::move(loop));
    }
    Vec3 direction = BottomDirection(normal);
    if (direction == Vec3(0, 0, 0)) direction = Vec3(cut_.sign, 0, 0);
    for (Loop& loop : outlines) StartAlong(result_.points, direction, &loop);
    for (MeshFace& cap : FacesFrom(result_.points, normal, std::move(outlines), std::move(holes))) {
      result_.faces.push_back(std::move(cap));
    }
  }

  const Mesh& mesh_;
  Cut cut_;
  double tolerance_;
  std::vector<uint32_t> kept_;
  std::unordered_map<uint64_t, uint32_t> crossings_;
  std::unordered_map<uint32_t, uint32_t> paints_;  ///< numbers in the mesh, in the result
  std::vector<DirectedEdge> cap_edges_;
  Mesh result_;
};

struct Extent {
  double low, high;
};

Extent ExtentOf(const Mesh& mesh, int axis) {
  Extent extent{mesh.points[0][axis], mesh.points[0][axis]};
  for (const Vec3& p : mesh.points) {
    extent.low = std::min(extent.low, p[axis]);
    extent.high = std::max(extent.high, p[axis]);
  }
  return extent;
}

}  // namespace

Mesh Slab(const Mesh& mesh, int axis, double low, double high) {
  if (mesh.faces.empty() || !(high > low)) return {};
  const Extent extent = ExtentOf(mesh, axis);
  const double tolerance = CutTolerance(extent.high - extent.low);
  if (low >= extent.high - tolerance || high <= extent.low + tolerance) return {};
  const bool cuts_low = low > extent.low + tolerance, cuts_high = high < extent.high - tolerance;
  const auto without_low = [&] { return Clip(mesh, {axis, low, -1.0}, tolerance).Run(); };
  if (!cuts_high) return cuts_low ? without_low() : mesh;
  const Cut top{axis, high, 1.0};
  if (!cuts_low) return Clip(mesh, top, tolerance).Run();
  const Mesh rest = without_low();
  return Clip(rest, top, tolerance).Run();
}

}  // namespace parti::grammar
