// Painting beside the thread that shows, on each off-screen target that the machine has.
#include "render/scene_painter.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "render/reproject.h"
#include "tests/support/canvas_target.h"
#include "tests/support/golden.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

using tests::CanvasTarget;
using tests::HouseCamera;
using tests::PixelAt;

constexpr glm::ivec2 kSize{320, 200};
const Camera kCamera = HouseCamera(kSize.x, kSize.y);

class ScenePainting : public testing::TestWithParam<OffscreenTarget> {
 protected:
  void SetUp() override {
    target_ = CanvasTarget::Create(GetParam(), kSize);
    if (!target_) GTEST_SKIP() << "no such context";
    house_ = std::make_shared<Scene>(tests::House());
  }
  void Start(const PainterParams& params = {}) {
    auto shared = target_->context().CreateShared();
    ASSERT_TRUE(shared);
    auto painter = ScenePainter::Start(
        std::move(*shared),
        [this] {
          ++painted_;
          painted_.notify_all();
        },
        params);
    ASSERT_TRUE(painter) << FormatError(painter.error());
    painter_ = std::move(*painter);
  }
  std::shared_ptr<const PaintedPicture> Await(const PaintRequest& request) {
    painter_->Request(request);
    return Rested();
  }
  std::shared_ptr<const PaintedPicture> Rested() {
    while (painter_->busy()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return painter_->newest();
  }
  Image Shown(const std::shared_ptr<const PaintedPicture>& picture) {
    target_->canvas().SetPicture(ToCanvas(picture));
    (void)target_->Draw();
    return target_->Shown();
  }
  std::unique_ptr<CanvasTarget> target_;
  std::shared_ptr<const Scene> house_;
  std::atomic<int> painted_ = 0;
  std::unique_ptr<ScenePainter> painter_;
};

TEST_P(ScenePainting, APictureIsWhatTheRendererDraws) {
  Start({.tile_side_px = 64});
  const auto picture = Await({house_, kCamera});
  ASSERT_TRUE(picture);
  const Image image = Shown(picture);
  target_->context().Release();
  auto renderer = OffscreenRenderer::Create(GetParam());
  EXPECT_LE(parti::tests::Compare(image, *(*renderer)->Draw(*house_, kCamera), {2, 0}).pixels, 40u);
  EXPECT_EQ(picture->ids, *(*renderer)->DrawIds(*house_, kCamera));
  ASSERT_TRUE(target_->context().MakeCurrent());
}

TEST_P(ScenePainting, WhatIsAtAPixelIsLookedUp) {
  Start();
  const auto fine = Await({house_, kCamera});
  const View view(kCamera);
  const Vec2 roof = *view.Project({6, 12.4, 4});
  EXPECT_EQ(fine->IdAt(roof), 4u);
  EXPECT_EQ(fine->IdAt({1, 1}), 0u);
  for (const Vec2& outside : {Vec2(-1, 5), Vec2(5, 200), Vec2(NAN, 5), Vec2(1e30, 1e30)}) {
    EXPECT_EQ(fine->IdAt(outside), 0u);
  }
}

TEST_P(ScenePainting, AMovingCameraGetsACoarsePictureAndThenAFineOne) {
  Start({.rest_s = 0.05});
  painter_->Request({house_, kCamera, true});
  painted_.wait(0);
  const auto coarse = painter_->newest();
  EXPECT_TRUE(coarse->coarse);
  EXPECT_EQ(coarse->size_px, kSize / 2);
  EXPECT_EQ(coarse->IdAt(*View(kCamera).Project({6, 12.4, 4})), 4u);
  const auto fine = Rested();
  EXPECT_FALSE(fine->coarse);
  EXPECT_EQ(fine->size_px, kSize);
  EXPECT_EQ(painted_, 2);
  // The same view, though in fewer pixels.
  const Image a = Shown(coarse), b = Shown(fine);
  EXPECT_LE(parti::tests::Compare(a, b, {60, 0}).pixels, size_t{kSize.x} * kSize.y / 20);
}

TEST_P(ScenePainting, TheNewestRequestWins) {
  Start();
  Camera camera = kCamera;
  for (int i = 0; i < 50; ++i) {
    camera.eye.x += 0.1;
    painter_->Request({house_, camera, i % 3 == 0});
  }
  EXPECT_EQ(Rested()->camera, camera);
  EXPECT_FALSE(painter_->newest()->coarse);
  EXPECT_LT(painted_, 50);
}

TEST_P(ScenePainting, AMovedCameraUploadsNothing) {
  Start();
  Camera camera = kCamera;
  EXPECT_EQ(Await({house_, camera})->uploads, 1);
  for (int i = 0; i < 3; ++i) {
    camera.eye.x += 1;
    EXPECT_EQ(Await({house_, camera, i == 1})->uploads, 1);
  }
  EXPECT_EQ(Await({std::make_shared<Scene>(*house_), camera})->uploads, 2);
}

TEST_P(ScenePainting, TheLastPictureIsShownThroughAMovedCamera) {
  Start();
  const auto picture = Await({house_, kCamera});
  const Image before = Shown(picture);
  Camera moved = kCamera;
  moved.eye += (moved.target - moved.eye) * 0.5;  // twice as near
  target_->canvas().SetPicture(ToCanvas(picture, moved));
  (void)target_->Draw();
  const Image nearer = target_->Shown();
  EXPECT_NEAR(PixelAt(nearer, 160, 100).r, PixelAt(before, 160, 100).r, 12);
  EXPECT_NE(nearer, before);
  // The roof's corner is twice as far from the middle.
  const Vec2 corner = *View(kCamera).Project({9, 12.4, 7}), middle(160, 100);
  const Vec3 shown = glm::inverse(PictureFromMoved(kCamera, moved)) * Vec3(corner, 1);
  EXPECT_LT(glm::distance(Vec2(shown) / shown.z, middle + (corner - middle) * 2.0), 1e-6);
  moved.eye = moved.target;
  target_->canvas().SetPicture(ToCanvas(picture, moved));
  (void)target_->Draw();
  EXPECT_EQ(target_->Shown(), before);
}

TEST_P(ScenePainting, APictureThatDiffersInOnePlaceDamagesThatAlone) {
  Start();
  (void)Shown(Await({house_, kCamera}));
  Scene with_window = *house_;
  tests::AddBox(&with_window, {2, 0.5f, 8.1f}, {3, 1.5f, 8.2f}, 50, {1, 0, 0});
  target_->canvas().SetPicture(ToCanvas(Await({std::make_shared<Scene>(with_window), kCamera})));
  const Damage damage = target_->Draw();
  const Vec2 window = *View(kCamera).Project({2.5, 1, 8.2});
  EXPECT_TRUE(damage.Touches({static_cast<int>(window.x), static_cast<int>(window.y), 1, 1}));
  EXPECT_LE(damage.area(), 4 * 64 * 64);
  EXPECT_EQ(target_->Shown(), target_->Whole());
}

TEST_P(ScenePainting, FailuresAreToldAndThePictureStays) {
  Start();
  const auto good = Await({house_, kCamera});
  Camera bad = kCamera;
  bad.eye = bad.target;
  EXPECT_EQ(Await({house_, bad}), good);
  EXPECT_EQ(painter_->failure()->code, ErrorCode::kBadNumber);
  Camera huge = kCamera;
  huge.width_px = 1e5;
  EXPECT_EQ(Await({house_, huge}), good);
  EXPECT_EQ(painter_->failure()->code, ErrorCode::kGraphics);
  EXPECT_NE(Await({house_, kCamera}), good);
  EXPECT_FALSE(painter_->failure());
  EXPECT_EQ(Await({nullptr, kCamera})->camera, kCamera);
}

TEST_P(ScenePainting, PicturesOutliveTheirPainter) {
  Start();
  auto picture = Await({house_, kCamera});
  const Image before = Shown(picture);
  painter_.reset();
  target_->canvas().DamageAll();
  EXPECT_EQ(Shown(picture), before);
  target_->DestroyCanvas();
  picture.reset();
}

TEST_P(ScenePainting, EndsInTheMiddleOfAPicture) {
  Start({.tile_side_px = 64});
  const auto town = std::make_shared<Scene>(tests::Town(20, 5));
  painter_->Request({town, kCamera});
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  painter_.reset();
  EXPECT_LE(painted_, 1);
}

TEST_P(ScenePainting, ShownPicturesAreNeverTorn) {
  // Two pictures of one colour each: what is shown is one or the other, however fast they come.
  Start({.tile_side_px = 64});
  std::vector<std::shared_ptr<const Scene>> scenes;
  for (const Vec3f& color : {Vec3f(1, 0, 0), Vec3f(0, 0, 1)}) {
    Scene scene;
    scene.ground = false;
    scene.faces.push_back(
        {{{-900, -900, -9}, {900, -900, -9}, {0, 900, -9}}, color, color.r > 0 ? 1u : 2u});
    scenes.push_back(std::make_shared<Scene>(scene));
  }
  Camera camera;
  camera.width_px = kSize.x;
  camera.height_px = kSize.y;
  std::set<uint32_t> seen;
  for (int i = 0; i < 60; ++i) {
    const int before = painted_;
    painter_->Request({scenes[i % 2], camera});
    if (i % 4 != 0) painted_.wait(before);
    const auto picture = painter_->newest();
    if (!picture) continue;
    const Image image = Shown(picture);
    seen.insert(picture->ids[0]);
    const bool red = picture->ids[0] == 1;
    for (int y = 3; y < kSize.y; y += 13) {
      for (int x = 3; x < kSize.x; x += 13) {
        const glm::ivec3 pixel = PixelAt(image, x, y);
        ASSERT_EQ(pixel.r > pixel.b, red) << i << ": " << x << ", " << y;
      }
    }
  }
  EXPECT_EQ(seen.size(), 2u);
}

INSTANTIATE_TEST_SUITE_P(Targets, ScenePainting,
                         testing::Values(OffscreenTarget::kOsMesa,
                                         OffscreenTarget::kEglSurfaceless),
                         [](const auto& target) {
                           return target.param == OffscreenTarget::kOsMesa ? "OsMesa" : "Egl";
                         });

}  // namespace
}  // namespace parti::render
