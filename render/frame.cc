#include "render/frame.h"

#include "render/gpu_scene.h"

namespace parti::render {
namespace {

DrawVolume VolumeOf(const glm::mat4& clip_from_world, const Tile& tile, const glm::ivec2& size,
                    const Vec3& eye) {
  constexpr float kMargin_px = 0.5f * kWidestLine_px + 1;
  const Vec2f low = Vec2f(tile.x, tile.y) - kMargin_px;
  const Vec2f high = Vec2f(tile.x + tile.width, tile.y + tile.height) + kMargin_px;
  return {clip_from_world, low * 2.0f / Vec2f(size) - 1.0f, high * 2.0f / Vec2f(size) - 1.0f, eye};
}

}  // namespace

Frame::Frame(const Camera& camera, const Bounds& bounds, const Tile& part, const Look& numbers,
             const Detail& wanted)
    : look(numbers),
      detail(wanted),
      view(camera),
      size(PictureSize(camera)),
      tile(part),
      range(DepthRangeFor(bounds, camera)),
      clip_from_world(ClipFromWorld(camera, range)),
      eye(camera.eye),
      depth_unit(static_cast<float>(2 * range.far_m * range.near_m / (range.far_m - range.near_m))),
      volume(VolumeOf(clip_from_world, tile, size, camera.eye)),
      pixels_per_m(view.PixelsPerMetre(camera.eye + view.forward() * range.near_m)),
      pixels_per_m_at_1_m(view.PixelsPerMetre(camera.eye + view.forward())) {}

void SetShadow(const Gl& gl, const GlProgram& program, const ShadowLookup& shadow,
               const Frame& frame) {
  constexpr double kTapsApart = 0.75;  // texels: the four filters overlap evenly
  const bool soft = shadow.texel_m * frame.pixels_per_m > 0.7;
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, shadow.texture);
  program.Set("shadow_map", 0);
  program.Set("shadow_soft", soft ? static_cast<float>(kTapsApart * shadow.texel) : 0.0f);
  program.Set("shadow_from_world", shadow.shadow_from_world);
  program.Set("shadow_bias", shadow.bias_m);
}

}  // namespace parti::render
