// Ink pieces that are drawn once and forgotten: each Draw sends its own.
// What stays on the GPU is VertexStream's.
#pragma once

#include <span>

#include "render/ink_pieces.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class PieceBatch {
 public:
  explicit PieceBatch(const Gl& gl);
  PieceBatch(PieceBatch&& other) noexcept;
  PieceBatch& operator=(PieceBatch&& other) noexcept;
  ~PieceBatch();

  /// With the program "ink" in use. Memory on the GPU is bounded, however many pieces.
  void Draw(std::span<const InkPiece> pieces) const;

 private:
  const Gl* gl_;
  GLuint array_ = 0, buffer_ = 0;
};

}  // namespace parti::render
