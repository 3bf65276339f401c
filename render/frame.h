// What all passes of one picture share: the camera as shaders want it, and the look.
// Worked out on the CPU in double precision; passes only hand it on.
#pragma once

#include "render/bounds.h"
#include "render/draw_volume.h"
#include "render/gl_program.h"
#include "render/look.h"

namespace parti::render {

/// The part of a picture that is drawn at once: pixels from its lower left corner, y up. Large
/// pictures are drawn in tiles so that multisampling's memory stays bounded.
struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
};

/// How finely a picture is drawn.
struct Detail {
  bool many_samples = true;  ///< Look::samples a pixel; else one: jagged faces, at half the cost
  /// Pixels of the picture for one of the view that it is shown in: lines are this much narrower.
  double scale = 1;
};

/// One tile of one picture. `look` must outlive it; the camera must be valid.
struct Frame {
  /// Depth range and matrix are chosen so that `bounds` fit.
  Frame(const Camera& camera, const Bounds& bounds, const Tile& tile, const Look& look,
        const Detail& detail = {});

  const Look& look;
  Detail detail;
  View view;
  glm::ivec2 size;  ///< of the whole picture, px
  Tile tile;
  DepthRange range;
  glm::mat4 clip_from_world;
  Vec3f eye;
  /// How far clip z moves when a point moves away by its own distance to the eye; the same
  /// everywhere, and x, y and w don't move at all.
  float depth_unit;
  DrawVolume volume;    ///< what the tile shows, and lines whose width reaches into it
  double pixels_per_m;  ///< at the nearest point of the bounds
  double pixels_per_m_at_1_m;

  /// Viewport such that the tile of the whole picture falls on the framebuffer.
  void SetViewport(const Gl& gl) const { gl.Viewport(-tile.x, -tile.y, size.x, size.y); }
};

/// The sun's shadow of a scene as shaders look it up.
struct ShadowLookup {
  GLuint texture = 0;
  glm::mat4 shadow_from_world{1};  ///< x, y, z in [0, 1] within the map
  float bias_m = 0;
  float texel = 1;    ///< of the map's side
  float texel_m = 1;  ///< in the world
};

/// Binds the map to texture unit 0 and sets light.glsl's uniforms of the program in use. Where its
/// texels are smaller than the picture's pixels, one tap is soft enough.
void SetShadow(const Gl& gl, const GlProgram& program, const ShadowLookup& shadow,
               const Frame& frame);

}  // namespace parti::render
