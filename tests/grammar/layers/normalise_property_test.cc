// What holds for every scene: pieces fill the planar shape and overlap nowhere; each point belongs
// to the uppermost shape over it; order and repetition change nothing.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/grammar/layers/scene_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

/// Coordinates that often coincide: on a grid, a hair beside it, or anywhere.
double Coordinate(Random* random, double most) {
  const double pick = random->Uniform();
  const double any = random->Uniform(-0.1 * most, 1.1 * most);
  if (pick > 0.7) return any;
  const double grid = std::round(any * 2) / 2;
  return pick > 0.1 ? grid : grid + random->Uniform(-1e-12, 1e-12);
}

struct RandomScene : TestScene {
  std::vector<ShapeIndex> layers;

  explicit RandomScene(uint64_t seed) : TestScene(AnyFacade(seed)) {
    Random random(seed + 1);
    layers = Layers("layers(\"a\", \"b\", \"c\") { A | B | C }");
    const int count = 1 + static_cast<int>(random.Uniform(0, 25));
    std::vector<ShapeIndex> parents = layers;
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<size_t>(random.Uniform(0, static_cast<double>(parents.size())));
      AddAny(parents[at], &random);
      if (random.Uniform() < 0.3) parents.push_back(shapes.back());
      if (random.Uniform() < 0.1) shapes.pop_back();  // a placeholder
    }
    SortByTree();
  }

  static Item AnyFacade(uint64_t seed) {
    Random random(seed);
    if (random.Uniform() < 0.6) return Facade(10, 7);
    Polygon polygon = AnyPolygon(&random);
    std::vector<std::vector<Vec3>> rings(1);
    for (const Vec2& p : polygon.outer) rings[0].emplace_back(p.x, p.y, 0);
    for (const Ring& hole : polygon.holes) {
      rings.emplace_back();
      for (const Vec2& p : hole) rings.back().emplace_back(p.x, p.y, 0);
    }
    return PlanarFrom(rings).value();
  }

  void AddAny(ShapeIndex parent, Random* random) {
    const Vec3& size = tree[0].item.scope.size;
    const Vec2 a(Coordinate(random, size.x), Coordinate(random, size.y));
    const Vec2 b(Coordinate(random, size.x), Coordinate(random, size.y));
    const Vec2 low = glm::min(a, b), high = glm::max(a, b) + Vec2(0.01, 0.01);
    const bool fixed = random->Uniform() < 0.4;
    if (random->Uniform() < 0.6) {
      Add(parent, low, high, fixed);
    } else {
      AddPolygon(parent, Arch(low, high - low, 7), fixed);
    }
  }

  /// Depth-first order, as Normalise asks for.
  void SortByTree() {
    std::vector<ShapeIndex> order;
    for (ShapeIndex i = 0; i != kNoShape;) {
      order.push_back(i);
      ShapeIndex next = tree.node(i).first_child;
      for (ShapeIndex up = i; next == kNoShape && up != kNoShape; up = tree.node(up).parent) {
        next = tree.node(up).next_sibling;
      }
      i = next;
    }
    std::erase_if(order, [&](ShapeIndex i) {
      return std::find(shapes.begin(), shapes.end(), i) == shapes.end();
    });
    shapes = std::move(order);
  }
};

Vec2 InPlane(const Scope& frame, const Vec3& world) {
  const Vec3 local = frame.ToLocal(world);
  return {local.x, local.y};
}

/// Whether the item covers a point of the scene's plane.
bool Covers(const Item& item, const Scope& frame, const Vec2& point) {
  const Vec2 p = point - InPlane(frame, item.scope.origin);
  if (item.polygon) return Contains(*item.polygon, p);
  return p.x >= 0 && p.y >= 0 && p.x <= item.scope.size.x && p.y <= item.scope.size.y;
}

double SumOfAreas(const TestScene& scene, const std::vector<std::vector<ShapeIndex>>& pieces) {
  double sum = 0;
  for (const auto& of_shape : pieces) {
    for (const ShapeIndex i : of_shape) sum += AreaOf(scene[i]);
  }
  return sum;
}

RC_GTEST_PROP(NormaliseProperty, PiecesAndBackgroundFillThePlanarShape, (uint64_t seed)) {
  RandomScene scene(seed);
  const double whole = AreaOf(scene[0]);
  const auto pieces = scene.Normalise();
  const double sum = SumOfAreas(scene, pieces) + scene.UncoveredArea();
  RC_ASSERT(std::abs(sum - whole) < 1e-5 * whole);
}

/// Nearer to a border than this, points may belong to either side.
bool IsNearBorder(const Item& item, const Scope& frame, const Vec2& point) {
  constexpr double kNear = 1e-5;
  for (const Segment3& edge : EdgesOf(item)) {
    const Vec2 a = InPlane(frame, edge.a), b = InPlane(frame, edge.b);
    const Vec2 along = b - a;
    const double t = std::clamp(glm::dot(point - a, along) / glm::dot(along, along), 0.0, 1.0);
    if (glm::distance(point, a + along * t) < kNear) return true;
  }
  return false;
}

/// Above: a later layer, a smaller depth, later in the list.
bool LiesOver(const Item& a, size_t at_a, const Item& b, size_t at_b) {
  if (a.layer != b.layer) return a.layer > b.layer;
  return a.depth != b.depth ? a.depth < b.depth : at_a > at_b;
}

RC_GTEST_PROP(NormaliseProperty, APointBelongsToTheUppermostShapeOverIt, (uint64_t seed)) {
  RandomScene scene(seed);
  const ShapeTree before = scene.tree;
  const auto pieces = scene.Normalise();
  const Scope& frame = before[0].item.scope;
  Random random(seed + 2);
  const auto is_over = [&](ShapeIndex shape, const Vec2& point) {
    for (ShapeIndex i = shape; i != 0; i = before.node(i).parent) {
      const Item& item = before[i].item;
      if (item.type == ItemType::kShape2D && !Covers(item, frame, point)) return false;
    }
    return Covers(before[0].item, frame, point);
  };
  for (int k = 0; k < 40; ++k) {
    const Vec2 point(random.Uniform(0, frame.size.x), random.Uniform(0, frame.size.y));
    bool near = false;
    for (ShapeIndex i = 0; i < before.size() && !near; ++i) {
      near = IsNearBorder(before[i].item, frame, point);
    }
    if (near) continue;
    size_t upper = pieces.size(), owners = 0, owner = pieces.size();
    for (size_t i = 0; i < pieces.size(); ++i) {
      const auto& of_shape = pieces[i];
      const Item& item = before[scene.shapes[i]].item;
      if (!of_shape.empty() && is_over(scene.shapes[i], point) &&
          (upper == pieces.size() || LiesOver(item, i, before[scene.shapes[upper]].item, upper))) {
        upper = i;
      }
      for (const ShapeIndex piece : of_shape) {
        if (!Covers(scene[piece], frame, point)) continue;
        ++owners;
        owner = i;
      }
    }
    for (const Uncovered& free : scene.uncovered) owners += Contains(free.polygon, point) ? 1 : 0;
    RC_ASSERT(owner == upper);
    RC_ASSERT(owners == (Covers(before[0].item, frame, point) ? 1u : 0u));
  }
}

RC_GTEST_PROP(NormaliseProperty, FixedGeometryIsWholeOrGone, (uint64_t seed)) {
  RandomScene scene(seed);
  const ShapeTree before = scene.tree;
  const auto pieces = scene.Normalise();
  for (size_t i = 0; i < pieces.size(); ++i) {
    const Item& laid_out = before[scene.shapes[i]].item;
    if (!laid_out.fixed_geometry || pieces[i].empty()) continue;
    double area = 0;
    for (const ShapeIndex piece : pieces[i]) area += AreaOf(scene[piece]);
    RC_ASSERT(area <= AreaOf(laid_out) + 1e-9);
  }
}

RC_GTEST_PROP(NormaliseProperty, EqualInputGivesEqualBytes, (uint64_t seed)) {
  RandomScene a(seed), b(seed);
  RC_ASSERT(a.Normalise() == b.Normalise());
  RC_ASSERT(a.tree.size() == b.tree.size());
  for (ShapeIndex i = 0; i < a.tree.size(); ++i) {
    RC_ASSERT(a[i].scope.origin == b[i].scope.origin && a[i].scope.size == b[i].scope.size);
    if (a[i].polygon) RC_ASSERT(*a[i].polygon == *b[i].polygon);
  }
}

// Shapes of different layers may be given in any order.
RC_GTEST_PROP(NormaliseProperty, TheOrderOfIndependentShapesDoesNotMatter, (uint64_t seed)) {
  RandomScene a(seed), b(seed);
  std::stable_sort(b.shapes.begin(), b.shapes.end(),
                   [&](ShapeIndex p, ShapeIndex q) { return b[p].layer > b[q].layer; });
  const auto in_order = a.Normalise(), by_layer = b.Normalise();
  for (size_t i = 0; i < in_order.size(); ++i) {
    const auto at = std::find(b.shapes.begin(), b.shapes.end(), a.shapes[i]) - b.shapes.begin();
    const auto& other = by_layer[static_cast<size_t>(at)];
    RC_ASSERT(in_order[i].size() == other.size());
    for (size_t k = 0; k < other.size(); ++k) {
      RC_ASSERT(std::abs(AreaOf(a[in_order[i][k]]) - AreaOf(b[other[k]])) < 1e-9);
    }
  }
}

// Every piece can be triangulated, and its scope fits it (errata 3).
RC_GTEST_PROP(NormaliseProperty, PiecesAreSoundPolygons, (uint64_t seed)) {
  RandomScene scene(seed);
  for (const auto& of_shape : scene.Normalise()) {
    for (const ShapeIndex i : of_shape) {
      const Item& piece = scene[i];
      RC_ASSERT(piece.type == ItemType::kPlanar && piece.fixed_geometry);
      RC_ASSERT(piece.layer == 0 && piece.depth == 0);
      const Box2 box = Bounds(PolygonOf(piece));
      RC_ASSERT(glm::length(box.low) < 1e-9);
      RC_ASSERT(glm::distance(box.high, Vec2(piece.scope.size.x, piece.scope.size.y)) < 1e-9);
      std::vector<Vec3> corners;
      TrianglesOf(piece, &corners);
      double area = 0;
      for (size_t k = 0; k < corners.size(); k += 3) {
        area +=
            0.5 * glm::length(glm::cross(corners[k + 1] - corners[k], corners[k + 2] - corners[k]));
      }
      RC_ASSERT(std::abs(area - AreaOf(piece)) < 1e-6 * (1 + area));
    }
  }
}

}  // namespace
}  // namespace parti::grammar::tests
