// What a canvas shows, on each off-screen target that the machine has.
#include "render/canvas.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <limits>

#include "tests/support/canvas_target.h"
#include "tests/support/golden.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

using tests::CanvasTarget;
using tests::PixelAt;
using tests::PlainPicture;

constexpr glm::ivec2 kSize{200, 120};
constexpr Vec4f kBlue{0.05f, 0.1f, 0.45f, 1};

class CanvasOn : public testing::TestWithParam<OffscreenTarget> {
 protected:
  void SetUp() override {
    target_ = CanvasTarget::Create(GetParam(), kSize);
    if (!target_) GTEST_SKIP() << "no such context";
  }
  Canvas& canvas() { return target_->canvas(); }
  Image Drawn() {
    (void)target_->Draw();
    return target_->Shown();
  }
  std::unique_ptr<CanvasTarget> target_;
};

void AddStroke(Canvas* canvas, uint64_t id, const Vec4f& color, const std::vector<Vec2f>& points,
               float width) {
  canvas->BeginStroke(id, color);
  canvas->AddSamples(points, std::vector<float>(points.size(), width));
  canvas->EndStroke();
}

std::shared_ptr<const Ink> InkFrom(const std::vector<Vec2f>& points, float width,
                                   const Vec4f& color) {
  return std::make_shared<Ink>(Ink{points, std::vector<float>(points.size(), width), color});
}

TEST_P(CanvasOn, AnEmptyCanvasIsPaper) {
  const Image image = Drawn();
  for (int y = 0; y < kSize.y; y += 7) {
    EXPECT_EQ(PixelAt(image, 3, y), PixelAt(image, 0, 0));
    EXPECT_GT(PixelAt(image, 3, y).g, 235);
  }
  EXPECT_EQ(image.pixels[3], 255);
}

TEST_P(CanvasOn, APictureIsShownByteForByte) {
  for (const Vec3f& color : {Vec3f(0.5f, 0.25f, 0.1f), Vec3f(0.99f, 0.02f, 0.72f)}) {
    canvas().SetPicture(PlainPicture(target_->gl(), kSize, color));
    const Image image = Drawn();
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(PixelAt(image, 100, 60)[c], std::lround(color[c] * 255));
    }
  }
}

TEST_P(CanvasOn, InkIsAsRendererDrawsIt) {
  // The same strokes in a scene on plain paper, translucent ones and two colours among them.
  Scene scene;
  scene.ground = false;
  scene.ink = {{{{20, 20}, {60, 30}, {110, 90}}, {2, 9, 3}, kBlue},
               {{{30, 90}, {90, 20}}, {8, 8}, {0.8f, 0.1f, 0.1f, 0.5f}},
               {{{30, 20}, {90, 90}}, {8, 8}, {0.8f, 0.1f, 0.1f, 0.5f}},
               {{{150, 50}}, {12}, kBlue}};
  auto renderer = OffscreenRenderer::Create(GetParam());
  Camera camera;
  camera.width_px = kSize.x;
  camera.height_px = kSize.y;
  target_->context().Release();
  const Image paper = *(*renderer)->Draw({{}, {}, {}, false}, camera);
  const Image expected = *(*renderer)->Draw(scene, camera);
  ASSERT_TRUE(target_->context().MakeCurrent());
  const glm::ivec3 plain = PixelAt(paper, 0, 60);
  canvas().SetPaper(Vec3f(plain) / 255.0f);
  uint64_t id = 0;
  for (const Ink& ink : scene.ink) {
    canvas().BeginStroke(++id, ink.color);
    for (size_t i = 0; i < ink.points.size(); ++i) {
      canvas().AddSamples({&ink.points[i], 1}, {&ink.widths_px[i], 1});
      (void)target_->Draw();
    }
    canvas().EndStroke();
  }
  const Image image = Drawn();
  // The paper of a scene is a little lighter towards its upper side; compare what ink did to it.
  for (int y = 0; y < kSize.y; ++y) {
    for (int x = 0; x < kSize.x; ++x) {
      const glm::ivec3 did = PixelAt(expected, x, y) - PixelAt(paper, x, y);
      const glm::ivec3 does = PixelAt(image, x, y) - plain;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(did[c], does[c], 9) << x << ", " << y;
    }
  }
}

TEST_P(CanvasOn, OnlyWhatChangedIsDamaged) {
  (void)target_->Draw();
  EXPECT_FALSE(canvas().NeedsDraw());
  EXPECT_TRUE(target_->Draw().empty());
  canvas().BeginStroke(1, kBlue);
  const std::vector<Vec2f> points = {{50, 50}, {60, 50}};
  canvas().AddSamples(points, std::vector<float>{4, 4});
  EXPECT_TRUE(canvas().NeedsDraw());
  const Damage damage = target_->Draw();
  ASSERT_EQ(damage.rects().size(), 1u);
  EXPECT_EQ(damage.rects()[0], (PixelRect{47, 47, 16, 6}));
  EXPECT_FALSE(canvas().NeedsDraw());
}

TEST_P(CanvasOn, APredictionIsShownAndTakenBack) {
  const Image before = Drawn();
  canvas().BeginStroke(1, kBlue);
  canvas().AddSamples(std::vector<Vec2f>{{20, 50}, {60, 50}}, std::vector<float>{6, 6});
  const Image drawn = Drawn();
  canvas().SetPrediction(std::vector<Vec2f>{{80, 50}, {100, 60}}, std::vector<float>{6, 6});
  EXPECT_LT(PixelAt(Drawn(), 80, 50).r, 60);
  canvas().SetPrediction({}, {});
  EXPECT_EQ(Drawn(), drawn);
  canvas().SetPrediction(std::vector<Vec2f>{{80, 90}}, std::vector<float>{6});
  canvas().EndStroke();
  EXPECT_EQ(Drawn(), drawn);
  canvas().SetStrokes({});
  EXPECT_EQ(Drawn(), before);
}

TEST_P(CanvasOn, ACancelledStrokeLeavesNothingAndHarmsNothing) {
  AddStroke(&canvas(), 1, kBlue, {{20, 20}, {150, 100}}, 5);
  const Image before = Drawn();
  for (const Vec4f& color : {kBlue, Vec4f(0.7f, 0, 0, 0.5f)}) {
    canvas().BeginStroke(2, color);
    canvas().AddSamples(std::vector<Vec2f>{{20, 100}, {150, 20}}, std::vector<float>{9, 9});
    EXPECT_NE(Drawn(), before);
    canvas().CancelStroke();
    EXPECT_EQ(Drawn(), before);
  }
}

TEST_P(CanvasOn, StrokesThatStayAreNotDrawnAgain) {
  AddStroke(&canvas(), 7, kBlue, {{20, 20}, {150, 100}}, 5);
  (void)target_->Draw();
  const auto same = InkFrom({{20, 20}, {150, 100}}, 5, kBlue);
  canvas().SetStrokes({{7, same}});
  EXPECT_FALSE(canvas().NeedsDraw());
  canvas().SetStrokes({{7, same}, {8, InkFrom({{10, 100}, {20, 110}}, 3, kBlue)}});
  EXPECT_LT(target_->Draw().area(), 17 * 17);
}

TEST_P(CanvasOn, HugeAndSenselessInkIsDrawnAsFarAsItCanBe) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  const Image before = Drawn();
  AddStroke(&canvas(), 1, kBlue, {{kNan, 1}, {3, kInf}, {-kInf, kNan}}, 4);
  AddStroke(&canvas(), 2, kBlue, {}, 4);
  EXPECT_EQ(Drawn(), before);
  AddStroke(&canvas(), 3, kBlue, {{-1e6f, 60}, {1e6f, 60}}, 4);
  EXPECT_LT(PixelAt(Drawn(), 100, 60).r, 60);
  AddStroke(&canvas(), 4, {kNan, 2, -3, kInf}, {{50, 20}, {kNan, 0}, {60, 20}}, kInf);
  AddStroke(&canvas(), 5, kBlue, {{50, 20}, {60, 20}}, 1e30f);
  const Image full = Drawn();
  EXPECT_LT(PixelAt(full, 199, 0).r, 60);
  EXPECT_EQ(full, target_->Whole());
}

UiMesh Panel(const PixelRect& r, uint32_t rgba) {
  const Vec2f low(static_cast<float>(r.x), static_cast<float>(r.y));
  const Vec2f high = low + Vec2f(static_cast<float>(r.width), static_cast<float>(r.height));
  UiMesh mesh;
  mesh.vertices = {{low, {0, 0}, rgba},
                   {{high.x, low.y}, {1, 0}, rgba},
                   {high, {1, 1}, rgba},
                   {{low.x, high.y}, {0, 1}, rgba}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.commands = {{{0, 0, 4000, 4000}, 1, 0, 6}};
  return mesh;
}

const Image kWhite{1, 1, {255, 255, 255, 255}};

TEST_P(CanvasOn, PanelsLieOverInkAndAreClipped) {
  ASSERT_TRUE(canvas().SetPanelTexture(1, kWhite));
  AddStroke(&canvas(), 1, kBlue, {{20, 50}, {180, 50}}, 8);
  UiMesh mesh = Panel({60, 20, 80, 60}, 0xff2040c0);
  mesh.commands[0].clip = {60, 20, 40, 60};
  canvas().SetPanels(mesh);
  const Image image = Drawn();
  EXPECT_EQ(PixelAt(image, 80, 50), (glm::ivec3{0xc0, 0x40, 0x20}));
  EXPECT_LT(PixelAt(image, 120, 50).r, 60);
  mesh.vertices[0].rgba = 0xff2040c1;
  canvas().SetPanels(mesh);
  EXPECT_EQ(target_->Draw().area(), 40 * 60);
  canvas().SetPanels({});
  EXPECT_EQ(PixelAt(Drawn(), 80, 30), PixelAt(image, 120, 30));
}

TEST_P(CanvasOn, PartsOfPanelsFadeAndOnlyTheirPixelsAreDrawn) {
  ASSERT_TRUE(canvas().SetPanelTexture(1, kWhite));
  const int paper = PixelAt(Drawn(), 80, 50).r;
  UiMesh mesh = Panel({60, 20, 80, 60}, 0xff000000);
  mesh.commands[0].clip = {60, 20, 40, 60};
  mesh.commands.push_back(mesh.commands[0]);
  mesh.commands[1].clip = {100, 20, 40, 60};
  mesh.commands[1].part = 1;
  canvas().SetPanels(mesh);
  Drawn();
  canvas().SetPanelOpacities(std::array{1.0f, 0.5f});
  EXPECT_EQ(target_->Draw().area(), 40 * 60);
  Image image = Drawn();
  EXPECT_EQ(PixelAt(image, 80, 50).r, 0);
  EXPECT_NEAR(PixelAt(image, 120, 50).r, paper * 0.5, 2);
  canvas().SetPanelOpacities(std::array{1.0f, 0.5f});
  EXPECT_FALSE(canvas().NeedsDraw()) << "as it is already";
  canvas().SetPanelOpacities(std::array{0.0f});
  image = Drawn();
  EXPECT_EQ(PixelAt(image, 80, 50).r, paper);
  EXPECT_EQ(PixelAt(image, 120, 50).r, 0) << "a part without a number is there";
}

TEST_P(CanvasOn, SenselessPanelsShowNothing) {
  ASSERT_TRUE(canvas().SetPanelTexture(1, kWhite));
  const Image before = Drawn();
  UiMesh mesh = Panel({60, 20, 80, 60}, 0xff2040c0);
  mesh.commands = {{{0, 0, 200, 200}, 99, 0, 6},  // no such texture
                   {{0, 0, 200, 200}, 1, 3, 6},   // indices that aren't there
                   {{0, 0, 200, 200}, 1, 0xfffffff0, 60},
                   {{-50, -50, 10, 10}, 1, 0, 6},
                   {{0, 0, 0, 0}, 1, 0, 6},
                   {{0, 0, 200, 200}, 1, 0, 0}};
  canvas().SetPanels(mesh);
  EXPECT_EQ(Drawn(), before);
  mesh = Panel({60, 20, 80, 60}, 0xff2040c0);
  mesh.indices[5] = 77;
  canvas().SetPanels(mesh);
  EXPECT_EQ(Drawn(), before);
  mesh.indices[5] = 3;
  mesh.vertices[2].px.x = std::numeric_limits<float>::quiet_NaN();
  canvas().SetPanels(mesh);
  EXPECT_EQ(Drawn(), before);
  EXPECT_FALSE(canvas().SetPanelTexture(2, {2, 2, {1, 2, 3}}));
}

TEST_P(CanvasOn, MarksLieBelowAndAbovePanels) {
  ASSERT_TRUE(canvas().SetPanelTexture(1, kWhite));
  canvas().SetPanels(Panel({60, 20, 80, 60}, 0xffffffff));
  const Mark line{{{20.5f, 50.5f}, {180.5f, 50.5f}}, {0.8f, 0, 0, 1}, 3, 0};
  canvas().SetMarksBelowPanels({line});
  Image image = Drawn();
  EXPECT_EQ(PixelAt(image, 30, 50), (glm::ivec3{204, 0, 0}));
  EXPECT_EQ(PixelAt(image, 100, 50), (glm::ivec3{255, 255, 255}));
  canvas().SetMarksBelowPanels({});
  canvas().SetMarksAbovePanels({line});
  image = Drawn();
  EXPECT_EQ(PixelAt(image, 100, 50), (glm::ivec3{204, 0, 0}));
  canvas().SetMarksAbovePanels({line, {{{9, 9}}, {0, 0, 0, 1}, 4, 0}});
  EXPECT_LT(target_->Draw().area(), 100);
}

TEST_P(CanvasOn, ResizingKeepsWhatLiesWithin) {
  AddStroke(&canvas(), 1, kBlue, {{20, 50}, {180, 50}}, 8);
  canvas().SetMarksAbovePanels({{{{0, 20}, {300, 20}}, {0, 0, 0, 1}, 4, 0}});
  const Image before = Drawn();
  target_->Resize({300, 90});
  const Image after = Drawn();
  for (int x = 0; x < 195; x += 5) EXPECT_EQ(PixelAt(after, x, 50), PixelAt(before, x, 50)) << x;
  EXPECT_LT(PixelAt(after, 290, 20).r, 60);
  target_->Resize({1, 1});
  (void)target_->Draw();
  target_->Resize(kSize);
  EXPECT_EQ(Drawn(), before);
  EXPECT_FALSE(canvas().Resize({1 << 20, 4}));
  EXPECT_EQ(canvas().size(), kSize);
}

TEST_P(CanvasOn, APictureIsKeptUntilNoFrameNeedsIt) {
  CanvasPicture first = PlainPicture(target_->gl(), kSize, {1, 0, 0});
  const std::weak_ptr<const void> watch = first.keep;
  canvas().SetPicture(std::move(first));
  (void)target_->Draw();
  canvas().SetPicture(PlainPicture(target_->gl(), kSize, {0, 1, 0}));
  EXPECT_FALSE(watch.expired());
  (void)target_->Draw();
  target_->gl().Finish();
  canvas().DamageAll();
  (void)target_->Draw();
  EXPECT_TRUE(watch.expired());
}

TEST_P(CanvasOn, AllLayers) {
  const glm::ivec2 size{640, 400};
  target_->Resize(size);
  const Camera camera = tests::HouseCamera(size.x, size.y);
  target_->context().Release();
  const Image house = *(*OffscreenRenderer::Create(GetParam()))->Draw(tests::House(), camera);
  ASSERT_TRUE(target_->context().MakeCurrent());
  CanvasPicture picture = PlainPicture(target_->gl(), size, {1, 1, 1});
  Image flipped = house;
  for (int y = 0; y < size.y; ++y) {
    const auto* row = &house.pixels[size_t{4} * size.x * (size.y - 1 - y)];
    std::copy(row, row + size_t{4} * size.x, &flipped.pixels[size_t{4} * size.x * y]);
  }
  target_->gl().BindTexture(GL_TEXTURE_2D, picture.texture);
  target_->gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                              flipped.pixels.data());
  canvas().SetPicture(picture);
  AddStroke(&canvas(), 1, kBlue, {{150, 140}, {152, 90}, {260, 60}, {380, 90}}, 3);
  AddStroke(&canvas(), 2, {0.9f, 0.6f, 0.1f, 0.45f}, {{200, 250}, {420, 240}, {210, 262}}, 16);
  canvas().BeginStroke(3, kBlue);
  std::vector<Vec2f> points;
  std::vector<float> widths;
  for (int i = 0; i < 40; ++i) {
    const float t = static_cast<float>(i) / 39;
    points.emplace_back(420 + 120 * t, 300 - 60 * std::sin(6 * t));
    widths.push_back(1 + 4 * std::sin(3 * t));
  }
  canvas().AddSamples(points, widths);
  canvas().SetPrediction(std::vector<Vec2f>{{555, 322}}, std::vector<float>{1});
  canvas().SetMarksBelowPanels(
      {{{{100, 200}, {300, 160}, {460, 190}}, {0.85f, 0.3f, 0.1f, 0.9f}, 2, 7}});
  canvas().SetMarksAbovePanels({{{{555, 322}}, {0.1f, 0.1f, 0.1f, 1}, 5, 0}});
  ASSERT_TRUE(canvas().SetPanelTexture(1, kWhite));
  canvas().SetPanels(Panel({12, 12, 110, 150}, 0xd8ffffff));
  parti::tests::ExpectGolden(Drawn(), "render_canvas");
}

INSTANTIATE_TEST_SUITE_P(
    Targets, CanvasOn, testing::Values(OffscreenTarget::kOsMesa, OffscreenTarget::kEglSurfaceless),
    [](const auto& target) { return target.param == OffscreenTarget::kOsMesa ? "OsMesa" : "Egl"; });

}  // namespace
}  // namespace parti::render
