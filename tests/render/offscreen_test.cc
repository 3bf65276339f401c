// Pictures as they come out, on each off-screen target that the machine has.
#include "render/offscreen.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "render/bounds.h"
#include "tests/support/golden.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

using tests::AddBox;
using tests::HouseCamera;
using tests::PixelAt;

class Offscreen : public testing::TestWithParam<OffscreenTarget> {
 protected:
  void SetUp() override {
    auto created = OffscreenRenderer::Create(GetParam());
    if (!created) GTEST_SKIP() << FormatError(created.error());
    renderer_ = std::move(*created);
  }
  Image Draw(const Scene& scene, const Camera& camera) {
    Result<Image> image = renderer_->Draw(scene, camera);
    EXPECT_TRUE(image) << FormatError(image.error());
    return image.value_or(Image{});
  }
  std::unique_ptr<OffscreenRenderer> renderer_;
};

/// Straight from the south at the origin, 100 px a metre at z = 0, origin in the middle.
Camera Front(double width_px = 400, double height_px = 400) {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.target = {0, 0, 0};
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.vertical_fov = Angle::Radians(2 * std::atan(height_px / 200 / 20));
  return camera;
}

bool IsDark(const glm::ivec3& pixel) { return pixel.r + pixel.g + pixel.b < 3 * 90; }
bool IsPaper(const glm::ivec3& pixel) { return pixel.r > 225 && pixel.g > 225 && pixel.b > 215; }

TEST_P(Offscreen, AnEmptySceneIsPaper) {
  Scene scene;
  scene.ground = false;
  const Image image = Draw(scene, HouseCamera(80, 50));
  ASSERT_EQ(image.width, 80);
  ASSERT_EQ(image.height, 50);
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 80; ++x) ASSERT_TRUE(IsPaper(PixelAt(image, x, y))) << x << ", " << y;
  }
  EXPECT_EQ(image.pixels[3], 255);
}

TEST_P(Offscreen, InkCoversThePixelsWhereItWasDrawnAndNoOthers) {
  Scene scene;
  scene.ground = false;
  // Pixel (20, 30)'s middle is 20.5, 30.5; a stroke 3 px wide covers three rows.
  scene.ink.push_back({{{20.5f, 30.5f}, {50.5f, 30.5f}, {50.5f, 60.5f}}, {3, 3, 3}, {0, 0, 0, 1}});
  const Image image = Draw(scene, Front(100, 80));
  for (int x = 20; x <= 50; ++x) {
    for (int y = 29; y <= 31; ++y) EXPECT_TRUE(IsDark(PixelAt(image, x, y))) << x << ", " << y;
    if (x < 48) {
      EXPECT_TRUE(IsPaper(PixelAt(image, x, 27))) << x;
      EXPECT_TRUE(IsPaper(PixelAt(image, x, 33))) << x;
    }
  }
  for (int y = 30; y <= 60; ++y) EXPECT_TRUE(IsDark(PixelAt(image, 50, y))) << y;
  EXPECT_TRUE(IsPaper(PixelAt(image, 17, 30)));
  EXPECT_TRUE(IsPaper(PixelAt(image, 50, 64)));
}

TEST_P(Offscreen, TranslucentInkIsAsDarkAtItsJointsAsBetween) {
  Scene scene;
  scene.ground = false;
  Ink ink{{}, {}, {0, 0, 0, 0.5f}};
  for (int i = 0; i <= 10; ++i) {
    ink.points.emplace_back(10.5f + 8.0f * static_cast<float>(i), 20.5f);
    ink.widths_px.push_back(9);
  }
  scene.ink.push_back(ink);
  const Image image = Draw(scene, Front(100, 41));
  const glm::ivec3 first = PixelAt(image, 12, 20);
  EXPECT_FALSE(IsDark(first));
  EXPECT_FALSE(IsPaper(first));
  for (int x = 12; x < 88; ++x) EXPECT_EQ(PixelAt(image, x, 20), first) << x;
}

TEST_P(Offscreen, InkWidthFollowsItsSamples) {
  Scene scene;
  scene.ground = false;
  scene.ink.push_back({{{10, 50}, {90, 50}}, {2, 22}, {0, 0, 0, 1}});
  const Image image = Draw(scene, Front(100, 100));
  const auto dark_in_column = [&image](int x) {
    int dark = 0;
    for (int y = 0; y < 100; ++y) dark += IsDark(PixelAt(image, x, y)) ? 1 : 0;
    return dark;
  };
  EXPECT_NEAR(dark_in_column(20), 4, 2);
  EXPECT_NEAR(dark_in_column(50), 12, 2);
  EXPECT_NEAR(dark_in_column(85), 20, 2);
}

TEST_P(Offscreen, ALineHasItsWidthWhereItProjects) {
  Scene scene;
  scene.ground = false;
  scene.lines.push_back({{{-1, 0.505f, 0}, {1, 0.505f, 0}}, {0, 0, 0, 1}, 3});
  const Image image = Draw(scene, Front());  // y = 200 - 50.5 = 149.5, the middle of row 149
  for (int x = 100; x < 300; ++x) {
    for (int y = 148; y <= 150; ++y) EXPECT_TRUE(IsDark(PixelAt(image, x, y))) << x << ", " << y;
    EXPECT_TRUE(IsPaper(PixelAt(image, x, 146)));
    EXPECT_TRUE(IsPaper(PixelAt(image, x, 152)));
  }
  EXPECT_TRUE(IsPaper(PixelAt(image, 96, 149)));
  EXPECT_TRUE(IsPaper(PixelAt(image, 304, 149)));
}

TEST_P(Offscreen, LinesThatRunTogetherAreFainterUnlessTheyAreLong) {
  const auto shade = [this](float length_m, float spacing_m) {
    Scene scene;
    scene.ground = false;
    Lines line{{{-length_m / 2, 0.505f, 0}, {length_m / 2, 0.505f, 0}}, {0, 0, 0, 1}, 3};
    line.spacing_m = spacing_m;
    scene.lines.push_back(line);
    return PixelAt(Draw(scene, Front()), 200, 149).r;
  };
  const int full = shade(0.1f, 0);
  EXPECT_EQ(shade(0.1f, 0.06f), full) << "6 px apart";
  EXPECT_GT(shade(0.1f, 0.03f), full + 50);
  EXPECT_GT(shade(0.1f, 0.01f), shade(0.1f, 0.03f) + 20);
  EXPECT_LT(shade(0.1f, 1e-6f), 255 - 10) << "something is left of it";
  EXPECT_EQ(shade(2, 0.01f), full) << "200 px long";
}

TEST_P(Offscreen, DashesAreAsLongAsTheirGaps) {
  Scene scene;
  scene.ground = false;
  scene.lines.push_back({{{-1.9f, 0.005f, 0}, {1.9f, 0.005f, 0}}, {0, 0, 0, 1}, 3, 10});
  const Image image = Draw(scene, Front());
  int dark = 0, changes = 0;
  for (int x = 10; x < 390; ++x) {
    dark += IsDark(PixelAt(image, x, 199)) ? 1 : 0;
    changes += IsDark(PixelAt(image, x, 199)) != IsDark(PixelAt(image, x - 1, 199)) ? 1 : 0;
  }
  EXPECT_NEAR(dark, 190, 20);
  EXPECT_NEAR(changes, 38, 2);
}

TEST_P(Offscreen, AFaceHidesLinesBehindItButNotItsOwnEdges) {
  Scene scene;
  scene.ground = false;
  scene.faces.push_back({{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}});
  scene.lines.push_back({{{-1.5f, 0.205f, -0.02f}, {1.5f, 0.205f, -0.02f}}, {0, 0, 0, 1}, 3});
  scene.lines.push_back({{{-1, 0.505f, 0}, {1, 0.505f, 0}}, {0, 0, 0, 1}, 3});
  scene.lines.push_back({{{-1.5f, -0.5f, -2}, {1.5f, -0.5f, -2}}, {0, 0, 0, 1}, 3, 0, true});
  const Image image = Draw(scene, Front());
  EXPECT_TRUE(IsDark(PixelAt(image, 80, 179)));    // beside the face
  EXPECT_FALSE(IsDark(PixelAt(image, 200, 179)));  // behind it
  for (int x = 105; x < 295; ++x) EXPECT_TRUE(IsDark(PixelAt(image, x, 149))) << x;
  const int face = PixelAt(image, 200, 220).g, hidden = PixelAt(image, 200, 245).g;
  EXPECT_LT(hidden, face - 8) << "on_top lines show faintly through faces";
  EXPECT_FALSE(IsDark(PixelAt(image, 200, 245)));
}

TEST_P(Offscreen, LinesBehindAFaceAreNotSeenFromItsFront) {
  Scene scene;
  scene.ground = false;
  Lines line{{{-1, 0.505f, 0}, {1, 0.505f, 0}}, {0, 0, 0, 1}, 3};
  line.behind = {0, 0, 1};
  scene.lines.push_back(line);
  EXPECT_TRUE(IsPaper(PixelAt(Draw(scene, Front()), 200, 149)));
  Camera back = Front();
  back.eye.z = -20;
  EXPECT_TRUE(IsDark(PixelAt(Draw(scene, back), 200, 149)));
}

TEST_P(Offscreen, AWallThatYieldsDoesNotComeThroughTheRoofThatRunsOnBeyondIt) {
  Scene roof;
  roof.ground = false;
  roof.faces.push_back(
      {{{-3, -0.5f, 1}, {3, -0.5f, 1}, {3, 1, -2}, {-3, -0.5f, 1}, {3, 1, -2}, {-3, 1, -2}},
       {0.8f, 0.2f, 0.1f},
       1});
  Scene house = roof;
  house.faces.push_back({{{-2, -3, 0}, {2, -3, 0}, {2, 0, 0}, {-2, -3, 0}, {2, 0, 0}, {-2, 0, 0}},
                         {1, 1, 1},
                         2,
                         false,
                         true});
  Lines top{{{-2, 0, 0}, {2, 0, 0}}};
  top.behind = glm::normalize(Vec3f(0, 2, 1));
  house.lines.push_back(top);
  Camera camera = Front();
  for (const double height : {0.5, 2.0, 5.0, 9.0}) {
    camera.eye = {3, height, 20};
    const auto ids = renderer_->DrawIds(roof, camera);
    ASSERT_TRUE(ids);
    const Image alone = Draw(roof, camera), both = Draw(house, camera);
    for (int y = 1; y + 1 < alone.height; ++y) {
      for (int x = 0; x < alone.width; ++x) {
        const auto id_at = [&](int row) { return (*ids)[size_t{1} * row * alone.width + x]; };
        if (id_at(y - 1) != 1 || id_at(y) != 1 || id_at(y + 1) != 1) continue;
        ASSERT_NEAR(PixelAt(both, x, y).g, PixelAt(alone, x, y).g, 6) << x << ", " << y;
      }
    }
  }
}

TEST_P(Offscreen, EveryDirectionOfABoxHasItsOwnShade) {
  Scene scene;
  scene.ground = false;
  AddBox(&scene, {-1, -1, -1}, {1, 1, 1}, 1);
  scene.lines.clear();
  std::set<int> shades;
  for (const Vec3& side : {Vec3(5, 0, 0), Vec3(-5, 0, 0), Vec3(0, 0, 5), Vec3(0, 0, -5),
                           Vec3(0, 5, 0.001), Vec3(0, -5, 0.001)}) {
    Camera camera = Front(21, 21);
    camera.eye = side;
    const glm::ivec3 pixel = PixelAt(Draw(scene, camera), 10, 10);
    for (const int other : shades) EXPECT_GE(std::abs(other - pixel.g), 8);
    shades.insert(pixel.g);
  }
}

TEST_P(Offscreen, CoplanarFacesOfNeighboursDoNotFight) {
  // A box's floor on a lot, seen from below and above: the face that looks at the eye wins.
  Scene scene;
  scene.ground = false;
  scene.faces.push_back(
      {{{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1}}, {0, 0.6f, 0}, 1});
  Faces floor = scene.faces[0];
  std::swap(floor.corners[0], floor.corners[1]);
  std::swap(floor.corners[3], floor.corners[4]);
  floor.color = {0.8f, 0, 0};
  floor.id = 2;
  scene.faces.push_back(floor);
  Camera camera = Front(300, 200);
  for (const double y : {3.0, -3.0}) {
    camera.eye = {4, y, 15};
    const auto ids = renderer_->DrawIds(scene, camera);
    ASSERT_TRUE(ids);
    const std::set<uint32_t> seen(ids->begin(), ids->end());
    EXPECT_EQ(seen, (std::set<uint32_t>{0, y > 0 ? 1u : 2u}));
  }
}

TEST_P(Offscreen, CoplanarFacesOnTheSameSideDoNotFight) {
  // A sign on a lot: other triangles in the same plane. The later id wins, whatever the view.
  Scene scene;
  scene.ground = false;
  scene.faces.push_back({{{-9, 0, 7}, {8, 0, 9}, {1, 0, -9}}, {0, 0.6f, 0}, 1});
  scene.faces.push_back({{{-1, 0, 0.3f}, {1.1f, 0, 1}, {0.2f, 0, -1}}, {0.8f, 0, 0}, 2});
  Camera camera = Front(300, 200);
  for (const Vec3& eye : {Vec3(4, 3, 15), Vec3(-20, 5, 60), Vec3(0, 40, 1), Vec3(-9, 2, -9)}) {
    camera.eye = eye;
    const auto both = renderer_->DrawIds(scene, camera);
    ASSERT_TRUE(both);
    Scene alone = scene;
    alone.faces.erase(alone.faces.begin());
    // Drawn alone it has another depth range, but the same pixels.
    const auto sign = renderer_->DrawIds(alone, camera);
    ASSERT_TRUE(sign);
    for (size_t i = 0; i < sign->size(); ++i) ASSERT_EQ((*both)[i] == 2, (*sign)[i] == 2);
  }
}

TEST_P(Offscreen, IdsAreExactAndNearest) {
  Scene scene;
  const uint32_t far_id = 0xfedcba98, near_id = 0x01020304;
  AddBox(&scene, {-1, -1, -1}, {1, 1, 0}, far_id);
  AddBox(&scene, {-0.5f, -0.5f, 0.5f}, {0.5f, 0.5f, 1}, near_id);
  const auto ids = renderer_->DrawIds(scene, Front());
  ASSERT_TRUE(ids) << FormatError(ids.error());
  ASSERT_EQ(ids->size(), size_t{400} * 400);
  const auto at = [&](int x, int y) { return (*ids)[size_t{400} * y + x]; };
  EXPECT_EQ(at(200, 200), near_id);
  EXPECT_EQ(at(110, 200), far_id);
  EXPECT_EQ(at(200, 110), far_id);
  EXPECT_EQ(at(50, 200), 0u);
  EXPECT_EQ(std::set<uint32_t>(ids->begin(), ids->end()), (std::set<uint32_t>{0, near_id, far_id}));
}

TEST_P(Offscreen, WhatIsNotFiniteIsLeftOutAndTheRestIsDrawn) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  Scene scene;
  AddBox(&scene, {-1, -1, -1}, {1, 1, 0}, 5);
  const Scene clean = scene;
  scene.faces.push_back({{{kNan, 0, 0}, {1, 0, 2}, {0, 1, 2}}, {1, 0, 0}, 6});
  scene.faces.push_back({{{kInf, 0, 0}, {1, 0, 2}, {0, -kInf, 2}, {3e38f, 0, 0}}, {1, 0, 0}, 7});
  scene.faces.push_back({{{0, 0, 3}, {0, 0, 3}, {0, 1, 3}, {9, 9, 9}}, {kNan, 0, 0}, 8});
  scene.lines.push_back({{{kNan, 0, 0}, {0, 0, 3}, {0, 0, -kInf}, {1, 1, 3}, {1, 1, 1}}});
  scene.lines.push_back({{{-3, 0, 1}, {3, 0, 1}}, {1, 0, 0, 1}, kNan});
  scene.ink.push_back({{{kNan, 3}, {5, kInf}}, {}, {0, 0, 0, 1}});
  EXPECT_EQ(Draw(scene, Front()), Draw(clean, Front()));
  scene.ink.push_back({{{100.5f, 20.5f}, {kNan, 0}, {120.5f, 20.5f}}, {kNan, 3}, {0, 0, 0, 1}});
  const Image dots = Draw(scene, Front());
  EXPECT_TRUE(IsDark(PixelAt(dots, 100, 20)));
  EXPECT_FALSE(IsDark(PixelAt(dots, 110, 20)));
  EXPECT_TRUE(IsDark(PixelAt(dots, 120, 20)));
}

TEST_P(Offscreen, SizesFromOnePixelToTheDeviceLimit) {
  const Scene scene = tests::House();
  EXPECT_EQ(Draw(scene, HouseCamera(1, 1)).pixels.size(), 4u);
  EXPECT_EQ(Draw(scene, HouseCamera(1, 3000)).height, 3000);
  EXPECT_EQ(Draw(scene, HouseCamera(8192, 2)).width, 8192);
  const Result<Image> too_large = renderer_->Draw(scene, HouseCamera(100000, 10));
  ASSERT_FALSE(too_large);
  EXPECT_EQ(too_large.error().code, ErrorCode::kGraphics);
  EXPECT_NE(too_large.error().hint.find("at most"), std::string::npos);
  EXPECT_EQ(renderer_->DrawIds(scene, HouseCamera(100000, 10)).error().code, ErrorCode::kGraphics);
}

TEST_P(Offscreen, AnInvalidCameraIsRefused) {
  Camera camera = Front();
  camera.eye = camera.target;
  EXPECT_EQ(renderer_->Draw({}, camera).error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(renderer_->DrawIds({}, camera).error().code, ErrorCode::kBadNumber);
}

TEST_P(Offscreen, TilesMakeTheSamePictureAsOne) {
  const Camera camera = HouseCamera(500, 320);
  const Scene scene = tests::HouseWithSketch(camera);
  auto tiled = OffscreenRenderer::Create(GetParam(), 137);
  ASSERT_TRUE(tiled);
  const Image whole = Draw(scene, camera), pieces = *(*tiled)->Draw(scene, camera);
  EXPECT_LE(parti::tests::Compare(whole, pieces, {2, 0}).pixels, 40u);
  EXPECT_EQ(*renderer_->DrawIds(scene, camera), *(*tiled)->DrawIds(scene, camera));
}

TEST_P(Offscreen, SameSceneGivesSameBytes) {
  const Camera camera = HouseCamera(320, 200);
  const Scene scene = tests::HouseWithSketch(camera);
  EXPECT_EQ(Draw(scene, camera), Draw(scene, camera));
}

TEST_P(Offscreen, HouseWithSketch) {
  const Camera camera = HouseCamera(800, 500);
  parti::tests::ExpectGolden(Draw(tests::HouseWithSketch(camera), camera), "render_house_sketch");
}

TEST_P(Offscreen, HouseFromTheNorth) {
  Camera camera = HouseCamera(800, 500);
  camera.eye = {-22, 14, -34};
  parti::tests::ExpectGolden(Draw(tests::House(), camera), "render_house_north");
}

TEST_P(Offscreen, HouseFromAnEyeAtItsDoor) {
  Camera camera = HouseCamera(500, 320);
  camera.eye = {16, 1.6, 18};
  camera.target = {4, 4.5, 4};
  camera.vertical_fov = Angle::Degrees(55);
  parti::tests::ExpectGolden(Draw(tests::House(), camera), "render_house_eye_level");
}

INSTANTIATE_TEST_SUITE_P(
    Targets, Offscreen, testing::Values(OffscreenTarget::kOsMesa, OffscreenTarget::kEglSurfaceless),
    [](const auto& target) { return target.param == OffscreenTarget::kOsMesa ? "OsMesa" : "Egl"; });

TEST(OffscreenRenderers, OneTargetAtLeastIsThere) {
  const auto best = OffscreenRenderer::Create();
  EXPECT_TRUE(best) << FormatError(best.error());
}

TEST(OffscreenRenderers, SeveralLiveSideBySide) {
  const Camera camera = HouseCamera(160, 100);
  const Scene scene = tests::House();
  std::vector<std::unique_ptr<OffscreenRenderer>> renderers;
  for (const auto target : {OffscreenTarget::kOsMesa, OffscreenTarget::kEglSurfaceless,
                            OffscreenTarget::kBest, OffscreenTarget::kEglSurfaceless}) {
    auto created = OffscreenRenderer::Create(target);
    if (created) renderers.push_back(std::move(*created));
  }
  ASSERT_FALSE(renderers.empty());
  std::vector<Image> first, second;
  for (auto& renderer : renderers) first.push_back(*renderer->Draw(scene, camera));
  renderers.erase(renderers.begin());
  for (auto& renderer : renderers) second.push_back(*renderer->Draw(scene, camera));
  EXPECT_TRUE(std::equal(second.begin(), second.end(), first.begin() + 1));
}

}  // namespace
}  // namespace parti::render
