#include "grammar/query_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "grammar/query_volume.h"
#include "grammar/triangle_distance.h"

namespace parti::grammar {
namespace {

constexpr double kNear = kRegionTolerance_m;

/// Of its surface; a niche's is that of the space that it takes.
std::vector<Triangle> TrianglesOf(Item item) {
  item.hollow = false;
  std::vector<Vec3> corners;
  grammar::TrianglesOf(item, &corners);
  std::vector<Triangle> triangles;
  triangles.reserve(corners.size() / 3);
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  }
  // Something without area still stands somewhere.
  if (triangles.empty())
    triangles.push_back({item.scope.origin, item.scope.origin, item.scope.origin});
  return triangles;
}

Vec3 MiddleOf(const Scope& scope) { return scope.ToWorld(scope.size * 0.5); }

/// A shape made ready to be compared with others.
struct Body {
  ShapeIndex shape;
  bool solid;
  Scope scope;
  std::vector<Triangle> triangles;
  Box3 bounds;

  Body(ShapeIndex i, const Item& item)
      : shape(i),
        solid(item.type == ItemType::kVolume),
        scope(item.scope),
        triangles(TrianglesOf(item)),
        bounds(BoundsOf(triangles)) {}

  double DistanceTo(const Vec3& point) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Triangle& t : triangles) {
      best = std::min(best, glm::distance(NearestOn(t, point), point));
    }
    return best;
  }
  /// A solid's inside and surface; a face itself.
  bool Contains(const Vec3& point) const {
    if (Distance(bounds, {point, point}) > kNear) return false;
    return DistanceTo(point) <= kNear || (solid && WindingNumber(triangles, point) > 0.5);
  }
  /// The smallest distance of both surfaces; gives up, with a larger number, beyond `most`.
  double DistanceTo(const Body& other, double most) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Triangle& a : triangles) {
      if (Distance(BoundsOf({a}), other.bounds) > most) continue;
      for (const Triangle& b : other.triangles) {
        best = std::min(best, Distance(a, b));
        if (best <= 0) return best;
      }
    }
    return best;
  }
};

bool IsInside(const Body& body, const Body& other) {
  for (const Triangle& t : body.triangles) {
    for (const Vec3& corner : t) {
      if (!other.Contains(corner)) return false;
    }
  }
  return true;
}

bool Intersects(const Body& a, const Body& b) {
  if (a.DistanceTo(b, kNear) <= kNear) return true;
  return b.Contains(a.triangles[0][0]) || a.Contains(b.triangles[0][0]);
}

bool Faces(const Body& body, const Vec3& facing, const Body& other) {
  const Vec3 middle = MiddleOf(body.scope);
  Vec3 way = NearestOn(other.scope, middle) - middle;
  Vec3 normal = facing;
  if (std::abs(facing.y) < std::sqrt(0.5)) {
    way.y = 0;
    normal.y = 0;
  }
  const double length = glm::length(way) * glm::length(normal);
  return length > 0 && glm::dot(way, normal) >= length * std::cos(kFacing.radians()) - kNear;
}

/// The shapes that an inner query selected, by the x at which they start.
class Bodies {
 public:
  Bodies(const ShapeTree& tree, const std::vector<ShapeIndex>& shapes) {
    for (const ShapeIndex i : shapes) bodies_.emplace_back(i, tree[i].item);
    std::stable_sort(bodies_.begin(), bodies_.end(),
                     [](const Body& a, const Body& b) { return a.bounds.low.x < b.bounds.low.x; });
    for (const Body& b : bodies_) widest_ = std::max(widest_, b.bounds.high.x - b.bounds.low.x);
  }

  /// Whether some other shape whose box is at most `metres` away passes the test.
  template <typename Test>
  bool Any(const Body& body, double metres, const Test& test) const {
    const double from = body.bounds.low.x - metres - widest_;
    const double to = body.bounds.high.x + metres;
    auto i = std::lower_bound(bodies_.begin(), bodies_.end(), from,
                              [](const Body& b, double x) { return b.bounds.low.x < x; });
    for (; i != bodies_.end() && i->bounds.low.x <= to; ++i) {
      if (i->shape == body.shape || Distance(i->bounds, body.bounds) > metres) continue;
      if (test(*i)) return true;
    }
    return false;
  }

 private:
  std::vector<Body> bodies_;
  double widest_ = 0;
};

ShapeTest VolumeTest(const Filter& filter, const ShapeTree& tree) {
  const QueryVolume volume(filter);
  const auto contains = [volume](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](const Vec3& p) { return volume.Contains(p); });
  };
  if (filter.name == "inside") {
    return [&tree, contains](ShapeIndex i) {
      const auto triangles = TrianglesOf(tree[i].item);
      return std::all_of(triangles.begin(), triangles.end(), contains);
    };
  }
  return [&tree, volume](ShapeIndex i) {
    const Body body(i, tree[i].item);
    const auto meets = [&](const Triangle& t) { return volume.Meets(t); };
    return std::any_of(body.triangles.begin(), body.triangles.end(), meets) ||
           body.Contains(volume.middle());
  };
}

ShapeTest BodiesTest(const Filter& filter, const ShapeTree& tree,
                     const std::shared_ptr<const Bodies>& bodies) {
  const std::string& name = filter.name;
  if (name == "within") {
    return [&tree, bodies, metres = filter.numbers[0] + kNear](ShapeIndex i) {
      const Body body(i, tree[i].item);
      return bodies->Any(body, metres,
                         [&](const Body& b) { return body.DistanceTo(b, metres) <= metres; });
    };
  }
  if (name == "facing") {
    return [&tree, bodies](ShapeIndex i) {
      const Vec3& facing = tree[i].item.facing;
      if (DirectionOf(facing).empty()) return false;
      const Body body(i, tree[i].item);
      return bodies->Any(body, std::numeric_limits<double>::infinity(),
                         [&](const Body& b) { return Faces(body, facing, b); });
    };
  }
  const auto test = name == "inside" ? IsInside : Intersects;
  return [&tree, bodies, test](ShapeIndex i) {
    const Body body(i, tree[i].item);
    return bodies->Any(body, kNear, [&](const Body& b) { return test(body, b); });
  };
}

}  // namespace

Result<ShapeTest> RegionTestOf(const Filter& filter, const ShapeTree& tree) {
  if (filter.name == "larger" || filter.name == "smaller") {
    const bool larger = filter.name == "larger";
    return [&tree, larger, area = filter.numbers[0]](ShapeIndex i) {
      const double own = AreaOf(tree[i].item);
      return larger ? own > area : own < area;
    };
  }
  if (!filter.volume.empty()) return VolumeTest(filter, tree);
  const auto shapes = ProductOf(filter.queries[0], tree);
  if (!shapes) return Fail(shapes);
  return BodiesTest(filter, tree, std::make_shared<const Bodies>(tree, *shapes));
}

}  // namespace parti::grammar
