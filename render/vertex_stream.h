// Vertices on their way to the GPU, a bounded piece at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/gl.h"

namespace parti::render {

/// How one attribute lies in a vertex.
struct VertexAttribute {
  GLuint location;
  GLint components;
  GLenum type;
  bool normalized;
  size_t offset;
};

/// Vertices of one layout in buffers of at most kBlockBytes each: memory beyond the GPU's own stays
/// bounded however large the scene. Used and destroyed while its context is current.
class VertexStream {
 public:
  /// `divisor` 1: each vertex is an instance. `attributes` must outlive the stream.
  VertexStream(const Gl& gl, size_t stride, const std::vector<VertexAttribute>& attributes,
               GLuint divisor);
  VertexStream(VertexStream&& other) noexcept;
  VertexStream& operator=(VertexStream&& other) noexcept;
  ~VertexStream();

  /// Appends `count` vertices that belong together (a triangle's) and so stay in one buffer.
  void Append(const void* vertices, size_t count);
  /// Sends what is waiting; to be called once all is appended.
  void Finish();

  bool empty() const { return blocks_.empty() && waiting_.empty(); }
  /// Calls draw(count of vertices) with each block's vertex array bound.
  template <typename Draw>
  void ForEachBlock(const Draw& draw) const {
    for (const Block& block : blocks_) {
      gl_->BindVertexArray(block.array);
      draw(static_cast<GLsizei>(block.count));
    }
  }

  static constexpr size_t kBlockBytes = size_t{4} << 20;

 private:
  struct Block {
    GLuint array, buffer;
    size_t count;
  };

  const Gl* gl_;
  size_t stride_;
  const std::vector<VertexAttribute>* attributes_;
  GLuint divisor_;
  std::vector<std::byte> waiting_;
  std::vector<Block> blocks_;
};

}  // namespace parti::render
