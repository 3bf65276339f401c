// extrude(direction, distance): a planar shape swept along the world's up, whatever its slope.
// Along the normal it is extrude.cc's.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "grammar/item_make.h"
#include "grammar/mesh_edges.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kFlatTop = "world.up.flatTop";
/// Shapes that rise more steeply than this would be swept along themselves.
constexpr double kLeastRise = 1e-3;

/// Upright, its x along the shape's as far as that is level.
Scope UprightFrame(const Item& planar) {
  Scope frame;
  frame.origin = planar.scope.origin;
  const Vec3 level(planar.scope.x.x, 0, planar.scope.x.z);
  const bool has_x = glm::length(level) > kLengthTolerance_m;
  frame.x = has_x ? glm::normalize(level) : Vec3(1, 0, 0);
  frame.z = glm::cross(frame.x, frame.y);
  return frame;
}

/// The prism over the shape in the frame's coordinates: its ends at the shape, and moved up by
/// `rise_m` or level with the shape's highest corner moved so.
Mesh Swept(const Item& planar, const Scope& frame, double rise_m, bool flat_top) {
  const double side = rise_m * planar.scope.z.y < 0 ? -1 : 1;
  Mesh mesh = Prism(PolygonOf(planar), side);
  std::vector<Vec3*> far_end;
  double highest = -INFINITY;
  for (Vec3& p : mesh.points) {
    if (p.z != 0) far_end.push_back(&p);
    p = frame.ToLocal(planar.scope.ToWorld(Vec3(p.x, p.y, 0)));
    highest = std::max(highest, p.y);
  }
  for (Vec3* p : far_end) p->y = (flat_top ? highest : p->y) + rise_m;
  StartAtBottom(&mesh);
  return mesh;
}

Result<std::vector<Product>> ApplyExtrudeAlong(const Item& item, const Action& action) {
  const auto& direction = std::get<std::string>(action.arguments[0]);
  const double distance = std::get<double>(action.arguments[1]);
  const bool is_plain = direction.starts_with("face") || direction.starts_with("vertex") ||
                        item.scope.z.y > 1 - kLengthTolerance_m;
  if (is_plain) {
    Action extrude = Default(kExtrude);
    extrude.arguments[0] = distance;
    return kExtrude.apply(item, extrude);
  }
  if (std::abs(distance) <= kLengthTolerance_m || std::abs(item.scope.z.y) < kLeastRise) {
    return Fail(ErrorCode::kDegenerateGeometry, "extrude along the shape itself makes no volume",
                "upright shapes are extruded along their normal: extrude(distance)");
  }
  const Scope frame = UprightFrame(item);
  Mesh mesh = Swept(item, frame, distance, direction == kFlatTop);
  std::vector<Product> products;
  products.push_back({VolumeItem(frame, std::move(mesh), item), -1});
  return products;
}

constexpr std::array<std::string_view, 5> kDirections = {"face.normal", "vertex.normal", "world.up",
                                                         "world.y", kFlatTop};

const std::array<Parameter, 2> kParameters = {
    Parameter{.name = "direction",
              .kind = ParameterKind::kWord,
              .default_value = std::string("world.up"),
              .doc = "the way it is swept; flatTop levels the far end",
              .words = kDirections},
    Parameter{.name = "distance",
              .kind = ParameterKind::kLength,
              .low = -1e4,
              .high = 1e4,
              .default_value = 3.0,
              .doc = "how far; negative goes the other way"}};

}  // namespace

constinit const Operation kExtrudeAlong = {
    .name = "extrudeAlong",
    .word = "ExtrudeAlong",
    .doc = "Sweeps a planar shape straight up, also where it slopes. Rules write extrude, as CGA.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .sampled = false,
    .written = "extrude",
    .apply = ApplyExtrudeAlong,
};

}  // namespace parti::grammar
