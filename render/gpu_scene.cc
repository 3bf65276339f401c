#include "render/gpu_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "render/ink_pieces.h"
#include "render/vertex_bytes.h"

namespace parti::render {
namespace {

struct LineInstance {
  Vec3f a, b;
  Bytes4 color;
  Vec3f width_dash_spacing;
  std::array<int8_t, 4> behind;
};
const std::vector<VertexAttribute> kLineLayout = {
    {0, 3, GL_FLOAT, false, offsetof(LineInstance, a)},
    {1, 3, GL_FLOAT, false, offsetof(LineInstance, b)},
    {2, 4, GL_UNSIGNED_BYTE, true, offsetof(LineInstance, color)},
    {3, 3, GL_FLOAT, false, offsetof(LineInstance, width_dash_spacing)},
    {4, 4, GL_BYTE, true, offsetof(LineInstance, behind)}};

void Upload(const Lines& lines, VertexStream* stream) {
  LineInstance line{{},
                    {},
                    ColorBytes(lines.color),
                    {std::min(lines.width_px, kWidestLine_px), lines.dash_px, lines.spacing_m},
                    DirectionBytes(lines.behind)};
  if (!(lines.width_px > 0) || !std::isfinite(lines.width_px)) return;
  if (!(lines.dash_px > 0) || !std::isfinite(lines.dash_px)) line.width_dash_spacing.y = 0;
  if (!(lines.spacing_m > 0) || !std::isfinite(lines.spacing_m)) line.width_dash_spacing.z = 0;
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

GpuScene::GpuScene(const Gl& gl, const Scene& scene, GpuTextures old_textures)
    : plain_faces(gl),
      lines(gl, Primitive::kQuads, sizeof(LineInstance), kLineLayout),
      lines_on_top(gl, Primitive::kQuads, sizeof(LineInstance), kLineLayout),
      ink(Grouped(gl, scene.ink)),
      ground(scene.ground),
      has_covered_lines(
          std::any_of(scene.lines.begin(), scene.lines.end(),
                      [](const Lines& group) { return group.behind != Vec3f(0, 0, 0); })),
      textures(gl, std::move(old_textures)),
      face_bounds(BoundsOf(scene, false)),
      bounds(BoundsOf(scene, true)) {
  UploadFaces(gl, scene);
  for (const Lines& group : scene.lines) Upload(group, group.on_top ? &lines_on_top : &lines);
  lines.Finish();
  lines_on_top.Finish();
}

void GpuScene::UploadFaces(const Gl& gl, const Scene& scene) {
  std::map<GLuint, size_t> places;
  for (const Faces& group : scene.faces) {
    const GLuint texture = group.image ? textures.Of(group.image) : 0;
    if (!texture) {
      plain_faces.Append(group);
      continue;
    }
    const auto [place, is_new] = places.emplace(texture, image_faces.size());
    if (is_new) image_faces.push_back({texture, FaceStreams(gl, true)});
    image_faces[place->second].faces.Append(group);
  }
  plain_faces.Finish();
  for (ImageFaces& worn : image_faces) worn.faces.Finish();
  textures.Forget();
}

void GpuScene::DrawAllFaces(const Gl& gl) const {
  plain_faces.Draw(gl);
  for (const ImageFaces& worn : image_faces) worn.faces.Draw(gl);
}

void GpuScene::DrawFacesNearFirst(const Gl& gl, const DrawVolume& volume) const {
  plain_faces.DrawNearFirst(gl, volume);
  for (const ImageFaces& worn : image_faces) worn.faces.DrawNearFirst(gl, volume);
}

}  // namespace parti::render
