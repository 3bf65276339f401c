#include "app/lot_from_stroke.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "app/lot_squaring.h"
#include "grammar/polygon.h"

namespace parti::app {
namespace {

Result<void> CheckSizeOnScreen(std::span<const std::shared_ptr<const DrawnStroke>> strokes,
                               double smallest_px) {
  double largest = 0;
  for (const auto& drawn : strokes) largest = std::max(largest, Diagonal(drawn->stroke));
  if (largest >= smallest_px) return {};
  return Fail(ErrorCode::kTooShort, "this is too small for the outline of a lot",
              "draw it larger: a closed line around the building's ground");
}

/// A polygon that can be built on.
Result<void> CheckRing(const grammar::Ring& ring, const LotParameters& parameters) {
  const grammar::Box2 box = grammar::Bounds({ring, {}});
  const Vec2 size = box.high - box.low;
  const double extent = std::max(size.x, size.y);
  if (!(extent <= parameters.largest_m)) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("this outline is {:.0f} m wide", extent),
                "it runs to the horizon: look from higher up, or draw nearer");
  }
  if (extent < parameters.smallest_m) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("this outline is {:.2g} m wide", extent),
                "step back, or draw it larger");
  }
  const auto polygon = grammar::PolygonFrom({ring});
  if (!polygon && polygon.error().code == ErrorCode::kSelfIntersecting) {
    return Fail(ErrorCode::kSelfIntersecting, "this outline crosses itself",
                "draw it around the lot once");
  }
  if (!polygon || grammar::Area(*polygon) < parameters.thinnest * extent * extent) {
    return Fail(ErrorCode::kDegenerateGeometry, "this outline has hardly any ground in it",
                "draw it around the lot once");
  }
  return {};
}

/// Counter-clockwise from above, beginning with the side that faces south most, so that the lot's x
/// is the same however it was drawn.
grammar::Ring FromTheSouth(grammar::Ring ring) {
  if (grammar::SignedArea(ring) > 0) std::reverse(ring.begin(), ring.end());  // z is south
  size_t first = 0;
  double most = -2, longest = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 side = ring[(i + 1) % ring.size()] - ring[i];
    const double length = glm::length(side), south = side.x / length;
    constexpr double kAlike = 1e-6;
    if (south < most - kAlike || (south < most + kAlike && length <= longest)) continue;
    first = i;
    most = south;
    longest = length;
  }
  std::rotate(ring.begin(), ring.begin() + static_cast<ptrdiff_t>(first), ring.end());
  return ring;
}

double DistanceFrom(const grammar::Ring& ring, const Vec2& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], along = ring[(i + 1) % ring.size()] - a;
    const double u = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, a + along * u));
  }
  return nearest;
}

/// What was drawn runs along the outline that was read from it.
Result<void> CheckFit(const std::vector<OutlinePiece>& pieces, const grammar::Ring& ring,
                      const LotParameters& parameters) {
  const grammar::Box2 box = grammar::Bounds({ring, {}});
  const double farthest = parameters.farthest_off * glm::distance(box.low, box.high);
  for (const OutlinePiece& piece : pieces) {
    for (const Vec2& p : piece.points) {
      if (DistanceFrom(ring, p) <= farthest) continue;
      return Fail(ErrorCode::kDegenerateGeometry, "no outline of a lot can be read from this",
                  "draw it around the lot once, or its sides one by one");
    }
  }
  return {};
}

}  // namespace

Result<std::string> LotFromStrokes(std::span<const std::shared_ptr<const DrawnStroke>> strokes,
                                   const LotParameters& parameters) {
  const auto visible = CheckSizeOnScreen(strokes, parameters.smallest_px);
  if (!visible) return Fail(visible);
  const auto pieces = ClosedOutline(strokes, parameters);
  if (!pieces) return Fail(pieces);
  const grammar::Ring ring = FromTheSouth(SquaredOutline(*pieces, parameters));
  if (const auto sound = CheckRing(ring, parameters); !sound) return Fail(sound);
  if (const auto fit = CheckFit(*pieces, ring, parameters); !fit) return Fail(fit);
  std::vector<std::string> corners;
  for (const Vec2& p : ring) corners.push_back(fmt::format("{},{}", p.x, p.y));
  return fmt::format("poly({})", fmt::join(corners, " "));
}

}  // namespace parti::app
