#include "render/frame.h"

namespace parti::render {

Frame::Frame(const Camera& camera, const Bounds& bounds, const Tile& part, const Look& numbers)
    : look(numbers),
      view(camera),
      size(PictureSize(camera)),
      tile(part),
      range(DepthRangeFor(bounds, camera)),
      clip_from_world(ClipFromWorld(camera, range)),
      eye(camera.eye) {}

void ShadowLookup::Set(const Gl& gl, const GlProgram& program) const {
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  program.Set("shadow_map", 0);
  program.Set("shadow_texel", texel);
  program.Set("shadow_from_world", shadow_from_world);
  program.Set("shadow_bias", bias_m);
}

}  // namespace parti::render
