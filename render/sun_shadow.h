// The depth of a scene as the sun sees it, drawn once a scene since the sun stands still.
// Where it falls is decided by the shaders (light.glsl).
#pragma once

#include <optional>

#include "render/frame.h"
#include "render/gl_framebuffer.h"
#include "render/gpu_scene.h"

namespace parti::render {

/// The map that fits the scene's faces, seen along parallel rays from the sun: [0, 1] in x, y, z.
/// `side` texels square; bias as Look says. Properties: (1) every corner of the bounds lies inside;
/// (2) points along one ray of the sun share x and y.
ShadowLookup ShadowLookupFor(const Bounds& faces, const Look& look);

/// Used and destroyed while its context is current.
class SunShadow {
 public:
  /// `instead_of`: a shadow that is not needed any more, of the same look; its map is drawn over.
  /// A map is 16 MiB, and llvmpipe may hold a deleted one for as long as it likes.
  /// errors  kGraphics.
  static Result<SunShadow> Create(const Gl& gl, const GlProgram& depth_program,
                                  const GpuScene& scene, const Look& look,
                                  std::optional<SunShadow> instead_of = {});
  const ShadowLookup& lookup() const { return lookup_; }

 private:
  SunShadow(GlFramebuffer map, const ShadowLookup& lookup)
      : map_(std::move(map)), lookup_(lookup) {}
  GlFramebuffer map_;
  ShadowLookup lookup_;
};

}  // namespace parti::render
