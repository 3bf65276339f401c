#include "render/piece_batch.h"

#include <algorithm>
#include <utility>

namespace parti::render {
namespace {

constexpr size_t kMostBytes = size_t{1} << 20;  // sent at once

}  // namespace

PieceBatch::PieceBatch(const Gl& gl) : gl_(&gl) {
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  gl.GenBuffers(1, &buffer_);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
  for (const VertexAttribute& a : InkLayout()) {
    gl.EnableVertexAttribArray(a.location);
    // A byte offset into the bound buffer, passed as GL wants it: as a pointer.
    gl.VertexAttribPointer(a.location, a.components, a.type, GL_FALSE, sizeof(InkPiece),
                           reinterpret_cast<const void*>(a.offset));
    gl.VertexAttribDivisor(a.location, 1);
  }
}

PieceBatch::PieceBatch(PieceBatch&& other) noexcept
    : gl_(other.gl_),
      array_(std::exchange(other.array_, 0)),
      buffer_(std::exchange(other.buffer_, 0)) {}

PieceBatch& PieceBatch::operator=(PieceBatch&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(array_, other.array_);
  std::swap(buffer_, other.buffer_);
  return *this;
}

PieceBatch::~PieceBatch() {
  if (!array_) return;
  gl_->DeleteVertexArrays(1, &array_);
  gl_->DeleteBuffers(1, &buffer_);
}

void PieceBatch::Draw(std::span<const InkPiece> pieces) const {
  constexpr size_t kMost = kMostBytes / sizeof(InkPiece);
  gl_->BindVertexArray(array_);
  gl_->BindBuffer(GL_ARRAY_BUFFER, buffer_);
  for (size_t i = 0; i < pieces.size(); i += kMost) {
    const auto part = pieces.subspan(i, std::min(kMost, pieces.size() - i));
    gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(part.size_bytes()), part.data(),
                    GL_STREAM_DRAW);
    gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(part.size()));
  }
}

}  // namespace parti::render
