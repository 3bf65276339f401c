#include "render/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/ink_pieces.h"

namespace parti::render {
namespace {

using Bytes4 = std::array<uint8_t, 4>;

struct FaceVertex {
  Vec3f position;
  std::array<int16_t, 4> normal;
  Bytes4 color;
  Bytes4 id;
};
const std::vector<VertexAttribute> kFaceLayout = {
    {0, 3, GL_FLOAT, false, offsetof(FaceVertex, position)},
    {1, 4, GL_SHORT, true, offsetof(FaceVertex, normal)},
    {2, 4, GL_UNSIGNED_BYTE, true, offsetof(FaceVertex, color)},
    {3, 4, GL_UNSIGNED_BYTE, true, offsetof(FaceVertex, id)}};

struct LineInstance {
  Vec3f a, b;
  Bytes4 color;
  Vec2f width_and_dash;
};
const std::vector<VertexAttribute> kLineLayout = {
    {0, 3, GL_FLOAT, false, offsetof(LineInstance, a)},
    {1, 3, GL_FLOAT, false, offsetof(LineInstance, b)},
    {2, 4, GL_UNSIGNED_BYTE, true, offsetof(LineInstance, color)},
    {3, 2, GL_FLOAT, false, offsetof(LineInstance, width_and_dash)}};

uint8_t Byte(float channel) {
  if (!(channel > 0)) return 0;  // NaN too
  return static_cast<uint8_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255.0f));
}
Bytes4 Bytes(const Vec4f& c) { return {Byte(c.r), Byte(c.g), Byte(c.b), Byte(c.a)}; }
Bytes4 Bytes(uint32_t id) {
  return {static_cast<uint8_t>(id), static_cast<uint8_t>(id >> 8), static_cast<uint8_t>(id >> 16),
          static_cast<uint8_t>(id >> 24)};
}

void Upload(const Faces& faces, VertexStream* stream) {
  const Bytes4 color = Bytes(Vec4f(faces.color, 1)), id = Bytes(faces.id);
  for (size_t i = 0; i + 2 < faces.corners.size(); i += 3) {
    const Vec3f* p = &faces.corners[i];
    if (!IsDrawable(p[0]) || !IsDrawable(p[1]) || !IsDrawable(p[2])) continue;
    const Vec3 normal = glm::cross(Vec3(p[1]) - Vec3(p[0]), Vec3(p[2]) - Vec3(p[0]));
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    const auto part = [&](double n) {
      return static_cast<int16_t>(std::lround(n / length * 32767));
    };
    const std::array<int16_t, 4> packed = {part(normal.x), part(normal.y), part(normal.z), 0};
    const std::array<FaceVertex, 3> triangle = {FaceVertex{p[0], packed, color, id},
                                                FaceVertex{p[1], packed, color, id},
                                                FaceVertex{p[2], packed, color, id}};
    stream->Append(triangle.data(), {p, 3});
  }
}

void Upload(const Lines& lines, VertexStream* stream) {
  LineInstance line{
      {}, {}, Bytes(lines.color), {std::min(lines.width_px, kWidestLine_px), lines.dash_px}};
  if (!(lines.width_px > 0) || !std::isfinite(lines.width_px)) return;
  if (!(lines.dash_px > 0) || !std::isfinite(lines.dash_px)) line.width_and_dash.y = 0;
  for (size_t i = 0; i + 1 < lines.ends.size(); i += 2) {
    line.a = lines.ends[i];
    line.b = lines.ends[i + 1];
    if (IsDrawable(line.a) && IsDrawable(line.b)) stream->Append(&line, {&lines.ends[i], 2});
  }
}

void Upload(const Ink& ink, VertexStream* stream) {
  std::vector<InkPiece> pieces;
  AppendPieces(ink, 0, &pieces);
  for (const InkPiece& piece : pieces) stream->Append(&piece);
}

std::vector<InkGroup> Grouped(const Gl& gl, const std::vector<Ink>& all) {
  std::vector<InkGroup> groups;
  for (const Ink& ink : all) {
    if (groups.empty() || groups.back().color != ink.color) {
      groups.push_back(
          {ink.color, VertexStream(gl, Primitive::kQuads, sizeof(InkPiece), InkLayout())});
    }
    Upload(ink, &groups.back().pieces);
  }
  for (InkGroup& group : groups) group.pieces.Finish();
  std::erase_if(groups, [](const InkGroup& group) { return group.pieces.empty(); });
  return groups;
}

}  // namespace

GpuScene::GpuScene(const Gl& gl, const Scene& scene)
    : faces(gl, Primitive::kTriangles, sizeof(FaceVertex), kFaceLayout),
      closed_faces(gl, Primitive::kTriangles, sizeof(FaceVertex), kFaceLayout),
      lines(gl, Primitive::kQuads, sizeof(LineInstance), kLineLayout),
      lines_on_top(gl, Primitive::kQuads, sizeof(LineInstance), kLineLayout),
      ink(Grouped(gl, scene.ink)),
      ground(scene.ground),
      face_bounds(BoundsOf(scene, false)),
      bounds(BoundsOf(scene, true)) {
  for (const Faces& group : scene.faces) Upload(group, group.closed ? &closed_faces : &faces);
  for (const Lines& group : scene.lines) Upload(group, group.on_top ? &lines_on_top : &lines);
  faces.Finish();
  closed_faces.Finish();
  lines.Finish();
  lines_on_top.Finish();
}

void GpuScene::DrawAllFaces(const Gl& gl) const {
  faces.Draw();
  gl.Enable(GL_CULL_FACE);  // with GL's defaults: counter-clockwise is the front, backs are culled
  closed_faces.Draw();
  gl.Disable(GL_CULL_FACE);
}

void GpuScene::DrawFacesNearFirst(const Gl& gl, const DrawVolume& volume) const {
  faces.DrawNearFirst(volume);
  gl.Enable(GL_CULL_FACE);
  closed_faces.DrawNearFirst(volume);
  gl.Disable(GL_CULL_FACE);
}

}  // namespace parti::render
