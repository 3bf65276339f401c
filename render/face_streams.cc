#include "render/face_streams.h"

#include <array>
#include <cmath>

#include "render/vertex_bytes.h"

namespace parti::render {
namespace {

struct FaceVertex {
  Vec3f position;
  std::array<int16_t, 4> normal;
  Bytes4 color;
  Bytes4 id;
};

/// What faces with images have besides.
struct ImageVertex {
  FaceVertex face;
  Vec2f uv;
};

std::vector<VertexAttribute> FaceLayout() {
  return {{0, 3, GL_FLOAT, false, offsetof(FaceVertex, position)},
          {1, 4, GL_SHORT, true, offsetof(FaceVertex, normal)},
          {2, 4, GL_UNSIGNED_BYTE, true, offsetof(FaceVertex, color)},
          {3, 4, GL_UNSIGNED_BYTE, true, offsetof(FaceVertex, id)}};
}

std::vector<VertexAttribute> ImageLayout() {
  std::vector<VertexAttribute> layout = FaceLayout();
  layout.push_back({4, 2, GL_FLOAT, false, offsetof(ImageVertex, uv)});
  return layout;
}

const std::vector<VertexAttribute> kFaceLayout = FaceLayout();
const std::vector<VertexAttribute> kImageLayout = ImageLayout();

VertexStream StreamFor(const Gl& gl, bool with_uvs) {
  if (!with_uvs) return {gl, Primitive::kTriangles, sizeof(FaceVertex), kFaceLayout};
  return {gl, Primitive::kTriangles, sizeof(ImageVertex), kImageLayout};
}

/// As shaders look it up: images are sent with their rows from the top.
Vec2f UvAt(const Faces& faces, size_t corner) {
  const Vec2f uv = corner < faces.uvs.size() ? faces.uvs[corner] : Vec2f(0, 0);
  return std::isfinite(uv.x) && std::isfinite(uv.y) ? Vec2f(uv.x, 1 - uv.y) : Vec2f(0, 1);
}

/// Its fourth part says whether the face yields. Nothing where the triangle has no area.
std::optional<std::array<int16_t, 4>> PackedNormal(const Vec3f* p, bool yields) {
  const Vec3 normal = glm::cross(Vec3(p[1]) - Vec3(p[0]), Vec3(p[2]) - Vec3(p[0]));
  const double length = glm::length(normal);
  if (!(length > 0)) return std::nullopt;
  const auto part = [&](double n) { return static_cast<int16_t>(std::lround(n / length * 32767)); };
  const int16_t last = yields ? INT16_MAX : 0;
  return std::array<int16_t, 4>{part(normal.x), part(normal.y), part(normal.z), last};
}

}  // namespace

FaceStreams::FaceStreams(const Gl& gl, bool with_uvs)
    : with_uvs_(with_uvs), open_(StreamFor(gl, with_uvs)), closed_(StreamFor(gl, with_uvs)) {}

void FaceStreams::Append(const Faces& faces) {
  VertexStream& stream = faces.closed ? closed_ : open_;
  const Bytes4 color = ColorBytes(Vec4f(faces.color, 1)), id = IdBytes(faces.id);
  for (size_t i = 0; i + 2 < faces.corners.size(); i += 3) {
    const Vec3f* p = &faces.corners[i];
    if (!IsDrawable(p[0]) || !IsDrawable(p[1]) || !IsDrawable(p[2])) continue;
    const auto normal = PackedNormal(p, faces.yields);
    if (!normal) continue;
    std::array<FaceVertex, 3> triangle;
    for (int k = 0; k < 3; ++k) triangle[k] = {p[k], *normal, color, id};
    if (!with_uvs_) {
      stream.Append(triangle.data(), {p, 3});
      continue;
    }
    std::array<ImageVertex, 3> worn;
    for (int k = 0; k < 3; ++k) worn[k] = {triangle[k], UvAt(faces, i + k)};
    stream.Append(worn.data(), {p, 3});
  }
}

void FaceStreams::Finish() {
  open_.Finish();
  closed_.Finish();
}

void FaceStreams::Draw(const Gl& gl) const {
  open_.Draw();
  gl.Enable(GL_CULL_FACE);  // with GL's defaults: counter-clockwise is the front, backs are culled
  closed_.Draw();
  gl.Disable(GL_CULL_FACE);
}

void FaceStreams::DrawNearFirst(const Gl& gl, const DrawVolume& volume) const {
  open_.DrawNearFirst(volume);
  gl.Enable(GL_CULL_FACE);
  closed_.DrawNearFirst(volume);
  gl.Disable(GL_CULL_FACE);
}

}  // namespace parti::render
