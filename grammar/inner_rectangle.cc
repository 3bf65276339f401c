#include "grammar/inner_rectangle.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace parti::grammar {
namespace {

/// Places along the polygon at which rectangles may begin and end, besides its corners.
constexpr int kPlaces = 32;
constexpr size_t kMostPlaces = 96;
/// Rounds of looking closer around the best, and looks to either side of each of its ends.
constexpr int kRounds = 16;
constexpr int kLooks = 4;
/// Edges longer than this share of the longest of their ring count; directions that differ by less
/// than kSameWay [rad] are one, and the longest kMostWays of them are tried.
constexpr double kLongEnough = 0.25;
constexpr double kSameWay = 0.01;
constexpr size_t kMostWays = 12;

struct Span {
  double low = 0, high = 0;
  double length() const { return std::max(0.0, high - low); }
};

struct Box {
  Span x, y;
  double area() const { return x.length() * y.length(); }
};

/// The polygon turned so that rectangles run along the axes.
class Field {
 public:
  Field(const Polygon& polygon, const Vec2& along) {
    Add(polygon.outer, along);
    for (const Ring& hole : polygon.holes) Add(hole, along);
  }

  std::vector<double> Places() const {
    Span whole{1e300, -1e300};
    std::vector<double> places;
    for (const Segment2& edge : edges_) {
      whole.low = std::min(whole.low, edge.a.x);
      whole.high = std::max(whole.high, edge.a.x);
      places.push_back(edge.a.x);
    }
    std::sort(places.begin(), places.end());
    // Of many corners, some: the rounds that follow find the rest.
    std::vector<double> some;
    const size_t step = places.size() / (kMostPlaces - kPlaces) + 1;
    for (size_t i = 0; i < places.size(); i += step) some.push_back(places[i]);
    some.push_back(places.back());
    for (int i = 0; i <= kPlaces; ++i) {
      some.push_back(whole.low + (whole.high - whole.low) * i / kPlaces);
    }
    std::sort(some.begin(), some.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    return some;
  }

  /// The longest span of y that is inside all the way along x.
  Span Widest(const Span& x) const {
    if (!(x.length() > 0)) return {};
    // What edges block: between blocks, one point decides whether all of it is inside.
    blocks_.clear();
    for (const Segment2& edge : edges_) {
      const double low = std::min(edge.a.x, edge.b.x), high = std::max(edge.a.x, edge.b.x);
      if (high <= x.low || low >= x.high) continue;
      blocks_.push_back(low < high ? Heights(edge, x) : Ordered(edge.a.y, edge.b.y));
    }
    std::sort(blocks_.begin(), blocks_.end(),
              [](const Span& a, const Span& b) { return a.low < b.low; });
    Span widest;
    double reached = blocks_.empty() ? 0 : blocks_[0].high;
    for (const Span& block : blocks_) {
      const Span gap{reached, block.low};
      if (gap.length() > widest.length() &&
          IsInside(Vec2((x.low + x.high) / 2, (gap.low + gap.high) / 2))) {
        widest = gap;
      }
      reached = std::max(reached, block.high);
    }
    return widest;
  }

 private:
  void Add(const Ring& ring, const Vec2& along) {
    const auto turn = [&](const Vec2& p) { return Vec2(glm::dot(along, p), Cross(along, p)); };
    for (size_t i = 0; i < ring.size(); ++i) {
      edges_.push_back({turn(ring[i]), turn(ring[(i + 1) % ring.size()])});
    }
  }

  static Span Ordered(double a, double b) { return {std::min(a, b), std::max(a, b)}; }

  /// Of the part of the edge over x.
  static Span Heights(const Segment2& edge, const Span& x) {
    const auto at = [&](double place) {
      const double t = std::clamp((place - edge.a.x) / (edge.b.x - edge.a.x), 0.0, 1.0);
      return edge.a.y + (edge.b.y - edge.a.y) * t;
    };
    return Ordered(at(x.low), at(x.high));
  }

  bool IsInside(const Vec2& p) const {
    bool inside = false;
    for (const Segment2& edge : edges_) {
      const Vec2 &a = edge.a, &b = edge.b;
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
    return inside;
  }

  std::vector<Segment2> edges_;
  mutable std::vector<Span> blocks_;
};

Box LargestBetween(const Field& field, const std::vector<double>& places) {
  Box best;
  for (size_t i = 0; i < places.size(); ++i) {
    for (size_t j = i + 1; j < places.size(); ++j) {
      const Span x{places[i], places[j]};
      const Box box{x, field.Widest(x)};
      if (box.area() > best.area()) best = box;
      if (box.y.length() <= 0) break;  // a wider span holds no more
    }
  }
  return best;
}

/// Looks closer and closer around the ends of the best. The polygon reaches over `whole`.
Box Improved(const Field& field, const Span& whole, Box best, double step) {
  for (int round = 0; round < kRounds; ++round, step /= 2) {
    const Span around = best.x;
    for (int i = -kLooks; i <= kLooks; ++i) {
      for (int j = -kLooks; j <= kLooks; ++j) {
        const Span x{std::max(whole.low, around.low + i * step / kLooks),
                     std::min(whole.high, around.high + j * step / kLooks)};
        const Box box{x, field.Widest(x)};
        if (box.area() > best.area()) best = box;
      }
    }
  }
  return best;
}

/// The edges of a ring that rectangles may run along.
void AddLongEdges(const Ring& ring, std::vector<Vec2>* edges) {
  std::vector<Vec2> all;
  double longest = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    all.push_back(ring[(i + 1) % ring.size()] - ring[i]);
    longest = std::max(longest, glm::length(all.back()));
  }
  for (const Vec2& edge : all) {
    if (glm::length(edge) >= kLongEnough * longest) edges->push_back(edge);
  }
}

/// Unit directions, the longest edge's first; of those that are nearly the same, one.
std::vector<Vec2> WaysOf(const Polygon& polygon) {
  std::vector<Vec2> edges;
  AddLongEdges(polygon.outer, &edges);
  for (const Ring& hole : polygon.holes) AddLongEdges(hole, &edges);
  std::stable_sort(edges.begin(), edges.end(),
                   [](const Vec2& a, const Vec2& b) { return glm::length(a) > glm::length(b); });
  std::vector<Vec2> ways;
  for (const Vec2& edge : edges) {
    const Vec2 way = glm::normalize(edge);
    const auto is_same = [&](const Vec2& other) {
      return std::min(std::abs(Cross(way, other)), std::abs(glm::dot(way, other))) < kSameWay;
    };
    if (ways.size() < kMostWays && std::none_of(ways.begin(), ways.end(), is_same)) {
      ways.push_back(way);
    }
  }
  return ways;
}

}  // namespace

std::optional<Ring> InnerRectangle(const Polygon& polygon, const Vec2& along) {
  const Field field(polygon, along);
  const std::vector<double> places = field.Places();
  const Span whole{places.front(), places.back()};
  const Box best = Improved(field, whole, LargestBetween(field, places), whole.length() / kPlaces);
  if (best.area() < kAreaTolerance_m2) return std::nullopt;
  const Vec2 across(-along.y, along.x);
  const auto at = [&](double x, double y) { return along * x + across * y; };
  return Ring{at(best.x.low, best.y.low), at(best.x.high, best.y.low), at(best.x.high, best.y.high),
              at(best.x.low, best.y.high)};
}

std::optional<Ring> InnerRectangleAlongEdges(const Polygon& polygon) {
  std::optional<Ring> best;
  for (const Vec2& way : WaysOf(polygon)) {
    auto found = InnerRectangle(polygon, way);
    if (found && (!best || SignedArea(*found) > SignedArea(*best))) best = std::move(found);
  }
  return best;
}

}  // namespace parti::grammar
