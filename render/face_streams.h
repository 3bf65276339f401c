// Faces as the GPU holds them: open ones apart from closed ones, with or without image coordinates.
// Which image they wear, and how they are lit, is not known here.
#pragma once

#include "render/vertex_stream.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class FaceStreams {
 public:
  explicit FaceStreams(const Gl& gl, bool with_uvs = false);

  /// Left out: triangles with a corner that is not drawable (see IsDrawable) or without area, and
  /// what is left over from whole triangles.
  void Append(const Faces& faces);
  /// To be called once all is appended.
  void Finish();

  /// All faces, without the back sides of closed ones.
  void Draw(const Gl& gl) const;
  /// The same, but only what may lie in the volume, near ones first.
  void DrawNearFirst(const Gl& gl, const DrawVolume& volume) const;

 private:
  bool with_uvs_;
  VertexStream open_;
  VertexStream closed_;
};

}  // namespace parti::render
