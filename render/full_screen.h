// One triangle that covers the whole viewport, for passes that colour every pixel.
// Two triangles would shade the pixels along their common diagonal twice.
#pragma once

#include <utility>

#include "render/gl.h"

namespace parti::render {

/// Its vertex shader places the corners by gl_VertexID. Used and destroyed while its context is
/// current.
class FullScreenTriangle {
 public:
  explicit FullScreenTriangle(const Gl& gl) : gl_(&gl) { gl.GenVertexArrays(1, &array_); }
  FullScreenTriangle(FullScreenTriangle&& other) noexcept
      : gl_(other.gl_), array_(std::exchange(other.array_, 0)) {}
  FullScreenTriangle& operator=(FullScreenTriangle&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(array_, other.array_);
    return *this;
  }
  ~FullScreenTriangle() {
    if (array_) gl_->DeleteVertexArrays(1, &array_);
  }

  /// With the program in use.
  void Draw() const {
    gl_->BindVertexArray(array_);
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  const Gl* gl_;
  GLuint array_ = 0;  ///< without attributes; core profiles draw nothing without one
};

}  // namespace parti::render
