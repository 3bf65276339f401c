#include "grammar/layers/path_arc.h"

#include <cmath>

namespace parti::grammar {
namespace {

constexpr double kHalfTurn = 3.141592653589793;

double AngleOf(const Vec2& v) { return std::atan2(v.y, v.x); }

}  // namespace

std::optional<PathSegment> ArcBetween(const Vec2& from, const Vec2& to, const ArcForm& form) {
  Vec2 radii = glm::abs(form.radii);
  constexpr double kLeast = 1e-9;
  if (radii.x < kLeast || radii.y < kLeast || from == to) return std::nullopt;
  const double turned = std::fmod(form.turned_deg, 360) * kHalfTurn / 180;
  const double c = std::cos(turned), s = std::sin(turned);
  // In the ellipse's axes, around the middle of the ends: (F.6.5.1).
  const Vec2 half = (from - to) * 0.5;
  const Vec2 p(c * half.x + s * half.y, -s * half.x + c * half.y);
  const Vec2 unit = p / radii;
  const double reach = glm::dot(unit, unit);
  if (reach > 1) radii *= std::sqrt(reach);  // (F.6.6.3)
  const double share = reach > 1 ? 0 : std::sqrt(1 / reach - 1);
  const double side = form.large == form.counter_clockwise ? -share : share;
  const Vec2 centre = Vec2(radii.x * p.y / radii.y, -radii.y * p.x / radii.x) * side;  // (F.6.5.2)
  PathSegment arc;
  arc.kind = PathSegment::Kind::kArc;
  const Vec2 middle = (from + to) * 0.5;
  arc.points = {from, to, middle + Vec2(c * centre.x - s * centre.y, s * centre.x + c * centre.y)};
  arc.radii = radii;
  arc.turned = turned;
  arc.from = AngleOf((p - centre) / radii);
  arc.by = AngleOf((-p - centre) / radii) - arc.from;
  if (form.counter_clockwise && arc.by <= 0) arc.by += 2 * kHalfTurn;
  if (!form.counter_clockwise && arc.by >= 0) arc.by -= 2 * kHalfTurn;
  return arc;
}

}  // namespace parti::grammar
