// color, setMaterial, texture and projections: what shapes wear, and what is made of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/text_file.h"
#include "grammar/action_text.h"
#include "grammar/asset_library.h"
#include "grammar/color_text.h"
#include "grammar/item_surface.h"
#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using testing::HasSubstr;

const std::string kModels = std::string(PARTI_SOURCE_DIR) + "/assets/models";

Result<std::vector<Product>> Ran(const std::string& text, const Item& item) {
  auto action = ParseAction(text);
  if (!action) return Fail(action);
  AssetLibrary library(ReadFile);
  if (auto read = ResolveAssets(kModels, &library, &*action); !read) return Fail(read);
  return Apply(*action, item);
}

Item Made(const std::string& text, const Item& item) {
  const auto products = Ran(text, item);
  EXPECT_TRUE(products) << FormatError(products.error());
  return products->front().item;
}

/// The front wall of a box of 10 x 8 m, 3 m high, looking south.
Item Facade() {
  const Item mass = Apply(Extrude(3), Lot("0,0 10,0 10,8 0,8"))->front().item;
  return FacesOf(mass)[2];
}

/// Where the corner of a surface nearest to a point lies in the image.
Vec2 UvAt(const Item& item, const Vec3& point) {
  Vec2 best(-99, -99);
  double nearest = 1e300;
  for (const SurfacePart& part : SurfaceOf(item)) {
    for (size_t i = 0; i < part.uvs.size(); ++i) {
      const double distance = glm::distance(part.corners[i], point);
      if (distance >= nearest) continue;
      nearest = distance;
      best = part.uvs[i];
    }
  }
  return best;
}

TEST(ColorText, ReadsDigitsAndNames) {
  EXPECT_EQ(ColorFrom("#c8beb4")->rgb, 0xc8beb4u);
  EXPECT_EQ(ColorFrom("FireBrick")->rgb, 0xb22222u);
  EXPECT_EQ(ColorFrom("black")->rgb, 1u);
  EXPECT_FALSE(ColorFrom("#c8beb4")->opacity);
  EXPECT_NEAR(*ColorFrom("#c8beb480")->opacity, 128 / 255.0, 1e-12);
  for (const char* bad : {"", "#", "#12345", "#12345g", "#1234567", "firebrik", "#-12345"}) {
    EXPECT_FALSE(ColorFrom(bad)) << bad;
  }
  EXPECT_EQ(ColorMeant("firebrik"), "firebrick");
}

TEST(Color, IsTextNameOrParts) {
  EXPECT_EQ(Made("color(\"#ff8000\")", Facade()).color_rgb, 0xff8000u);
  EXPECT_EQ(Made("color(\"tan\")", Facade()).color_rgb, 0xd2b48cu);
  EXPECT_EQ(Made("color(1, 0.5, 0)", Facade()).color_rgb, 0xff8000u);
  const Item clear = Made("color(1, 0.5, 0, 0.25)", Facade());
  EXPECT_NEAR(clear.paint->material->opacity, 0.25, 1e-12);
  EXPECT_EQ(Made("color(\"#ff8000\")", Facade()).paint, nullptr) << "the usual costs nothing";
  const auto meant = Ran("color(\"firebrik\")", Facade());
  ASSERT_FALSE(meant);
  EXPECT_THAT(meant.error().hint, HasSubstr("firebrick"));
}

TEST(Color, IsWrittenAsItWasRead) {
  for (const char* text :
       {"color(\"#ff8000\")", "color(\"tan\")", "color(\"#c8beb4\")", "color(1, 0.5, 0)",
        "color(1, 0.5, 0, 0.25)", "setMaterial(color.r, 1)", "setMaterial(opacity, 0.5)",
        "texture(\"bricks.png\")", "setupProjection(0, scope.xy, 1.5, '1)", "projectUV(0)"}) {
    const auto action = ParseAction(text);
    ASSERT_TRUE(action) << text << FormatError(action.error());
    EXPECT_EQ(TextOf(*action), text);
  }
}

TEST(SetMaterial, SetsOneNumberAndKeepsTheOthers) {
  Item item = Made("setMaterial(opacity, 0.5)", Facade());
  item = Made("setMaterial(metallic, 1)", item);
  EXPECT_NEAR(item.paint->material->opacity, 0.5, 1e-12);
  EXPECT_NEAR(item.paint->material->metallic, 1, 1e-12);
  item = Made("setMaterial(color.g, 0)", item);
  EXPECT_EQ(item.color_rgb, 0xff00ffu);
}

TEST(Texture, CoversAPlanarShapeOnceAndItsPartsAsTheirs) {
  const Item wall = Made("texture(\"bricks.png\")", Facade());
  const Scope& s = wall.scope;
  EXPECT_NEAR(glm::distance(UvAt(wall, s.origin), Vec2(0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(UvAt(wall, s.ToWorld(Vec3(10, 3, 0))), Vec2(1, 1)), 0, 1e-12);
  const auto parts = Ran("split(x) { '0.25: A | ~1: B }", wall);
  ASSERT_TRUE(parts);
  const Vec2 seam = UvAt((*parts)[1].item, s.ToWorld(Vec3(2.5, 3, 0)));
  EXPECT_NEAR(glm::distance(seam, Vec2(0.25, 1)), 0, 1e-9);
}

TEST(Texture, StaysOnTheFrontOfWhatIsExtruded) {
  const Item wall = Made("texture(\"bricks.png\")", Facade());
  const Item block = Made("extrude(0.3) Block", wall);
  const Vec3 corner = wall.scope.ToWorld(Vec3(10, 3, 0.3));
  const Item front = Ran("comp(f) { front: F }", block)->front().item;
  EXPECT_NEAR(glm::distance(UvAt(front, corner), Vec2(1, 1)), 0, 1e-9);
  const Item side = Ran("comp(f) { right: F }", block)->front().item;
  const auto uvs = SurfaceOf(side)[0].uvs;
  double low = 1e300, high = -1e300;
  for (const Vec2& uv : uvs) {
    low = std::min(low, uv.x);
    high = std::max(high, uv.x);
  }
  EXPECT_NEAR(high - low, 0.03, 1e-9) << "0.3 m of an image 10 m wide, not smeared";
}

TEST(Projection, IsSetUpOnTheWallAndUsedOnItsTiles) {
  Item wall = Made("setupProjection(0, scope.xy, 2, 1)", Facade());
  const auto tiles = Ran("split(x) { ~2.5: Tile }*", wall);
  ASSERT_TRUE(tiles);
  const Item tile = Made("projectUV(0)", Made("texture(\"bricks.png\")", (*tiles)[2].item));
  const Vec2 uv = UvAt(tile, wall.scope.ToWorld(Vec3(5, 3, 0)));
  EXPECT_NEAR(glm::distance(uv, Vec2(2.5, 3)), 0, 1e-9);
}

TEST(Projection, KnowsRelativeSizesTheWorldAndOtherLayers) {
  const Item wall = Made("projectUV(0)", Made("setupProjection(0, scope.xy, '0.5, '1)", Facade()));
  EXPECT_NEAR(wall.paint->map->At(wall.scope.ToWorld(Vec3(10, 3, 0))).x, 2, 1e-9);
  const Item world = Made("projectUV(0)", Made("setupProjection(0, world.xy, 2, 2)", Facade()));
  EXPECT_NEAR(world.paint->map->At(Vec3(4, 2, 77)).x, 2, 1e-9);
  EXPECT_EQ(Made("setupProjection(2, scope.xy, 1, 1)", Facade()).paint, nullptr);
  const auto none = Ran("projectUV(0)", Facade());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().hint, HasSubstr("setupProjection"));
  EXPECT_FALSE(Ran("setupProjection(0, scope.xy, 0, 1)", Facade()));
}

TEST(Texture, NeedsAnImage) {
  EXPECT_EQ(Ran("texture(\"gone.png\")", Facade()).error().code, ErrorCode::kFile);
  EXPECT_THAT(Ran("texture(\"window.obj\")", Facade()).error().message, HasSubstr("no image"));
  EXPECT_THAT(Ran("i(\"bricks.png\") A", Facade()).error().message, HasSubstr("image"));
}

TEST(Primitives, FillTheScope) {
  const Item mass = Made("extrude(3) M", Lot("0,0 10,0 10,8 0,8"));
  EXPECT_NEAR(VolumeOf(Made("primitiveCube() C", mass)), 240, 1e-9);
  const Item cylinder = Made("primitiveCylinder(64) C", mass);
  EXPECT_NEAR(VolumeOf(cylinder), kPi / 4 * 240, 1);
  EXPECT_TRUE(cylinder.mesh->closed);
  EXPECT_NEAR(VolumeOf(Made("primitiveCone(64) C", mass)), kPi / 12 * 240, 1);
  const Item sphere = Made("primitiveSphere(64, 32) S", mass);
  EXPECT_NEAR(VolumeOf(sphere), kPi / 6 * 240, 2);
  EXPECT_TRUE(IsClosed(*sphere.mesh));
  EXPECT_NEAR(VolumeOf(Made("primitiveCylinder(4) C", mass)), 240, 1e-9) << "a prism of 4 sides";
}

TEST(Primitives, OfTheirOwnSizeStandInTheMiddleOfTheFloor) {
  const Item mass = Made("extrude(3) M", Lot("0,0 10,0 10,8 0,8"));
  const Item post = Made("primitiveCylinder(12, 0.1, 2) P", mass);
  EXPECT_NEAR(glm::distance(post.scope.size, Vec3(0.2, 2, 0.2)), 0, 1e-12);
  const Vec3 foot = post.scope.ToWorld(Vec3(0.1, 0, 0.1));
  EXPECT_NEAR(glm::distance(foot, mass.scope.ToWorld(Vec3(5, 0, 4))), 0, 1e-9);
  const Item cube = Made("primitiveCube(1, 2, 3) C", mass);
  EXPECT_NEAR(VolumeOf(cube), 6, 1e-9);
}

TEST(Primitives, LieFlatOnTheFloorFacingUp) {
  const Item mass = Made("extrude(3) M", Lot("0,0 10,0 10,8 0,8"));
  const Item quad = Made("primitiveQuad() Q", mass);
  EXPECT_EQ(quad.type, ItemType::kPlanar);
  EXPECT_NEAR(AreaOf(quad), 80, 1e-9);
  EXPECT_NEAR(quad.facing.y, 1, 1e-12);
  const Item disk = Made("primitiveDisk(64, 2) D", mass);
  EXPECT_NEAR(AreaOf(disk), 4 * kPi, 0.1);
  EXPECT_NEAR(disk.facing.y, 1, 1e-12);
  EXPECT_NEAR(AreaOf(Made("primitiveDisk() D", Facade())), 30 * kPi / 4, 1) << "in the wall";
}

TEST(Primitives, OnPointsAndEdgesTakeTheirOwnSize) {
  const Item mass = Made("extrude(3) M", Lot("0,0 10,0 10,8 0,8"));
  const Item corner = Ran("comp(v) { 0: V }", mass)->front().item;
  EXPECT_NEAR(VolumeOf(Made("primitiveCube() C", corner)), 1, 1e-12);
  const Item ball = Made("primitiveSphere(16, 8, 0.5) S", corner);
  EXPECT_NEAR(ball.scope.size.y, 1, 1e-12);
}

TEST(Primitives, WearTextureOnceAround) {
  const Item mass = Made("extrude(3) M", Lot("0,0 10,0 10,8 0,8"));
  const Item post = Made("texture(\"planks.png\")", Made("primitiveCylinder(8) P", mass));
  double low = 1e300, high = -1e300;
  for (const SurfacePart& part : SurfaceOf(post)) {
    EXPECT_EQ(part.material->image->name, "planks.png");
    ASSERT_EQ(part.uvs.size(), part.corners.size());
    for (const Vec2& uv : part.uvs) {
      low = std::min(low, uv.x);
      high = std::max(high, uv.x);
    }
  }
  EXPECT_NEAR(low, 0, 1e-9);
  EXPECT_NEAR(high, 1, 1e-9);
}

TEST(ResetMaterial, TakesOffWhatTheShapeGotAndKeepsCoordinates) {
  Item facade = Made("setupProjection(0, scope.xy, 2, 2)", Facade());
  facade = Made("projectUV(0)", Made("texture(\"bricks.png\")", facade));
  facade = Made("setMaterial(opacity, 0.5)", Made("color(\"#ff0000\")", facade));
  const Item reset = Made("resetMaterial()", facade);
  EXPECT_EQ(reset.color_rgb, 0u);
  ASSERT_TRUE(reset.paint);
  EXPECT_FALSE(reset.paint->material);
  EXPECT_EQ(reset.paint->map, facade.paint->map);
  EXPECT_FALSE(Made("resetMaterial()", Made("color(\"#ff0000\")", Facade())).paint);
  EXPECT_EQ(Made("resetMaterial(geometry)", facade).color_rgb, facade.color_rgb);
  EXPECT_EQ(*Made("resetMaterial(geometry)", facade).paint, *facade.paint);
}

TEST(ResetMaterial, OfGeometryIsThatOfAnAssetsFaces) {
  const Item window = Made("color(\"#ff0000\")", Made("i(\"window.obj\")", Facade()));
  const auto has_materials = [](const Item& item) {
    return std::any_of(item.mesh->paints.begin(), item.mesh->paints.end(),
                       [](const Paint& paint) { return paint.material != nullptr; });
  };
  ASSERT_TRUE(has_materials(window));
  EXPECT_TRUE(has_materials(Made("resetMaterial()", window)));
  EXPECT_FALSE(has_materials(Made("resetMaterial(geometry)", window)));
  EXPECT_EQ(Made("resetMaterial(geometry)", window).color_rgb, window.color_rgb);
  const Item all = Made("resetMaterial(all)", window);
  EXPECT_FALSE(has_materials(all));
  EXPECT_EQ(all.color_rgb, 0u);
}

}  // namespace
}  // namespace parti::grammar::tests
