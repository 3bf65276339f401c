// Half-plane clipping of polygons with holes (Slab). No general boolean: one coordinate decides for
// each corner, so that there is nothing to go wrong where corners lie on the cut.
//
// Corners on the cut count as outside, as if the cut lay a little before them. Each ring falls into
// chains of inside corners; a chain ends where its ring leaves (an exit) and the next starts where
// it comes back (an entry). Sorted along the cut, with the kept side on the left, exits and entries
// alternate, so that the k-th exit is joined to the k-th entry.
#include <algorithm>
#include <cstdint>

#include "grammar/polygon.h"
#include "grammar/polygon_nesting.h"

namespace parti::grammar {
namespace {

/// A half-plane by one coordinate: kept are the points with sign * coordinate < sign * cut.
struct Cut {
  int axis;
  double at;
  double sign;

  double Depth(const Vec2& p) const { return sign * (at - p[axis]); }
  /// Position along the cut line, kept side on the left.
  double Along(const Vec2& p) const {
    const double other = p[1 - axis];
    return axis == 0 ? sign * other : -sign * other;
  }
};

struct Chain {
  Ring corners;  ///< from entry to exit, both included
  bool used = false;
};

/// Where edge ab (a inside, b not) meets the cut.
Vec2 Crossing(const Cut& cut, const Vec2& a, const Vec2& b, double tolerance) {
  Vec2 p = b;
  if (cut.Depth(b) < -tolerance) {
    const double t = cut.Depth(a) / (cut.Depth(a) - cut.Depth(b));
    p = a + (b - a) * t;
  }
  p[cut.axis] = cut.at;
  return p;
}

class Clip {
 public:
  Clip(const Cut& cut, double tolerance) : cut_(cut), tolerance_(tolerance) {}

  std::vector<Polygon> Run(const Polygon& polygon) {
    std::vector<Ring> outlines, holes;
    if (!AddRing(polygon.outer)) outlines.push_back(polygon.outer);
    for (const Ring& hole : polygon.holes) {
      if (!AddRing(hole)) holes.push_back(hole);
    }
    Join(&outlines);
    for (Ring& outline : outlines) DropRepeatedCorners(&outline);
    std::erase_if(outlines, [](const Ring& ring) { return SignedArea(ring) < kAreaTolerance_m2; });
    return Nest(std::move(outlines), std::move(holes));
  }

 private:
  bool IsInside(const Vec2& p) const { return cut_.Depth(p) > tolerance_; }

  /// Cuts a ring into chains. False: it lies inside as a whole.
  bool AddRing(const Ring& ring) {
    const size_t n = ring.size();
    size_t start = n;
    for (size_t i = 0; i < n && start == n; ++i) {
      if (!IsInside(ring[i])) start = i;
    }
    if (start == n) return false;
    for (size_t k = 1; k <= n; ++k) {
      const Vec2& before = ring[(start + k - 1) % n];
      const Vec2& here = ring[(start + k) % n];
      if (IsInside(here) && !IsInside(before)) {
        chains_.push_back({{Crossing(cut_, here, before, tolerance_)}, false});
      }
      if (IsInside(here)) chains_.back().corners.push_back(here);
      if (!IsInside(here) && IsInside(before)) {
        chains_.back().corners.push_back(Crossing(cut_, before, here, tolerance_));
      }
    }
    return true;
  }

  void Join(std::vector<Ring>* outlines) {
    const size_t n = chains_.size();
    std::vector<uint32_t> by_exit(n), by_entry(n), next(n);
    for (size_t i = 0; i < n; ++i) by_exit[i] = by_entry[i] = static_cast<uint32_t>(i);
    std::stable_sort(by_exit.begin(), by_exit.end(), [&](uint32_t a, uint32_t b) {
      return cut_.Along(chains_[a].corners.back()) < cut_.Along(chains_[b].corners.back());
    });
    std::stable_sort(by_entry.begin(), by_entry.end(), [&](uint32_t a, uint32_t b) {
      return cut_.Along(chains_[a].corners.front()) < cut_.Along(chains_[b].corners.front());
    });
    for (size_t i = 0; i < n; ++i) next[by_exit[i]] = by_entry[i];
    for (uint32_t first = 0; first < n; ++first) {
      if (chains_[first].used) continue;
      Ring loop;
      for (uint32_t i = first; !chains_[i].used; i = next[i]) {
        loop.insert(loop.end(), chains_[i].corners.begin(), chains_[i].corners.end());
        chains_[i].used = true;
      }
      outlines->push_back(std::move(loop));
    }
  }

  Cut cut_;
  double tolerance_;
  std::vector<Chain> chains_;
};

}  // namespace

std::vector<Polygon> Slab(const Polygon& polygon, int axis, double low, double high) {
  if (polygon.outer.size() < 3 || !(high > low)) return {};
  const Box2 box = Bounds(polygon);
  const double tolerance = CutTolerance(box.high[axis] - box.low[axis]);
  std::vector<Polygon> pieces;
  if (low > box.low[axis] + tolerance) {
    pieces = Clip({axis, low, -1.0}, tolerance).Run(polygon);
  } else {
    pieces.push_back(polygon);
  }
  if (high >= box.high[axis] - tolerance) return pieces;
  std::vector<Polygon> result;
  for (const Polygon& piece : pieces) {
    for (Polygon& part : Clip({axis, high, 1.0}, tolerance).Run(piece)) {
      result.push_back(std::move(part));
    }
  }
  return result;
}

}  // namespace parti::grammar
