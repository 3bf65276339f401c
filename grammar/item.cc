// What can be read off an item: its geometry made explicit, its faces, edges and triangles.
#include "grammar/item.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "grammar/face_frame.h"
#include "grammar/item_edges.h"
#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

/// Unit vectors whose dot product is larger look the same way.
constexpr double kSameDirection = 1 - 1e-9;

/// Corners of a scope's rectangle, counter-clockwise from its origin.
void AddRectangle(const Scope& s, std::vector<Vec3>* corners) {
  const Vec3 x = s.x * s.size.x, y = s.y * s.size.y;
  for (const Vec3& p : {s.origin, s.origin + x, s.origin + x + y, s.origin + y}) {
    corners->push_back(p);
  }
}

Item RectangleOf(const Item& parent, const Vec3& origin, const Vec3& x, const Vec3& normal,
                 double width, double height) {
  Item face;
  face.type = ItemType::kPlanar;
  face.scope = {origin, x, glm::cross(normal, x), normal, Vec3(width, height, 0)};
  face.facing = normal;
  Inherit(parent, &face);
  return face;
}

/// The faces of a box in the order of BoxMesh.
std::vector<Item> BoxFaces(const Item& box) {
  const Scope& s = box.scope;
  const Vec3 &o = s.origin, x = s.x * s.size.x, y = s.y * s.size.y, z = s.z * s.size.z;
  const double w = s.size.x, h = s.size.y, d = s.size.z;
  std::vector<Item> faces;
  faces.reserve(6);
  faces.push_back(RectangleOf(box, o + x + z, -s.x, -s.y, w, d));
  faces.push_back(RectangleOf(box, o + y + z, s.x, s.y, w, d));
  faces.push_back(RectangleOf(box, o + z, s.x, s.z, w, h));
  faces.push_back(RectangleOf(box, o + x + z, -s.z, s.x, d, h));
  faces.push_back(RectangleOf(box, o + x, -s.x, -s.z, w, h));
  faces.push_back(RectangleOf(box, o, s.z, -s.x, d, h));
  return faces;
}

/// The mesh of a volume in its scope's coordinates: the item's own, or made of a unit mesh.
class ScopedMesh {
 public:
  explicit ScopedMesh(const Item& volume) : mesh_(volume.mesh.get()) {
    if (!volume.mesh_is_unit) return;
    made_ = Rescaled(*mesh_, Vec3(0, 0, 0), volume.scope.size);
    mesh_ = &made_;
  }
  ScopedMesh(const ScopedMesh&) = delete;
  ScopedMesh& operator=(const ScopedMesh&) = delete;
  const Mesh& operator*() const { return *mesh_; }

 private:
  const Mesh* mesh_;
  Mesh made_;
};

/// What a face of a mesh wears as an item of its own: what the item says, then what the face does.
std::shared_ptr<const Paint> PaintOf(const Item& volume, const Mesh& mesh, const MeshFace& face) {
  if (face.paint == 0) return volume.paint;
  Paint paint = mesh.paints[face.paint - 1];
  const Scope& s = volume.scope;
  if (paint.map) paint.map = InFrame(*paint.map, s.origin, s.x, s.y, s.z);
  if (volume.paint) {
    if (volume.paint->material) paint.material = volume.paint->material;
    if (volume.paint->map) paint.map = volume.paint->map;
    paint.projection = volume.paint->projection;
  }
  return std::make_shared<const Paint>(std::move(paint));
}

Item FaceItem(const Item& volume, const Mesh& mesh, const MeshFace& face) {
  const FaceFrame frame(mesh, face);
  const Scope& s = volume.scope;
  const auto turn = [&](const Vec3& v) { return s.x * v.x + s.y * v.y + s.z * v.z; };
  Scope scope;
  scope.origin = s.ToWorld(frame.origin);
  scope.x = turn(frame.x);
  scope.y = turn(frame.y);
  scope.z = turn(frame.normal);
  Item item = PlanarItem(scope, frame.PolygonOf(mesh, face), volume);
  item.paint = PaintOf(volume, mesh, face);
  return item;
}

void AddRingEdges(const Scope& s, const Ring& ring, std::vector<Segment3>* edges) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    edges->push_back({s.ToWorld(Vec3(a.x, a.y, 0)), s.ToWorld(Vec3(b.x, b.y, 0))});
  }
}

void AddRectangleEdges(const Scope& s, std::vector<Segment3>* edges) {
  const Vec3 x = s.x * s.size.x, y = s.y * s.size.y;
  const Vec3 a = s.origin, b = a + x, c = b + y, d = a + y;
  edges->insert(edges->end(), {{a, b}, {b, c}, {c, d}, {d, a}});
}

void AddBoxEdges(const Scope& s, std::vector<Segment3>* edges) {
  const Vec3 x = s.x * s.size.x, y = s.y * s.size.y, z = s.z * s.size.z;
  const Vec3 foot[4] = {s.origin + z, s.origin + x + z, s.origin + x, s.origin};
  for (const Vec3& rise : {Vec3(0, 0, 0), y}) {
    for (int i = 0; i < 4; ++i) edges->push_back({foot[i] + rise, foot[(i + 1) % 4] + rise});
  }
  for (const Vec3& corner : foot) edges->push_back({corner, corner + y});
}

/// Every edge of a closed mesh is in two loops, once each way round: taken where it runs upward in
/// number.
void AddMeshEdges(const Item& volume, const std::vector<uint32_t>& loop,
                  std::vector<Segment3>* edges) {
  for (size_t i = 0; i < loop.size(); ++i) {
    const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
    if (a > b) continue;
    edges->push_back({volume.scope.ToWorld(volume.mesh->points[a]),
                      volume.scope.ToWorld(volume.mesh->points[b])});
  }
}

/// Edges of assets are drawn where they bend by more than this, or end: they are mostly triangles,
/// and often round.
constexpr double kCrease_deg = 30;

void AddCreases(const Item& volume, std::vector<Segment3>* edges) {
  const double flat = std::cos(Angle::Degrees(kCrease_deg).radians());
  for (const ItemEdge& edge : ItemEdgesOf(volume)) {
    if (edge.faces == 2 && glm::dot(edge.normal, edge.other) > flat) continue;
    edges->push_back({edge.a, edge.b});
  }
}

void AddQuadTriangles(const std::vector<Vec3>& q, std::vector<Vec3>* corners) {
  corners->insert(corners->end(), {q[0], q[1], q[2], q[0], q[2], q[3]});
}

void AddRectangleTriangles(const Scope& scope, std::vector<Vec3>* corners) {
  std::vector<Vec3> quad;
  AddRectangle(scope, &quad);
  AddQuadTriangles(quad, corners);
}

void AddFaceTriangles(const Scope& scope, const Mesh& mesh, const MeshFace& face,
                      std::vector<Vec3>* corners) {
  if (face.loop.size() == 3 && face.holes.empty()) {
    for (const uint32_t i : face.loop) corners->push_back(scope.ToWorld(mesh.points[i]));
    return;
  }
  std::vector<uint32_t> numbers = face.loop;
  for (const auto& hole : face.holes) numbers.insert(numbers.end(), hole.begin(), hole.end());
  const FaceFrame frame(mesh, face);
  for (const uint32_t i : Triangulate(frame.PolygonOf(mesh, face))) {
    corners->push_back(scope.ToWorld(mesh.points[numbers[i]]));
  }
}

/// The same rectangle, looking the other way.
Item Reversed(const Item& face) {
  Item back = face;
  back.scope.origin = face.scope.origin + face.scope.x * face.scope.size.x;
  back.scope.x = -face.scope.x;
  back.scope.z = -face.scope.z;
  back.facing = -face.facing;
  if (!face.polygon) return back;
  Polygon polygon = *face.polygon;
  const auto turn = [&](Ring* ring) {
    for (Vec2& p : *ring) p.x = face.scope.size.x - p.x;
    // The first edge stays the first.
    std::reverse(ring->begin(), ring->end());
    std::rotate(ring->begin(), ring->end() - 2, ring->end());
  };
  turn(&polygon.outer);
  for (Ring& hole : polygon.holes) turn(&hole);
  back.polygon = std::make_shared<const Polygon>(std::move(polygon));
  return back;
}

/// What is seen of a niche whose solid has these faces: all but its mouth, from the other side.
std::vector<Item> NicheFaces(const Item& niche, const std::vector<Item>& solid) {
  double mouth = -std::numeric_limits<double>::infinity();
  for (const Item& face : solid) {
    mouth = std::max(mouth, glm::dot(face.scope.origin, niche.facing));
  }
  std::vector<Item> faces;
  faces.reserve(solid.size());
  for (const Item& face : solid) {
    const bool open = glm::dot(face.facing, niche.facing) > kSameDirection &&
                      glm::dot(face.scope.origin, niche.facing) > mouth - kLengthTolerance_m;
    if (!open) faces.push_back(Reversed(face));
  }
  return faces;
}

double FaceArea(const Mesh& mesh, const MeshFace& face) {
  return Area(FaceFrame(mesh, face).PolygonOf(mesh, face));
}

}  // namespace

std::string_view NameOf(ItemType type) {
  switch (type) {
    case ItemType::kVolume:
      return "VolumetricShape";
    case ItemType::kPlanar:
      return "PlanarShape";
    case ItemType::kShape2D:
      return "Shape2D";
    case ItemType::kLayer:
      return "Layer";
    case ItemType::kEdge:
      return "Edge";
    case ItemType::kPoint:
      return "Point";
  }
  return "";
}

Polygon PolygonOf(const Item& flat) {
  CHECK(IsFlat(flat.type), "a volume is no polygon");
  if (flat.polygon) return *flat.polygon;
  return Rectangle(Vec2(flat.scope.size.x, flat.scope.size.y));
}

Mesh MeshOf(const Item& volume) {
  CHECK(volume.type == ItemType::kVolume, "only a volume is a mesh");
  return volume.mesh ? *ScopedMesh(volume) : BoxMesh(volume.scope.size);
}

double AreaOf(const Item& item) {
  if (!HasSurface(item.type)) return 0;
  const Vec3& size = item.scope.size;
  if (IsFlat(item.type)) {
    return item.polygon ? Area(*item.polygon) : size.x * size.y;
  }
  double area = 0;
  if (item.hollow) {
    for (const Item& face : FacesOf(item)) area += AreaOf(face);
    return area;
  }
  if (!item.mesh) return 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  const ScopedMesh mesh(item);
  for (const MeshFace& face : (*mesh).faces) area += FaceArea(*mesh, face);
  return area;
}

double VolumeOf(const Item& item) {
  if (item.type != ItemType::kVolume) return 0;
  const Vec3& size = item.scope.size;
  const double box = size.x * size.y * size.z;
  if (!item.mesh) return box;
  return item.mesh_is_unit ? Volume(*item.mesh) * box : Volume(*item.mesh);
}

std::vector<Item> FacesOf(const Item& item) {
  if (!HasSurface(item.type)) return {};
  if (IsFlat(item.type)) return {item};
  std::vector<Item> faces;
  if (item.mesh) {
    faces.reserve(item.mesh->faces.size());
    const ScopedMesh mesh(item);
    for (const MeshFace& face : (*mesh).faces) {
      if (HasFrame(*mesh, face)) faces.push_back(FaceItem(item, *mesh, face));
    }
  } else {
    faces = BoxFaces(item);
  }
  return item.hollow ? NicheFaces(item, faces) : faces;
}

void EdgesOf(const Item& item, std::vector<Segment3>* edges) {
  if (item.type == ItemType::kPoint) return;
  if (item.type == ItemType::kEdge) {
    edges->push_back({item.scope.origin, item.scope.ToWorld(Vec3(item.scope.size.x, 0, 0))});
    return;
  }
  if (IsFlat(item.type)) {
    if (!item.polygon) return AddRectangleEdges(item.scope, edges);
    AddRingEdges(item.scope, item.polygon->outer, edges);
    for (const Ring& hole : item.polygon->holes) AddRingEdges(item.scope, hole, edges);
    return;
  }
  if (!item.mesh) return AddBoxEdges(item.scope, edges);
  if (item.mesh_is_unit || !item.mesh->closed) return AddCreases(item, edges);
  for (const MeshFace& face : item.mesh->faces) {
    AddMeshEdges(item, face.loop, edges);
    for (const auto& hole : face.holes) AddMeshEdges(item, hole, edges);
  }
}

std::vector<Segment3> EdgesOf(const Item& item) {
  std::vector<Segment3> edges;
  EdgesOf(item, &edges);
  return edges;
}

void TrianglesOf(const Item& item, std::vector<Vec3>* corners) {
  if (!HasSurface(item.type)) return;
  if (IsFlat(item.type)) {
    if (!item.polygon) return AddRectangleTriangles(item.scope, corners);
    std::vector<Vec2> flat = item.polygon->outer;
    for (const Ring& hole : item.polygon->holes) flat.insert(flat.end(), hole.begin(), hole.end());
    for (const uint32_t i : Triangulate(*item.polygon)) {
      corners->push_back(item.scope.ToWorld(Vec3(flat[i].x, flat[i].y, 0)));
    }
    return;
  }
  if (!item.mesh || item.hollow) {
    for (const Item& face : FacesOf(item)) TrianglesOf(face, corners);
    return;
  }
  const ScopedMesh mesh(item);
  for (const MeshFace& face : (*mesh).faces) {
    if (HasFrame(*mesh, face)) AddFaceTriangles(item.scope, *mesh, face, corners);
  }
}

}  // namespace parti::grammar
