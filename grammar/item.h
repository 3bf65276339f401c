// What operations take and give: a typed piece of geometry in its scope (Jesus 2018, 4.2).
// Not responsible for where an item stands in a derivation (shape_tree.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "grammar/mesh.h"
#include "grammar/polygon.h"
#include "grammar/scope.h"

namespace parti::grammar {

/// What operations tell apart (4.1). A volume and a planar shape stand in the world and are
/// visible; a layer and a 2D shape belong to the scene of a planar shape, in whose plane their
/// scopes lie, and are never visible: the normalisation makes planar shapes of them
/// (layers/normalise.h). Edges and points are places for what is put there: they have a scope and
/// are not visible either; an edge lies along its scope's x, a point in its origin.
enum class ItemType : uint8_t {
  kVolume = 1,
  kPlanar = 2,
  kShape2D = 4,
  kLayer = 8,
  kEdge = 16,
  kPoint = 32
};
/// A set of ItemType values, or-ed.
using ItemTypes = uint8_t;
constexpr ItemTypes Types(ItemType a) { return static_cast<ItemTypes>(a); }
template <typename... Rest>
constexpr ItemTypes Types(ItemType a, Rest... rest) {
  return static_cast<ItemTypes>(Types(a) | Types(rest...));
}
inline constexpr ItemTypes kAllItemTypes =
    Types(ItemType::kVolume, ItemType::kPlanar, ItemType::kShape2D, ItemType::kLayer,
          ItemType::kEdge, ItemType::kPoint);
/// "VolumetricShape", "PlanarShape", "Shape2D", "Layer", "Edge", "Point".
std::string_view NameOf(ItemType type);

/// Whether shapes of this type are a part of what is seen.
constexpr bool IsVisible(ItemType type) {
  return type == ItemType::kVolume || type == ItemType::kPlanar;
}
/// Whether shapes of this type belong to the scene of a planar shape.
constexpr bool IsOfScene(ItemType type) {
  return type == ItemType::kShape2D || type == ItemType::kLayer;
}
/// Whether it is a region of a plane.
constexpr bool IsFlat(ItemType type) {
  return type == ItemType::kPlanar || type == ItemType::kShape2D || type == ItemType::kLayer;
}
/// Whether it has an area, seen or not: all but edges and points.
constexpr bool HasSurface(ItemType type) { return type == ItemType::kVolume || IsFlat(type); }

/// Geometry is immutable and shared. Null geometry is the whole scope: a rectangle or a box, which
/// is what most shapes of a building are. A layer has its planar shape's scope and no polygon. A
/// planar shape, an edge or a point may have sizes that its geometry doesn't fill, for what i()
/// puts there: s() gives it a depth.
struct Item {
  ItemType type = ItemType::kPlanar;
  bool fixed_geometry = true;  ///< a 2D shape that is covered is dropped, not cut (4.18; errata 6)
  uint16_t layer = 0;          ///< of the scene; a later one lies over an earlier one (errata 2)
  int32_t depth = 0;           ///< in the layer, 0 or less: the smaller lies on top (errata 2)
  Scope scope;
  std::shared_ptr<const Polygon> polygon;  ///< flat, in scope x and y; null: the rectangle
  std::shared_ptr<const Mesh> mesh;        ///< volume, in scope coordinates; null: the box
  Vec3 facing{0, 0, 0};  ///< unit outward normal; a volume keeps its origin's; 0: none (errata 10)
  uint32_t color_rgb = 0;  ///< 0xRRGGBB; 0: none given; else it goes before that of any paint
  /// The mesh fills [0, 1] in each axis and is stretched to the scope's size, whatever that is:
  /// assets and primitives, which thousands of items share.
  bool mesh_is_unit = false;
  std::shared_ptr<const Paint> paint;  ///< goes before that of the mesh's faces; null: plain
  /// The middle of the scope before t, r, s first changed it: where center leads back to. Cleared
  /// where a rule begins (CGA's previous shape).
  std::optional<Vec3> anchor;
  /// Which way the street lies, clockwise from north, in degrees; what is made from a shape keeps
  /// it. Nothing: no street is known (front_edge.h).
  std::optional<float> street_deg;
  /// Volume: a niche, drawn inward from a surface. It is open where it comes from, the side that
  /// `facing` looks out of, and its faces are seen from within. Its space is that of the solid.
  bool hollow = false;
};

/// A planar item from corners in the world (first the outline, then holes), in any winding; the
/// normal is `up_hint`'s side where given (lots face up), else the side from which the outline runs
/// counter-clockwise. Corners up to max(1 mm, 1e-3 of the diagonal) off the plane are projected.
/// errors  those of PolygonFrom; kNotPlanar.
Result<Item> PlanarFrom(const std::vector<std::vector<Vec3>>& rings, const Vec3* up_hint = nullptr);
/// A box standing in the world. errors  kDegenerateGeometry  a size of 0 or less; kBadNumber.
Result<Item> BoxFrom(const Scope& scope);

Polygon PolygonOf(const Item& flat);  ///< the rectangle made explicit
Mesh MeshOf(const Item& volume);      ///< the box made explicit; a niche's as if it were solid
double AreaOf(const Item& item);      ///< flat: its area; volume: its surface's; else 0; m^2
double VolumeOf(const Item& item);    ///< m^3; 0 for all but volumes

/// The faces of a volume as planar items in the world (a flat item gives itself), with outward
/// normals; the first edge of each is its x axis. A niche's look inward, and its mouth is none.
std::vector<Item> FacesOf(const Item& item);
/// Outline edges in the world, each once, in a fixed order.
std::vector<Segment3> EdgesOf(const Item& item);
void EdgesOf(const Item& item, std::vector<Segment3>* edges);  ///< appends
/// Triangles of its faces in the world, wound as they look: three corners each.
void TrianglesOf(const Item& item, std::vector<Vec3>* corners);

}  // namespace parti::grammar
