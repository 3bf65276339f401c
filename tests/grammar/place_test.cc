// t, r, s, center, mirror: shapes moved, turned and resized with their scopes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grammar/action_text.h"
#include "grammar/item_place.h"
#include "grammar/item_surface.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

Item Box(const Vec3& size) {
  Scope scope;
  scope.origin = Vec3(1, 2, 3);
  scope.size = size;
  return *BoxFrom(scope);
}

/// The only item that the text's action makes.
Item Made(const std::string& text, const Item& item) {
  const auto action = ParseAction(text);
  EXPECT_TRUE(action) << FormatError(action.error());
  const auto products = Apply(*action, item);
  EXPECT_TRUE(products) << FormatError(products.error());
  EXPECT_EQ(products->size(), 1u);
  return products->front().item;
}

bool Near(const Vec3& a, const Vec3& b) { return glm::distance(a, b) < 1e-9; }

TEST(Translate, MovesAlongTheScopeInMetresAndParts) {
  const Item moved = Made("t(1, '0.5, '-1)", Box(Vec3(4, 2, 6)));
  EXPECT_TRUE(Near(moved.scope.origin, Vec3(2, 3, -3)));
  EXPECT_EQ(moved.scope.size, Vec3(4, 2, 6));
}

TEST(Translate, LiftsALotAlongItsNormalAsCgaDoes) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item moved = Made("t(1, 5, 2)", lot);
  EXPECT_TRUE(Near(moved.scope.origin, lot.scope.origin + Vec3(1, 5, 2)));
}

TEST(Scale, StretchesGeometryWithItsScopeFromTheOrigin) {
  const Item lot = Lot("0,0 10,0 10,8 5,8 0,4");
  const Item half = Made("s('0.5, '1, 4)", lot);
  EXPECT_NEAR(AreaOf(half), AreaOf(lot) / 4, 1e-9);
  EXPECT_TRUE(Near(half.scope.size, Vec3(5, 4, 0)));
  // CGA's lots have their origin at the back: the scope by its names keeps it.
  EXPECT_TRUE(Near(NamedScope(half).origin, NamedScope(lot).origin));
}

TEST(Scale, GivesWhatIsFlatADepth) {
  const Item face = FacesOf(Box(Vec3(4, 2, 6)))[2];
  const Item deep = Made("s('1, '1, 0.2)", face);
  EXPECT_EQ(deep.type, ItemType::kPlanar);
  EXPECT_DOUBLE_EQ(deep.scope.size.z, 0.2);
  EXPECT_DOUBLE_EQ(AreaOf(deep), AreaOf(face));
  const Item split = Apply(*ParseAction("split(x) { ~1: A }"), deep)->front().item;
  EXPECT_EQ(split.scope.size.z, 0) << "parts have the scope of their geometry again";
}

TEST(Scale, ToNothingAndBackKeepsAMesh) {
  const Item mass = Apply(Extrude(3), Lot("0,0 10,0 10,8 5,8 0,4"))->front().item;
  const Item flat = Made("s('1, 0, '1)", mass);
  EXPECT_EQ(VolumeOf(flat), 0);
  std::vector<Vec3> corners;
  TrianglesOf(flat, &corners);
  for (const Vec3& p : corners) EXPECT_TRUE(IsFinite(p));
  EXPECT_NEAR(VolumeOf(Made("s('1, 3, '1)", flat)), VolumeOf(mass), 1e-9);
}

TEST(Rotate, TurnsAxesAndFacingAroundTheOrigin) {
  const Item face = FacesOf(Box(Vec3(4, 2, 6)))[2];
  ASSERT_TRUE(Near(face.facing, Vec3(0, 0, 1)));
  const Item turned = Made("r(0, 90, 0)", face);
  EXPECT_TRUE(Near(turned.scope.origin, face.scope.origin));
  EXPECT_TRUE(Near(turned.scope.x, Vec3(0, 0, -1)));
  EXPECT_TRUE(Near(turned.facing, Vec3(1, 0, 0)));
  EXPECT_TRUE(Near(turned.scope.z, turned.facing));
}

TEST(Rotate, AboutTheCenterKeepsIt) {
  const Item box = Box(Vec3(4, 2, 6));
  const Item turned = Made("r(scopeCenter, 10, 20, 30)", box);
  EXPECT_TRUE(Near(turned.scope.ToWorld(turned.scope.size * 0.5), Vec3(3, 3, 6)));
  EXPECT_EQ(TextOf(*ParseAction("r(scopeCenter, 10, 20, 30)")), "r(scopeCenter, 10, 20, 30)");
  EXPECT_EQ(TextOf(*ParseAction("r(10, 20, 30)")), "r(10, 20, 30)");
}

TEST(Rotate, TurnsALotAroundItsNormal) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item turned = Made("r(0, 90, 0)", lot);
  EXPECT_TRUE(Near(turned.facing, Vec3(0, 1, 0)));
  EXPECT_TRUE(Near(turned.scope.x, Vec3(0, 0, -1)));
}

TEST(Center, LeadsBackToTheMiddle) {
  const Item box = Box(Vec3(4, 2, 6));
  Item small = Made("s(1, 1, 1)", box);
  small = Made("t(5, 5, 5)", small);
  const Item xz = Made("center(xz)", small);
  EXPECT_TRUE(Near(xz.scope.origin, Vec3(2.5, 7, 5.5)));
  EXPECT_TRUE(Near(Made("center(xyz)", small).scope.origin, Vec3(2.5, 2.5, 5.5)));
  EXPECT_TRUE(Near(Made("center(xyz)", box).scope.origin, box.scope.origin));
}

TEST(Center, InsetsALotAsCgaDoes) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item inset = Made("center(xz)", Made("s('0.8, '1, '0.5)", lot));
  EXPECT_NEAR(AreaOf(inset), 8 * 4, 1e-9);
  EXPECT_TRUE(
      Near(inset.scope.ToWorld(inset.scope.size * 0.5), lot.scope.ToWorld(lot.scope.size * 0.5)));
}

TEST(Mirror, FlipsGeometryAndTextureInTheScope) {
  Item lot = Lot("0,0 10,0 10,8 5,8 0,4");
  Paint paint;
  paint.map = TextureMap{Vec3(1, 0, 0), Vec3(0, 0, 1), Vec2(0, 0)};
  lot.paint = std::make_shared<const Paint>(paint);
  const Item flipped = Made("mirror(true, false, false)", lot);
  EXPECT_EQ(flipped.scope.origin, lot.scope.origin);
  EXPECT_NEAR(AreaOf(flipped), AreaOf(lot), 1e-9);
  EXPECT_GT(SignedArea(flipped.polygon->outer), 0);
  EXPECT_FALSE(*flipped.polygon == *lot.polygon);
  EXPECT_NEAR(flipped.paint->map->At(Vec3(10, 0, 0)).x, 0, 1e-9);
  EXPECT_TRUE(*Made("mirror(true, false, false)", flipped).polygon == *lot.polygon);
}

RC_GTEST_PROP(Place, MovingAndTurningBackGivesTheShapeAgain, ()) {
  const auto angle = *rc::gen::inRange(-180, 180);
  const auto way = *rc::gen::inRange(-50, 50);
  const Item mass = Apply(Extrude(3), Lot("0,0 10,0 10,8 5,8 0,4"))->front().item;
  Item item = Made("r(0, " + std::to_string(angle) + ", 0)", mass);
  item = Made("t(" + std::to_string(way) + ", 0, 1)", item);
  item = Made("t(" + std::to_string(-way) + ", 0, -1)", item);
  item = Made("r(0, " + std::to_string(-angle) + ", 0)", item);
  RC_ASSERT(glm::distance(item.scope.origin, mass.scope.origin) < 1e-6);
  RC_ASSERT(glm::distance(item.scope.x, mass.scope.x) < 1e-9);
  RC_ASSERT(std::abs(VolumeOf(item) - VolumeOf(mass)) < 1e-9);
}

TEST(Place, TexturesStayOnWhatIsMovedTurnedAndStretched) {
  Item face = FacesOf(Box(Vec3(4, 2, 6)))[2];
  Paint paint;
  paint.map = TextureMap{Vec3(0.25, 0, 0), Vec3(0, 0.5, 0), Vec2(-0.25, -1)};
  face.paint = std::make_shared<const Paint>(paint);
  const auto before = SurfaceOf(face)[0].uvs;
  Item moved = Made("t(3, '0.5, 7)", face);
  moved = Made("r(10, 20, 30)", moved);
  moved = Made("s('2, '3, '1)", moved);
  const auto after = SurfaceOf(moved)[0].uvs;
  ASSERT_EQ(before.size(), after.size());
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(glm::distance(before[i], after[i]), 0, 1e-9);
  }
}

}  // namespace
}  // namespace parti::grammar::tests
