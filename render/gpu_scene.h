// A Scene as the GPU holds it: uploaded once, drawn from as many views as wanted.
// What can't be drawn stays behind here, so that passes need not check anything.
#pragma once

#include <vector>

#include "render/bounds.h"
#include "render/face_streams.h"
#include "render/gl_framebuffer.h"
#include "render/gpu_textures.h"

namespace parti::render {

/// Wider lines are drawn with this width. [px]
inline constexpr float kWidestLine_px = 64;

/// Consecutive strokes of one colour, drawn as one.
struct InkGroup {
  Vec4f color;
  VertexStream pieces;
};

/// All faces that wear one image.
struct ImageFaces {
  GLuint texture;
  FaceStreams faces;
};

/// Left out, silently since they can't be seen: triangles with a corner that is not drawable (see
/// IsDrawable) or without area, lines with such an end, ink pieces with such a sample, what is left
/// over from whole triangles and lines. Missing ink widths are 1 px, negative ones 0.
struct GpuScene {
  /// `old_textures`: of a scene that is not drawn any more; what both wear is not uploaded again.
  GpuScene(const Gl& gl, const Scene& scene, GpuTextures old_textures);

  FaceStreams plain_faces;
  std::vector<ImageFaces> image_faces;  ///< in the order in which the scene wears images first
  VertexStream lines;
  VertexStream lines_on_top;
  std::vector<InkGroup> ink;
  bool ground;
  bool has_covered_lines;  ///< lines that lie behind faces (Lines::behind)
  GpuTextures textures;
  /// Draws all faces without their images, and without the back sides of closed ones.
  void DrawAllFaces(const Gl& gl) const;
  /// The same, but only what may lie in the volume.
  void DrawFacesNearFirst(const Gl& gl, const DrawVolume& volume) const;

  Bounds face_bounds;
  Bounds bounds;  ///< lines too

 private:
  void UploadFaces(const Gl& gl, const Scene& scene);
};

}  // namespace parti::render
