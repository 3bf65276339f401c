// Vertices on their way to the GPU, a bounded piece at a time.
// Knows nothing of what they mean: layouts are their owners'.
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

/// What a stream's vertices make: triangles three by three, or each a quad of its own, an instance
/// whose four corners shaders know by gl_VertexID.
enum class Primitive { kTriangles, kQuads };

/// Vertices of one layout in buffers of at most kBlockBytes each: memory beyond the GPU's own stays
/// bounded however large the scene. Used and destroyed while its context is current.
class VertexStream {
 public:
  /// `attributes` must outlive the stream.
  VertexStream(const Gl& gl, Primitive primitive, size_t stride,
               const std::vector<VertexAttribute>& attributes);
  VertexStream(VertexStream&& other) noexcept;
  VertexStream& operator=(VertexStream&& other) noexcept;
  ~VertexStream();

  /// Appends one primitive: three vertices of a triangle, one of a quad.
  void Append(const void* vertices);
  /// Sends what is waiting; to be called once all is appended.
  void Finish();

  bool empty() const { return blocks_.empty() && waiting_.empty(); }
  /// With the program in use.
  void Draw() const;

  static constexpr size_t kBlockBytes = size_t{4} << 20;

 private:
  struct Block {
    GLuint array, buffer;
    GLsizei count;
  };

  const Gl* gl_;
  Primitive primitive_;
  size_t stride_;
  const std::vector<VertexAttribute>* attributes_;
  std::vector<std::byte> waiting_;
  std::vector<Block> blocks_;
};

}  // namespace parti::render
