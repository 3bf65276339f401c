#include "render/vertex_stream.h"

#include <utility>

namespace parti::render {

VertexStream::VertexStream(const Gl& gl, size_t stride,
                           const std::vector<VertexAttribute>& attributes, GLuint divisor)
    : gl_(&gl), stride_(stride), attributes_(&attributes), divisor_(divisor) {}

VertexStream::VertexStream(VertexStream&& other) noexcept
    : gl_(other.gl_),
      stride_(other.stride_),
      attributes_(other.attributes_),
      divisor_(other.divisor_),
      waiting_(std::move(other.waiting_)),
      blocks_(std::exchange(other.blocks_, {})) {}

VertexStream& VertexStream::operator=(VertexStream&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(stride_, other.stride_);
  std::swap(attributes_, other.attributes_);
  std::swap(divisor_, other.divisor_);
  std::swap(waiting_, other.waiting_);
  std::swap(blocks_, other.blocks_);
  return *this;
}

VertexStream::~VertexStream() {
  for (const Block& block : blocks_) {
    gl_->DeleteVertexArrays(1, &block.array);
    gl_->DeleteBuffers(1, &block.buffer);
  }
}

void VertexStream::Append(const void* vertices, size_t count) {
  const auto* bytes = static_cast<const std::byte*>(vertices);
  if (waiting_.size() + count * stride_ > kBlockBytes) Finish();
  waiting_.insert(waiting_.end(), bytes, bytes + count * stride_);
}

void VertexStream::Finish() {
  if (waiting_.empty()) return;
  Block block{0, 0, waiting_.size() / stride_};
  gl_->GenVertexArrays(1, &block.array);
  gl_->BindVertexArray(block.array);
  gl_->GenBuffers(1, &block.buffer);
  gl_->BindBuffer(GL_ARRAY_BUFFER, block.buffer);
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(waiting_.size()), waiting_.data(),
                  GL_STATIC_DRAW);
  for (const VertexAttribute& a : *attributes_) {
    gl_->EnableVertexAttribArray(a.location);
    // A byte offset into the bound buffer, passed as GL wants it: as a pointer.
    gl_->VertexAttribPointer(a.location, a.components, a.type, a.normalized ? GL_TRUE : GL_FALSE,
                             static_cast<GLsizei>(stride_),
                             static_cast<const std::byte*>(nullptr) + a.offset);
    gl_->VertexAttribDivisor(a.location, divisor_);
  }
  blocks_.push_back(block);
  waiting_.clear();
}

}  // namespace parti::render
