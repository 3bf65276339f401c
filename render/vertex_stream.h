// Vertices on their way to the GPU, a bounded piece at a time.
// Knows nothing of what they mean: layouts are their owners'.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/draw_volume.h"
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
/// bounded however large the scene, and blocks that a picture doesn't show are left out. Used and
/// destroyed while its context is current.
class VertexStream {
 public:
  /// `attributes` must outlive the stream.
  VertexStream(const Gl& gl, Primitive primitive, size_t stride,
               const std::vector<VertexAttribute>& attributes);
  VertexStream(VertexStream&& other) noexcept;
  VertexStream& operator=(VertexStream&& other) noexcept;
  ~VertexStream();

  /// Appends one primitive: three vertices of a triangle, one of a quad. It lies between these
  /// corners of the world; without any, it is always drawn.
  void Append(const void* vertices, std::span<const Vec3f> corners = {});
  /// Sends what is waiting; to be called once all is appended.
  void Finish();

  bool empty() const { return blocks_.empty() && waiting_.empty(); }
  /// With the program in use; blocks in order.
  void Draw() const;
  /// Only blocks that may be seen, in order.
  void DrawSeen(const DrawVolume& volume) const;
  /// Only blocks that may be seen, near ones first: what they hide then is not shaded.
  void DrawNearFirst(const DrawVolume& volume) const;

  /// Enough for some sixty boxes: fine enough to leave out what a tile doesn't show.
  static constexpr size_t kBlockBytes = size_t{64} << 10;

 private:
  struct Block {
    GLuint array, buffer;
    GLsizei count;
    Bounds box;  ///< empty: unknown
  };
  void DrawBlock(const Block& block) const;

  const Gl* gl_;
  Primitive primitive_;
  size_t stride_;
  const std::vector<VertexAttribute>* attributes_;
  std::vector<std::byte> waiting_;
  Bounds waiting_box_;
  std::vector<Block> blocks_;
};

}  // namespace parti::render
