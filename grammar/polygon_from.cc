// Rings as people and files give them to a Polygon: cleaning, winding, and the refusals.
#include <fmt/format.h>

#include "grammar/polygon.h"
#include "grammar/polygon_crossing.h"
#include "grammar/polygon_nesting.h"

namespace parti::grammar {
namespace {

/// Ring 0 is the outline.
std::string NameOfRing(size_t ring) {
  return ring == 0 ? "the outline" : fmt::format("hole {}", ring);
}

/// The tolerance of contacts: kLengthTolerance_m, or what doubles can tell apart out there.
double ContactTolerance(const std::vector<Ring>& rings) {
  double extent = 0;
  for (const Ring& ring : rings) {
    for (const Vec2& p : ring) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  }
  return std::max(kLengthTolerance_m, 1e-15 * extent);
}

/// Whether ring runs through corner i and straight back: a spike without width.
bool IsSpike(const Ring& ring, size_t i) {
  const size_t n = ring.size();
  const Vec2 in = ring[(i + n - 1) % n] - ring[i];
  const Vec2 out = ring[(i + 1) % n] - ring[i];
  if (glm::dot(in, out) <= 0) return false;
  const double longer = std::max(glm::length(in), glm::length(out));
  return std::abs(Cross(in, out)) <= kLengthTolerance_m * longer;
}

void DropSpikes(Ring* ring) {
  for (size_t i = 0; ring->size() >= 3 && i < ring->size();) {
    if (!IsSpike(*ring, i)) {
      ++i;
      continue;
    }
    ring->erase(ring->begin() + static_cast<std::ptrdiff_t>(i));
    DropRepeatedCorners(ring);
    i = i >= 2 ? i - 2 : 0;  // what was hidden behind the spike may be one, too
  }
}

/// Reverses the winding and keeps the first edge first: it gives the scope its x axis.
void Reverse(Ring* ring) {
  std::reverse(ring->begin(), ring->end());
  std::rotate(ring->begin(), ring->end() - 2, ring->end());
}

Result<Ring> CleanRing(const Ring& given, size_t number) {
  for (const Vec2& p : given) {
    // Written so that NaN fails, too.
    if (std::abs(p.x) <= kLargestCoordinate_m && std::abs(p.y) <= kLargestCoordinate_m) continue;
    return Fail(
        ErrorCode::kBadNumber,
        fmt::format("{} has a corner at ({:.6g}, {:.6g})", NameOfRing(number), p.x, p.y),
        fmt::format("give finite coordinates in metres, up to {:.0g}", kLargestCoordinate_m));
  }
  Ring ring = given;
  DropRepeatedCorners(&ring);
  DropSpikes(&ring);
  if (ring.size() < 3) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("{} has {} distinct corner{} that span an area; a polygon needs 3",
                            NameOfRing(number), ring.size() == 2 ? 0 : ring.size(), "s"),
                "give at least 3 corners that are not on one line");
  }
  return ring;
}

Result<void> CheckApart(const std::vector<Ring>& rings, const Vec2& origin) {
  const auto contact = FindContact(rings, ContactTolerance(rings));
  if (!contact) return {};
  const Vec2 at = contact->at + origin;
  const bool same = contact->ring_a == contact->ring_b;
  return Fail(ErrorCode::kSelfIntersecting,
              fmt::format("{} {} {} at ({:.3f}, {:.3f}), edges {} and {}",
                          NameOfRing(contact->ring_a), contact->crosses ? "crosses" : "touches",
                          same ? "itself" : NameOfRing(contact->ring_b), at.x, at.y,
                          contact->edge_a, contact->edge_b),
              "move a corner, or give the parts as polygons of their own");
}

Result<void> CheckAreas(const std::vector<Ring>& rings) {
  for (size_t i = 0; i < rings.size(); ++i) {
    if (std::abs(SignedArea(rings[i])) >= kAreaTolerance_m2) continue;
    return Fail(ErrorCode::kDegenerateGeometry, fmt::format("{} has no area", NameOfRing(i)),
                "give at least 3 corners that are not on one line");
  }
  return {};
}

/// Rings don't touch, so that one corner decides.
Result<void> CheckNesting(const Polygon& polygon) {
  const auto fail = [](size_t hole, std::string_view what) {
    return Fail(ErrorCode::kSelfIntersecting, fmt::format("hole {} lies {}", hole + 1, what),
                "a hole must lie inside the outline and outside the other holes");
  };
  for (size_t i = 0; i < polygon.holes.size(); ++i) {
    const Vec2& corner = polygon.holes[i][0];
    if (!Contains({polygon.outer, {}}, corner)) return fail(i, "outside the outline");
    for (size_t j = 0; j < polygon.holes.size(); ++j) {
      if (j != i && Contains({polygon.holes[j], {}}, corner)) return fail(i, "inside another");
    }
  }
  return {};
}

}  // namespace

Result<Polygon> PolygonFrom(const std::vector<Ring>& rings) {
  if (rings.empty()) {
    return Fail(ErrorCode::kDegenerateGeometry, "a polygon without an outline",
                "give at least 3 corners");
  }
  std::vector<Ring> clean;
  for (size_t i = 0; i < rings.size(); ++i) {
    auto ring = CleanRing(rings[i], i);
    if (!ring) return Fail(ring);
    clean.push_back(std::move(*ring));
  }
  // Checked near the origin: map coordinates of 1e5 m and more would cost the checks their digits.
  const Vec2 origin = clean[0][0];
  std::vector<Ring> local = clean;
  for (Ring& ring : local) {
    for (Vec2& p : ring) p -= origin;
  }
  if (const auto apart = CheckApart(local, origin); !apart) return Fail(apart);
  if (const auto areas = CheckAreas(local); !areas) return Fail(areas);
  for (size_t i = 0; i < clean.size(); ++i) {
    if ((SignedArea(local[i]) > 0) != (i == 0)) Reverse(&clean[i]);
  }
  Polygon polygon{std::move(clean[0]), {}};
  for (size_t i = 1; i < clean.size(); ++i) polygon.holes.push_back(std::move(clean[i]));
  if (const auto nesting = CheckNesting(polygon); !nesting) return Fail(nesting);
  return polygon;
}

}  // namespace parti::grammar
