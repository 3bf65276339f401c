#include "app/crease_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>

namespace parti::app {
namespace {

constexpr double kTouch_m = 1e-4;    ///< pieces nearer than this along a line touch
constexpr double kOffset_m = 1e-3;   ///< grid on which lines' nearest points are compared
constexpr double kDirection = 1e-4;  ///< grid on which their directions are compared [rad]
constexpr double kFarthest_m = 1e7;  ///< beyond, there is nothing to draw

/// A line as its direction, of the two the one whose first coordinate that isn't 0 is positive, and
/// its point nearest to the origin, both on grids.
using LineKey = std::array<int64_t, 6>;

struct Piece {
  double from, to;  ///< along the direction, from the point nearest to the origin [m]
};

struct Line {
  Vec3 direction, nearest;
  size_t order;  ///< of its first segment
  std::vector<Piece> pieces;
};

Vec3 DirectionOf(const Segment3& segment) {
  const Vec3 d = glm::normalize(segment.b - segment.a);
  for (int i = 0; i < 3; ++i) {
    if (std::abs(d[i]) > kDirection) return d[i] > 0 ? d : -d;
  }
  return d;
}

LineKey KeyOf(const Vec3& direction, const Vec3& nearest) {
  LineKey key{};
  for (int i = 0; i < 3; ++i) {
    key[i] = std::llround(direction[i] / kDirection);
    key[i + 3] = std::llround(nearest[i] / kOffset_m);
  }
  return key;
}

bool IsDrawable(const Segment3& s) {
  const double largest = std::max({std::abs(s.a.x), std::abs(s.a.y), std::abs(s.a.z),
                                   std::abs(s.b.x), std::abs(s.b.y), std::abs(s.b.z)});
  return IsFinite(s.a) && IsFinite(s.b) && largest < kFarthest_m && glm::length(s.b - s.a) > 1e-9;
}

void AppendUnion(const Line& line, std::vector<Segment3>* result) {
  std::vector<Piece> pieces = line.pieces;
  std::sort(pieces.begin(), pieces.end(),
            [](const Piece& a, const Piece& b) { return a.from < b.from; });
  Piece current = pieces.front();
  const auto emit = [&] {
    result->push_back(
        {line.nearest + line.direction * current.from, line.nearest + line.direction * current.to});
  };
  for (const Piece& piece : pieces) {
    if (piece.from > current.to + kTouch_m) {
      emit();
      current = piece;
    }
    current.to = std::max(current.to, piece.to);
  }
  emit();
}

}  // namespace

std::vector<Segment3> WithoutOverlaps(const std::vector<Segment3>& segments) {
  std::map<LineKey, Line> lines;
  for (size_t i = 0; i < segments.size(); ++i) {
    if (!IsDrawable(segments[i])) continue;
    const Vec3 direction = DirectionOf(segments[i]);
    const double a = glm::dot(segments[i].a, direction), b = glm::dot(segments[i].b, direction);
    const Vec3 nearest = segments[i].a - direction * a;
    const auto [it, is_new] =
        lines.emplace(KeyOf(direction, nearest), Line{direction, nearest, i, {}});
    it->second.pieces.push_back({std::min(a, b), std::max(a, b)});
  }
  std::vector<const Line*> in_order;
  in_order.reserve(lines.size());
  for (const auto& [key, line] : lines) in_order.push_back(&line);
  std::sort(in_order.begin(), in_order.end(),
            [](const Line* a, const Line* b) { return a->order < b->order; });
  std::vector<Segment3> result;
  for (const Line* line : in_order) AppendUnion(*line, &result);
  return result;
}

}  // namespace parti::app
