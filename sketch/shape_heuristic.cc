// shapeL, shapeU, shapeO: lines in a lying shape that turn corners with each other, each parallel
// to a side. What they enclose together with the outline is the remainder; the wings are around it.
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "grammar/front_edge.h"
#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

using grammar::StreetSide;
// Widths of the wings, by side; those without a line have none.
using Widths = std::map<StreetSide, double>;

struct Row {
  std::string_view name;
  std::vector<StreetSide> sides;  // in the order of its parameters
};

const std::array<Row, 3>& Rows() {
  using enum StreetSide;
  static const std::array<Row, 3> kRows = {{{"shapeL", {kFront, kLeft}},
                                            {"shapeU", {kFront, kRight, kLeft}},
                                            {"shapeO", {kFront, kRight, kBack, kLeft}}}};
  return kRows;
}

struct Line {
  Segment2 local;
  int across;  // the scope's axis that it lies at right angles to
};

// The fittest reading in the item's plane along one of its axes.
std::optional<Line> InPlane(const WorldLine& line, const grammar::Item& item, double near_m,
                            Angle tolerance) {
  for (const LiftCandidate& reading : ReadingsOf(line)) {
    const Segment3 local{item.scope.ToLocal(reading.world.a), item.scope.ToLocal(reading.world.b)};
    if (std::abs(local.a.z) > near_m || std::abs(local.b.z) > near_m) continue;
    const Vec3 direction = DirectionOf(local);
    for (const int across : {0, 1}) {
      Vec3 along(0, 0, 0);
      along[1 - across] = 1;
      if (!Parallel(direction, along, tolerance)) continue;
      return Line{{Vec2(local.a.x, local.a.y), Vec2(local.b.x, local.b.y)}, across};
    }
  }
  return std::nullopt;
}

double MiddleAt(const Line& line, int axis) {
  return (line.local.a[axis] + line.local.b[axis]) / 2;
}

// Where the other lines are, seen from this one, lies what is enclosed.
double MiddleOfOthers(const std::vector<Line>& lines, size_t own) {
  double sum = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (i != own) sum += MiddleAt(lines[i], lines[own].across);
  }
  return sum / static_cast<double>(lines.size() - 1);
}

Widths WidthsOf(const std::vector<Line>& lines, const grammar::Item& item) {
  const Vec3 front = grammar::FrontOf(item);
  std::map<StreetSide, std::pair<double, int>> sums;
  for (size_t i = 0; i < lines.size(); ++i) {
    const int across = lines[i].across;
    const double at = MiddleAt(lines[i], across);
    const bool low = MiddleOfOthers(lines, i) > at;  // the wing is on the side of lower coordinates
    const Vec3 outward = item.scope.axis(across) * (low ? -1.0 : 1.0);
    auto& [sum, count] = sums[grammar::StreetSideOf(front, item.scope.z, outward)];
    sum += low ? at : item.scope.size[across] - at;
    ++count;
  }
  Widths widths;
  for (const auto& [side, sum] : sums) widths[side] = sum.first / sum.second;
  return widths;
}

bool TurnsACorner(const std::vector<Line>& lines) {
  const auto across_x = [](const Line& line) { return line.across == 0; };
  return std::ranges::any_of(lines, across_x) && !std::ranges::all_of(lines, across_x);
}

// Nothing where a line stands for a side that the row has no width for.
std::optional<Hypothesis> As(const Row& row, const Widths& widths) {
  const grammar::Operation* operation = grammar::FindOperation(row.name);
  if (!operation) return std::nullopt;
  Hypothesis hypothesis{ShapeAction(*operation)};
  size_t used = 0;
  for (size_t i = 0; i < row.sides.size(); ++i) {
    const auto width = widths.find(row.sides[i]);
    hypothesis.action.arguments[i] = width == widths.end() ? 0.0 : width->second;
    if (width == widths.end()) continue;
    hypothesis.turned.push_back(i);
    ++used;
  }
  if (used < widths.size()) return std::nullopt;
  return hypothesis;
}

}  // namespace

std::vector<Hypothesis> ShapeHeuristic(const Configuration& configuration,
                                       const grammar::Item& item,
                                       const HeuristicParameters& parameters) {
  std::vector<Hypothesis> hypotheses;
  if (!parameters.partly || item.type != grammar::ItemType::kPlanar || !LooksUp(item)) {
    return hypotheses;
  }
  const double near_m = parameters.near_relative * DiagonalOf(item);
  std::vector<Line> lines;
  for (const WorldLine& line : configuration.lines) {
    const auto in_plane = InPlane(line, item, near_m, Angle::Degrees(parameters.angle_deg));
    if (in_plane) lines.push_back(*in_plane);
  }
  if (lines.size() < 2 || !TurnsACorner(lines)) return hypotheses;
  const Widths widths = WidthsOf(lines, item);
  for (const Row& row : Rows()) {
    auto hypothesis = As(row, widths);
    if (!hypothesis) continue;
    hypothesis->price = parameters.wings;
    hypotheses.push_back(std::move(*hypothesis));
    break;  // the row with the fewest widths says the same as those with more
  }
  return hypotheses;
}

}  // namespace parti::sketch
