// Faces that wear images, on each off-screen target.
#include <gtest/gtest.h>

#include <limits>

#include "render/gpu_textures.h"
#include "render/offscreen.h"
#include "tests/render/image_bytes.h"
#include "tests/support/golden.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

using tests::PixelAt;
using tests::Plain;
using tests::PngBytes;

EncodedImage Encoded(const Image& image) {
  return std::make_shared<const std::string>(PngBytes(image));
}

/// Red and green above blue and white.
EncodedImage FourColours() {
  Image image = Plain(2, 2, {255, 255, 255, 255});
  image.pixels = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  return Encoded(image);
}

/// A wall of 2 x 2 m that looks at the camera, the image `times` over each side.
Scene Wall(const EncodedImage& image, float times = 1) {
  Scene scene;
  scene.ground = false;
  Faces wall{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
  wall.color = {1, 1, 1};
  wall.id = 7;
  wall.image = image;
  for (const Vec3f& p : wall.corners) wall.uvs.push_back((Vec2f(p) + 1.0f) * 0.5f * times);
  scene.faces.push_back(std::move(wall));
  return scene;
}

/// The wall is 200 x 200 px in the middle of 240.
Camera Front() {
  Camera camera;
  camera.eye = {0, 0, 20};
  camera.target = {0, 0, 0};
  camera.width_px = camera.height_px = 240;
  camera.vertical_fov = Angle::Radians(2 * std::atan(1.2 / 20));
  return camera;
}

class FaceImages : public testing::TestWithParam<OffscreenTarget> {
 protected:
  void SetUp() override {
    auto created = OffscreenRenderer::Create(GetParam());
    if (!created) GTEST_SKIP() << FormatError(created.error());
    renderer_ = std::move(*created);
  }
  Image Draw(const Scene& scene) {
    Result<Image> image = renderer_->Draw(scene, Front());
    EXPECT_TRUE(image) << FormatError(image.error());
    return image.value_or(Image{});
  }
  std::unique_ptr<OffscreenRenderer> renderer_;
};

/// Which of red, green and blue are there, as bits from red on.
int Hue(const glm::ivec3& pixel) {
  return (pixel.r > 100 ? 1 : 0) | (pixel.g > 100 ? 2 : 0) | (pixel.b > 100 ? 4 : 0);
}

TEST_P(FaceImages, AnImageStandsUprightOnItsFace) {
  const Image picture = Draw(Wall(FourColours()));
  EXPECT_EQ(Hue(PixelAt(picture, 70, 70)), 1);
  EXPECT_EQ(Hue(PixelAt(picture, 170, 70)), 2);
  EXPECT_EQ(Hue(PixelAt(picture, 70, 170)), 4);
  EXPECT_EQ(Hue(PixelAt(picture, 170, 170)), 7);
}

TEST_P(FaceImages, AnImageRepeatsBeyondItsEdges) {
  const Image picture = Draw(Wall(FourColours(), 2));
  for (const int y : {45, 145}) {
    for (const int x : {45, 145}) {
      EXPECT_EQ(Hue(PixelAt(picture, x, y)), 1);
      EXPECT_EQ(Hue(PixelAt(picture, x + 50, y + 50)), 7);
    }
  }
}

TEST_P(FaceImages, ItsColoursAreThoseOfFacesOfOneColour) {
  Scene plain = Wall(nullptr);
  plain.faces[0].color = Vec3f(120, 160, 200) / 255.0f;
  EXPECT_EQ(parti::tests::Compare(Draw(Wall(Encoded(Plain(4, 4, {120, 160, 200, 255})))),
                                  Draw(plain), {2, 0})
                .pixels,
            0u);
  // White, worn by a coloured face, is the face's colour.
  Scene tinted = Wall(Encoded(Plain(4, 4, {255, 255, 255, 255})));
  tinted.faces[0].color = plain.faces[0].color;
  EXPECT_EQ(parti::tests::Compare(Draw(tinted), Draw(plain), {2, 0}).pixels, 0u);
}

TEST_P(FaceImages, FromAfarAnImageIsTheMeanOfItsLight) {
  Image board = Plain(256, 256, {0, 0, 0, 255});
  for (int i = 0; i < 256 * 256; ++i) {
    const bool white = (i % 256 + i / 256) % 2 == 0;
    for (int k = 0; k < 3; ++k) board.pixels[4 * i + k] = white ? 255 : 0;
  }
  Scene plain = Wall(nullptr);
  plain.faces[0].color = Vec3f(188) / 255.0f;  // half the light, in sRGB
  EXPECT_EQ(parti::tests::Compare(Draw(Wall(Encoded(board), 8)), Draw(plain), {3, 0}).pixels, 0u);
}

TEST_P(FaceImages, ADamagedImageLeavesTheColour) {
  Scene plain = Wall(nullptr);
  plain.faces[0].color = {0.8f, 0.5f, 0.2f};
  for (const char* bytes : {"", "\x89PNG but no more", "\xff\xd8\xff"}) {
    Scene damaged = plain;
    damaged.faces[0].image = std::make_shared<const std::string>(bytes);
    EXPECT_EQ(Draw(damaged), Draw(plain)) << bytes;
  }
}

TEST_P(FaceImages, CoordinatesThatAreMissingOrNotFiniteAreTheCorner) {
  Scene scene = Wall(FourColours());
  scene.faces[0].uvs = {{std::numeric_limits<float>::quiet_NaN(), 0}, {0, INFINITY}};
  Scene corner = Wall(FourColours());
  corner.faces[0].uvs.assign(6, {0, 0});
  EXPECT_EQ(Draw(scene), Draw(corner));
}

TEST_P(FaceImages, FacesWithAndWithoutHideEachOtherAndHaveTheirIds) {
  Scene scene = Wall(FourColours());
  Faces before{{{-0.5f, -0.5f, 1}, {0.5f, -0.5f, 1}, {0, 0.5f, 1}}, {0.2f, 0.2f, 0.2f}, 8};
  scene.faces.push_back(before);
  for (Vec3f& p : before.corners) p.z = -1;
  before.id = 9;
  scene.faces.push_back(before);
  const auto ids = renderer_->DrawIds(scene, Front());
  ASSERT_TRUE(ids);
  EXPECT_EQ((*ids)[size_t{240} * 120 + 120], 8u);
  EXPECT_EQ((*ids)[size_t{240} * 30 + 30], 7u);
  EXPECT_EQ(std::count(ids->begin(), ids->end(), 9u), 0);
  EXPECT_LT(PixelAt(Draw(scene), 120, 120).g, 100);
}

INSTANTIATE_TEST_SUITE_P(Targets, FaceImages,
                         testing::Values(OffscreenTarget::kOsMesa,
                                         OffscreenTarget::kEglSurfaceless),
                         [](const auto& target) {
                           return target.param == OffscreenTarget::kOsMesa ? "OsMesa" : "Egl";
                         });

TEST(GpuTextures, UploadsAnImageOnceAndKeepsItForTheNextScene) {
  auto context = CreateOffscreenContext();
  ASSERT_TRUE(context) << FormatError(context.error());
  const CurrentScope current(**context);
  const Gl gl = *LoadGl((*context)->Lookup(), (*context)->is_gles());
  const EncodedImage a = FourColours(), b = FourColours();
  const auto damaged = std::make_shared<const std::string>("none");
  GpuTextures first(gl);
  const GLuint texture = first.Of(a);
  EXPECT_NE(texture, 0u);
  EXPECT_EQ(first.Of(a), texture);
  EXPECT_NE(first.Of(b), texture);
  EXPECT_EQ(first.Of(damaged), 0u);
  GpuTextures second(gl, std::move(first));
  EXPECT_EQ(second.Of(a), texture);
  second.Forget();
  EXPECT_EQ(second.Of(a), texture);
  EXPECT_TRUE(CheckGl(gl, "keeping textures"));
}

}  // namespace
}  // namespace parti::render
