// What holds for every row of the table: rigid motions pass through, and so do repeats of a run.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {
namespace {

/// A turn about the world's up axis and a move: what leaves "up" as it is.
struct Motion {
  double cosine, sine;
  Vec3 move;

  explicit Motion(Random* random) {
    const double angle = random->Uniform(0, 2 * kPi);
    cosine = std::cos(angle);
    sine = std::sin(angle);
    move = Vec3(random->Uniform(-99, 99), random->Uniform(-99, 99), random->Uniform(-99, 99));
  }
  Vec3 Turn(const Vec3& v) const {
    return {cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x};
  }
  Scope Of(const Scope& s) const {
    return {Turn(s.origin) + move, Turn(s.x), Turn(s.y), Turn(s.z), s.size};
  }
  Item Of(const Item& item) const {
    Item moved = item;
    moved.scope = Of(item.scope);
    moved.facing = Turn(item.facing);
    return moved;
  }
};

void ExpectSame(const Item& a, const Item& b) {
  constexpr double kNear = 1e-8;
  RC_ASSERT(a.type == b.type);
  RC_ASSERT(glm::distance(a.scope.origin, b.scope.origin) < kNear);
  RC_ASSERT(glm::distance(a.scope.x, b.scope.x) < kNear);
  RC_ASSERT(glm::distance(a.scope.y, b.scope.y) < kNear);
  RC_ASSERT(glm::distance(a.scope.z, b.scope.z) < kNear);
  RC_ASSERT(glm::distance(a.scope.size, b.scope.size) < kNear);
  RC_ASSERT(glm::distance(a.facing, b.facing) < kNear);
  RC_ASSERT((a.polygon == nullptr) == (b.polygon == nullptr));
  RC_ASSERT((a.mesh == nullptr) == (b.mesh == nullptr));
  RC_ASSERT(std::abs(AreaOf(a) - AreaOf(b)) < kNear * (1 + AreaOf(a)));
}

std::vector<Action> ActionsFor(const Item& item) {
  if (item.type == ItemType::kVolume) {
    return {AllFaces(), Split(Axis::kX, {Metres(1, "A"), Group({Floating(2, "B")})}),
            Split(Axis::kY, {Share(0.3, "A"), Floating(1, "B")}),
            Repeat(Axis::kZ, {Metres(1.5, "A")})};
  }
  return {Extrude(4),
          Extrude(-4),
          OffsetBy(-0.3),
          OffsetBy(0.7),
          Split(Axis::kX, {Metres(1, "A"), Group({Floating(2, "B")})}),
          Repeat(Axis::kY, {Floating(2.2, "A"), Metres(0.5, "B")})};
}

/// A lot, a wall or a roof, or a volume.
Item AnyItem(Random* random) {
  const Polygon polygon = AnyPolygon(random);
  std::vector<Ring> rings = {polygon.outer};
  rings.insert(rings.end(), polygon.holes.begin(), polygon.holes.end());
  const Item lot = LotFrom(rings).value();
  const double pick = random->Uniform();
  if (pick < 0.3) return lot;
  const Item mass = Apply(Extrude(random->Uniform(1, 9)), lot)->front().item;
  if (pick < 0.6) return mass;
  const std::vector<Item> faces = FacesOf(mass);
  return faces[static_cast<size_t>(random->Uniform(0, static_cast<double>(faces.size())))];
}

RC_GTEST_PROP(OperationProperty, MovesWithTheItem, (uint64_t seed)) {
  Random random(seed);
  const Item item = AnyItem(&random);
  const Motion motion(&random);
  for (const Action& action : ActionsFor(item)) {
    const auto still = Apply(action, item);
    const auto moved = Apply(action, motion.Of(item));
    RC_ASSERT(still.has_value() && moved.has_value());
    RC_ASSERT(still->size() == moved->size());
    for (size_t i = 0; i < still->size(); ++i) {
      RC_ASSERT((*still)[i].successor == (*moved)[i].successor);
      ExpectSame(motion.Of((*still)[i].item), (*moved)[i].item);
    }
  }
}

// Reading a lot from moved corners is moving the lot.
RC_GTEST_PROP(PlanarFromProperty, MovesWithItsCorners, (uint64_t seed)) {
  Random random(seed);
  const Polygon polygon = AnyPolygon(&random);
  const Motion motion(&random);
  std::vector<std::vector<Vec3>> still, moved;
  const auto add = [&](const Ring& ring) {
    still.emplace_back();
    moved.emplace_back();
    for (const Vec2& p : ring) {
      still.back().emplace_back(p.x, 1.0, -p.y);
      moved.back().push_back(motion.Turn(still.back().back()) + motion.move);
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  const auto a = PlanarFrom(still), b = PlanarFrom(moved);
  RC_ASSERT(a.has_value() && b.has_value());
  ExpectSame(motion.Of(*a), *b);
}

bool SameBytes(const std::vector<Product>& a, const std::vector<Product>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    const Item &p = x.item, &q = y.item;
    return p.scope.origin == q.scope.origin && p.scope.size == q.scope.size &&
           !p.polygon == !q.polygon && !p.mesh == !q.mesh &&
           (!p.polygon || *p.polygon == *q.polygon) && (!p.mesh || *p.mesh == *q.mesh);
  });
}

RC_GTEST_PROP(OperationProperty, EqualInputGivesEqualBytes, (uint64_t seed)) {
  Random random(seed);
  const Item item = AnyItem(&random);
  for (const Action& action : ActionsFor(item)) {
    const auto a = Apply(action, item), b = Apply(action, item);
    RC_ASSERT(a.has_value() && b.has_value() && SameBytes(*a, *b));
  }
}

// CGAL numbered the nodes of this skeleton, many of which meet at once, by where they lay in
// memory.
TEST(OperationProperty, WhereMemoryLiesDoesNotMatter) {
  Random random(6499222219241);
  const Item item = AnyItem(&random);
  const auto first = Apply(OffsetBy(-0.3), item);
  ASSERT_TRUE(first.has_value());
  ASSERT_EQ(first->size(), 5u);
  std::vector<std::vector<Product>> kept;  // so that each finds other memory
  for (int i = 0; i < 50; ++i) {
    kept.push_back(Apply(OffsetBy(-0.3), item).value());
    EXPECT_TRUE(SameBytes(*first, kept.back())) << i;
  }
}

// Scopes of all products are right-handed, tight, and stand as language.md says.
RC_GTEST_PROP(OperationProperty, ScopesFitTheirGeometry, (uint64_t seed)) {
  Random random(seed);
  const Item item = AnyItem(&random);
  for (const Action& action : ActionsFor(item)) {
    const auto products = Apply(action, item);
    RC_ASSERT(products.has_value());
    for (const Product& product : *products) {
      const Item& made = product.item;
      const Scope& s = made.scope;
      RC_ASSERT(glm::distance(glm::cross(s.x, s.y), s.z) < 1e-9);
      RC_ASSERT(std::min({s.size.x, s.size.y}) > 0);
      Vec3 low(1e300), high(-1e300);
      for (const Segment3& edge : EdgesOf(made)) {
        low = glm::min(low, glm::min(s.ToLocal(edge.a), s.ToLocal(edge.b)));
        high = glm::max(high, glm::max(s.ToLocal(edge.a), s.ToLocal(edge.b)));
      }
      RC_ASSERT(glm::length(low) < 1e-8);
      RC_ASSERT(glm::distance(high, s.size) < 1e-8);
      if (made.type == ItemType::kVolume) {
        RC_ASSERT(s.y.y > std::sqrt(0.5) - 1e-6);
        RC_ASSERT(VolumeOf(made) > 0);
      } else {
        RC_ASSERT(s.size.z == 0);
        RC_ASSERT(glm::distance(made.facing, s.z) < 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace parti::grammar::tests
