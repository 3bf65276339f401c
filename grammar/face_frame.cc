#include "grammar/face_frame.h"

namespace parti::grammar {
namespace {

Ring RingOf(const FaceFrame& frame, const Mesh& mesh, const std::vector<uint32_t>& loop) {
  Ring ring;
  ring.reserve(loop.size());
  for (const uint32_t i : loop) {
    const Vec3 d = mesh.points[i] - frame.origin;
    ring.emplace_back(glm::dot(d, frame.x), glm::dot(d, frame.y));
  }
  return ring;
}

}  // namespace

FaceFrame::FaceFrame(const Mesh& mesh, const MeshFace& face)
    : origin(mesh.points[face.loop[0]]), normal(Normal(mesh, face)) {
  Vec3 edge(0, 0, 0);
  for (size_t i = 0; i < face.loop.size() && glm::length(edge) <= kLengthTolerance_m; ++i) {
    edge = mesh.points[face.loop[(i + 1) % face.loop.size()]] - mesh.points[face.loop[i]];
    edge -= normal * glm::dot(edge, normal);
  }
  if (glm::length(edge) > 0) x = glm::normalize(edge);
  y = glm::cross(normal, x);
}

Polygon FaceFrame::PolygonOf(const Mesh& mesh, const MeshFace& face) const {
  Polygon polygon{RingOf(*this, mesh, face.loop), {}};
  for (const auto& hole : face.holes) polygon.holes.push_back(RingOf(*this, mesh, hole));
  return polygon;
}

bool HasFrame(const Mesh& mesh, const MeshFace& face) {
  return Normal(mesh, face) != Vec3(0, 0, 0);
}

}  // namespace parti::grammar
