// Vectors, angles, planes and segments shared by every folder.
// World: metres, right-handed, y up, north is -z, east is +x.
// Views: pixels, origin top left, y down.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace parti {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Vec4 = glm::dvec4;
using Mat4 = glm::dmat4;

inline constexpr double kPi = 3.14159265358979323846;

/// An angle whose unit is said where it is made and where it is read. Kept in degrees, as people
/// and files write them, so that those come back unchanged.
class Angle {
 public:
  static constexpr Angle Degrees(double degrees) { return Angle(degrees); }
  static constexpr Angle Radians(double radians) { return Angle(radians * 180.0 / kPi); }
  constexpr double radians() const { return degrees_ * kPi / 180.0; }
  constexpr double degrees() const { return degrees_; }
  auto operator<=>(const Angle&) const = default;

 private:
  constexpr explicit Angle(double degrees) : degrees_(degrees) {}
  double degrees_;
};

/// Neither NaN nor infinite in any coordinate.
inline bool IsFinite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline bool IsFinite(const Vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// z of the 3D cross product; positive when b lies counter-clockwise of a in a y-up frame.
inline double Cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// A straight line between two points; a direction only where its user says so.
template <typename Point>
struct Segment {
  Point a{};
  Point b{};
};
using Segment2 = Segment<Vec2>;
using Segment3 = Segment<Vec3>;

/// Points p with dot(normal, p) == offset; normal has unit length.
struct Plane {
  Vec3 normal{0, 1, 0};
  double offset = 0;
};

/// Points origin + t direction, t >= 0.
struct Ray {
  Vec3 origin{};
  Vec3 direction{0, 0, -1};  ///< unit length
};

}  // namespace parti
