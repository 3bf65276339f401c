#include "render/vertex_stream.h"

#include <algorithm>
#include <utility>

namespace parti::render {

VertexStream::VertexStream(const Gl& gl, Primitive primitive, size_t stride,
                           const std::vector<VertexAttribute>& attributes)
    : gl_(&gl), primitive_(primitive), stride_(stride), attributes_(&attributes) {}

VertexStream::VertexStream(VertexStream&& other) noexcept
    : gl_(other.gl_),
      primitive_(other.primitive_),
      stride_(other.stride_),
      attributes_(other.attributes_),
      waiting_(std::move(other.waiting_)),
      waiting_box_(other.waiting_box_),
      blocks_(std::exchange(other.blocks_, {})) {}

VertexStream& VertexStream::operator=(VertexStream&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(stride_, other.stride_);
  std::swap(attributes_, other.attributes_);
  std::swap(primitive_, other.primitive_);
  std::swap(waiting_, other.waiting_);
  std::swap(waiting_box_, other.waiting_box_);
  std::swap(blocks_, other.blocks_);
  return *this;
}

VertexStream::~VertexStream() {
  for (const Block& block : blocks_) {
    gl_->DeleteVertexArrays(1, &block.array);
    gl_->DeleteBuffers(1, &block.buffer);
  }
}

void VertexStream::Append(const void* vertices, std::span<const Vec3f> corners) {
  const auto* bytes = static_cast<const std::byte*>(vertices);
  const size_t size = (primitive_ == Primitive::kTriangles ? 3 : 1) * stride_;
  if (waiting_.size() + size > kBlockBytes) Finish();
  waiting_.insert(waiting_.end(), bytes, bytes + size);
  for (const Vec3f& corner : corners) waiting_box_.Add(Vec3(corner));
}

void VertexStream::Finish() {
  if (waiting_.empty()) return;
  Block block{0, 0, static_cast<GLsizei>(waiting_.size() / stride_), waiting_box_};
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
                             reinterpret_cast<const void*>(a.offset));
    gl_->VertexAttribDivisor(a.location, primitive_ == Primitive::kQuads ? 1 : 0);
  }
  blocks_.push_back(block);
  waiting_.clear();
  waiting_box_ = {};
}

void VertexStream::DrawBlock(const Block& block) const {
  gl_->BindVertexArray(block.array);
  if (primitive_ == Primitive::kTriangles) {
    gl_->DrawArrays(GL_TRIANGLES, 0, block.count);
  } else {
    gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, block.count);
  }
}

void VertexStream::Draw() const {
  for (const Block& block : blocks_) DrawBlock(block);
}

void VertexStream::DrawSeen(const DrawVolume& volume) const {
  for (const Block& block : blocks_) {
    if (volume.Touches(block.box)) DrawBlock(block);
  }
}

void VertexStream::DrawNearFirst(const DrawVolume& volume) const {
  std::vector<std::pair<double, const Block*>> seen;
  for (const Block& block : blocks_) {
    if (volume.Touches(block.box)) seen.emplace_back(volume.DistanceTo(block.box), &block);
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance, block] : seen) DrawBlock(*block);
}

}  // namespace parti::render
