// What all passes of one picture share: the camera as shaders want it, and the look.
#pragma once

#include "render/bounds.h"
#include "render/gl_program.h"
#include "render/look.h"

namespace parti::render {

/// The part of a picture that is drawn at once: pixels from its lower left corner, y up. Large
/// pictures are drawn in tiles so that multisampling's memory stays bounded.
struct Tile {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Frame {
  Frame(const Camera& camera, const Bounds& bounds, const Tile& tile, const Look& look);

  const Look& look;
  View view;
  glm::ivec2 size;  ///< of the whole picture, px
  Tile tile;
  DepthRange range;
  glm::mat4 clip_from_world;
  Vec3f eye;

  /// Viewport such that the tile of the whole picture falls on the framebuffer.
  void SetViewport(const Gl& gl) const { gl.Viewport(-tile.x, -tile.y, size.x, size.y); }
};

/// The sun's shadow of a scene as shaders look it up.
struct ShadowLookup {
  GLuint texture = 0;
  glm::mat4 shadow_from_world{1};  ///< x, y, z in [0, 1] within the map
  float bias_m = 0;
  float texel = 1;  ///< of the map's side

  /// Binds the map to texture unit 0 and sets light.glsl's uniforms of the program in use.
  void Set(const Gl& gl, const GlProgram& program) const;
};

}  // namespace parti::render
