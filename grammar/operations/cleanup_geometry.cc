// cleanupGeometry(components, tolerance): corners that say nothing taken off an outline.
#include <array>
#include <cmath>
#include <utility>

#include "grammar/item_make.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// Corners at which an outline turns by less lie on a straight edge.
constexpr double kStraight_deg = 1;

double TurnAt(const Ring& ring, size_t i) {
  const size_t n = ring.size();
  const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
  return std::abs(
      Angle::Radians(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out))).degrees());
}

/// Without corners nearer than the tolerance to the one before them, or on a straight edge; fewer
/// than three where nothing would be left.
Ring Cleaned(const Ring& ring, double tolerance_m, bool merges, bool straightens) {
  Ring kept;
  for (const Vec2& p : ring) {
    const bool is_near = merges && !kept.empty() && glm::distance(kept.back(), p) < tolerance_m;
    if (!is_near) kept.push_back(p);
  }
  while (merges && kept.size() > 3 && glm::distance(kept.back(), kept.front()) < tolerance_m) {
    kept.pop_back();
  }
  for (size_t i = 0; straightens && kept.size() > 3 && i < kept.size();) {
    if (TurnAt(kept, i) < kStraight_deg) {
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
  return kept;
}

constexpr std::string_view kAll = "all", kEdges = "edges", kVertices = "vertices", kFaces = "faces";

Result<std::vector<Product>> ApplyCleanup(const Item& item, const Action& action) {
  std::vector<Product> same{{item, -1}};
  if (!item.polygon || item.type != ItemType::kPlanar) return same;
  const auto& what = std::get<std::string>(action.arguments[0]);
  const double tolerance_m = std::get<double>(action.arguments[1]);
  const bool merges = what == kAll || what == kVertices;
  const bool straightens = what == kAll || what == kEdges;
  std::vector<Ring> rings{Cleaned(item.polygon->outer, tolerance_m, merges, straightens)};
  for (const Ring& hole : item.polygon->holes) {
    const Ring cleaned = Cleaned(hole, tolerance_m, merges, straightens);
    rings.push_back(cleaned.size() < 3 ? hole : cleaned);
  }
  auto polygon = PolygonFrom(rings);
  if (!polygon) return same;  // too coarse for this outline
  Item cleaned = PlanarItem(item.scope, std::move(*polygon), item);
  cleaned.anchor = item.anchor;
  return std::vector<Product>{{std::move(cleaned), -1}};
}

constexpr std::array<std::string_view, 4> kComponents = {kAll, kEdges, kVertices, kFaces};

const std::array<Parameter, 2> kParameters = {
    Parameter{.name = "components",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kAll),
              .doc = "vertices: those too near to each other; edges: corners on straight ones",
              .words = kComponents},
    Parameter{.name = "tolerance",
              .kind = ParameterKind::kLength,
              .low = 0,
              .high = 1e4,
              .default_value = 0.1,
              .doc = "vertices nearer than this become one"}};

}  // namespace

constinit const Operation kCleanupGeometry = {
    .name = "cleanupGeometry",
    .word = "CleanupGeometry",
    .doc =
        "Takes corners off the outline of a planar shape that say nothing. Volumes, and outlines "
        "that it would make cross themselves, stay as they are.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyCleanup,
};

}  // namespace parti::grammar
