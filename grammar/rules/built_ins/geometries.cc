// geometry.area, geometry.isRectangular …: what a shape's geometry is like.
#include <algorithm>
#include <cmath>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

size_t CornersOf(const Ring& outer, const std::vector<Ring>& holes) {
  size_t count = outer.size();
  for (const Ring& hole : holes) count += hole.size();
  return count;
}

Value EdgeCount(Values, const Situation& situation) {
  return static_cast<double>(EdgesOf(*situation.item).size());
}

Value FaceCount(Values, const Situation& situation) {
  const Item& item = *situation.item;
  if (item.type != ItemType::kVolume) return 1.0;
  return item.mesh ? static_cast<double>(item.mesh->faces.size()) : 6.0;
}

Value VertexCount(Values, const Situation& situation) {
  const Item& item = *situation.item;
  if (item.type == ItemType::kVolume) {
    return item.mesh ? static_cast<double>(item.mesh->points.size()) : 8.0;
  }
  if (!item.polygon) return 4.0;
  return static_cast<double>(CornersOf(item.polygon->outer, item.polygon->holes));
}

Value HoleCount(Values, const Situation& situation) {
  const Item& item = *situation.item;
  double count = item.polygon ? static_cast<double>(item.polygon->holes.size()) : 0.0;
  if (!item.mesh) return count;
  for (const MeshFace& face : item.mesh->faces) count += static_cast<double>(face.holes.size());
  return count;
}

/// Whether the corners at which a ring turns are four, each within `most_deg` of a right angle.
bool IsRectangular(const Ring& ring, double most_deg) {
  int corners = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Vec2 out = ring[(i + 1) % ring.size()] - ring[i];
    const double turn =
        Angle::Radians(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out))).degrees();
    if (std::abs(turn) <= most_deg) continue;
    if (std::abs(turn - 90) > most_deg) return false;
    ++corners;
  }
  return corners == 4;
}

Value Rectangular(Values values, const Situation& situation) {
  constexpr double kUsual_deg = 1;
  const Item& item = *situation.item;
  if (item.type == ItemType::kVolume) return !item.mesh;
  if (!item.polygon) return true;
  if (!item.polygon->holes.empty()) return false;
  return IsRectangular(item.polygon->outer, values.empty() ? kUsual_deg : NumberOf(values[0]));
}

bool IsConcave(const Ring& ring) {
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 in = ring[(i + 1) % ring.size()] - ring[i];
    const Vec2 out = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
    if (in.x * out.y - in.y * out.x < -kAreaTolerance_m2) return true;
  }
  return false;
}

Value Concave(Values, const Situation& situation) {
  const Item& item = *situation.item;
  return item.polygon && (!item.polygon->holes.empty() || IsConcave(item.polygon->outer));
}

Value OutlineLength(Values, const Situation& situation) {
  if (situation.item->type == ItemType::kVolume) return 0.0;
  double length = 0;
  for (const Segment3& edge : EdgesOf(*situation.item)) length += glm::length(edge.b - edge.a);
  return length;
}

/// Highest over lowest point in the world.
Value Height(Values, const Situation& situation) {
  double low = INFINITY, high = -INFINITY;
  for (const Segment3& edge : EdgesOf(*situation.item)) {
    low = std::min({low, edge.a.y, edge.b.y});
    high = std::max({high, edge.a.y, edge.b.y});
  }
  return high > low ? high - low : 0.0;
}

/// Of the direction in which a shape looks: up from the ground (zenith: from straight up, azimuth:
/// from south towards east), in degrees.
Value AngleOf(Values values, const Situation& situation) {
  const Vec3& n = situation.item->facing;
  const std::string which = TextOf(values[0]);
  if (which == "azimuth") return Angle::Radians(std::atan2(n.x, n.z)).degrees();
  const double zenith = Angle::Radians(std::atan2(std::hypot(n.x, n.z), n.y)).degrees();
  return which == "zenith" ? zenith : std::min(zenith, 180 - zenith);
}

constexpr std::array<std::string_view, 3> kAngles = {"zenith", "azimuth", "maxSlope"};

constexpr BuiltIn kRows[] = {
    {"geometry.area",
     {},
     kNumber,
     "its area in square metres; a volume's is its surface",
     [](Values, const Situation& situation) -> Value { return AreaOf(*situation.item); }},
    {"geometry.volume",
     {},
     kNumber,
     "its volume in cubic metres; 0 for what is flat",
     [](Values, const Situation& situation) -> Value { return VolumeOf(*situation.item); }},
    {"geometry.height", {}, kNumber, "its highest point over its lowest, in metres", Height},
    {"geometry.boundaryLength",
     {},
     kNumber,
     "the length of a flat shape's outline and holes",
     OutlineLength},
    {"geometry.nEdges", {}, kNumber, "how many edges it has", EdgeCount},
    {"geometry.nFaces", {}, kNumber, "how many faces", FaceCount},
    {"geometry.nVertices", {}, kNumber, "how many corners", VertexCount},
    {"geometry.nHoles", {}, kNumber, "how many holes", HoleCount},
    {"geometry.isRectangular",
     {},
     kBool,
     "whether it is a rectangle (to 1 degree) or a box",
     Rectangular},
    {"geometry.isRectangular", First(kNumbers, 1), kBool, "the same to the given degrees",
     Rectangular},
    {"geometry.isConcave",
     {},
     kBool,
     "whether a flat shape has a corner that goes in, or a hole",
     Concave},
    {"geometry.isPlanar",
     {},
     kBool,
     "whether it is flat",
     [](Values, const Situation& situation) -> Value {
       return situation.item->type != ItemType::kVolume;
     }},
    {"geometry.isClosedSurface",
     {},
     kBool,
     "whether it encloses a volume",
     [](Values, const Situation& situation) -> Value {
       return situation.item->type == ItemType::kVolume;
     }},
    {"geometry.angle", First(kTexts, 1), kNumber,
     "of the direction in which it looks, in degrees: \"zenith\" (from straight up), \"azimuth\" "
     "(from south towards east), \"maxSlope\"",
     AngleOf, kAngles},
};

}  // namespace

std::span<const BuiltIn> Geometries() { return kRows; }

}  // namespace parti::grammar::built_ins
