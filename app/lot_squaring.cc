#include "app/lot_squaring.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace parti::app {
namespace {

using Ring = std::vector<Vec2>;

/// The outline's main directions: u and, a quarter turn on, v.
struct Frame {
  Vec2 u{1, 0};
  Vec2 v{0, 1};

  explicit Frame(double angle) : u(std::cos(angle), std::sin(angle)), v(-u.y, u.x) {}
  Vec2 To(const Vec2& p) const { return {glm::dot(p, u), glm::dot(p, v)}; }
  Vec2 From(const Vec2& p) const { return u * p.x + v * p.y; }
};

/// A side in the frame's coordinates; `axis` 0 or 1 where it follows u or v.
struct Side {
  Segment2 line;
  std::optional<int> axis;

  double length() const { return glm::distance(line.a, line.b); }
};

/// How far a line's direction is from `angle` or a right angle to it; signed, at most an eighth
/// turn.
double Deviation(const Segment2& line, double angle) {
  const Vec2 d = line.b - line.a;
  return std::remainder(std::atan2(d.y, d.x) - angle, kPi / 2);
}

/// The direction, modulo a right angle, that most of the length follows: a side's, and then the
/// mean of those that follow it.
double MainAngle(const std::vector<Segment2>& lines, double square) {
  double best = -1, angle = 0;
  for (const Segment2& candidate : lines) {
    const Vec2 d = candidate.b - candidate.a;
    const double own = std::atan2(d.y, d.x);
    double votes = 0, sum = 0;
    for (const Segment2& line : lines) {
      const double off = Deviation(line, own);
      const double weight =
          glm::distance(line.a, line.b) * std::max(0.0, 1 - std::abs(off) / square);
      votes += weight;
      sum += weight * off;
    }
    if (votes <= best) continue;
    best = votes;
    angle = own + sum / votes;
  }
  return angle;
}

double SquareAngle(size_t sides, const LotParameters& parameters) {
  return Angle::Degrees(sides == 3 ? parameters.square_triangle_deg : parameters.square_deg)
      .radians();
}

double NearestMultiple(double value, double step) { return std::round(value / step) * step; }

double ReadableAngle(double angle, const LotParameters& parameters) {
  const double north = NearestMultiple(angle, kPi / 2);
  if (std::abs(angle - north) <= Angle::Degrees(parameters.north_deg).radians()) return north;
  return NearestMultiple(angle, Angle::Degrees(parameters.angle_step_deg).radians());
}

/// The coarsest of …, 5, 2, 1, 0.5 … that is at most `most`.
double ReadableStep(double most) {
  const double decade = std::pow(10, std::floor(std::log10(std::max(most, 1e-3))));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade <= most) return factor * decade;
  }
  return decade;
}

Side SideOf(const Segment2& line, double square) {
  const Vec2 d = line.b - line.a;
  Side side{line, std::nullopt};
  if (std::abs(std::atan2(std::abs(d.y), std::abs(d.x))) <= square) side.axis = 0;
  if (std::abs(std::atan2(std::abs(d.x), std::abs(d.y))) <= square) side.axis = 1;
  if (!side.axis) return side;
  // Turned about its middle.
  const int across = 1 - *side.axis;
  side.line.a[across] = side.line.b[across] = (line.a[across] + line.b[across]) / 2;
  return side;
}

std::optional<Vec2> Crossing(const Side& s, const Side& t) {
  const Vec2 u = s.line.b - s.line.a, v = t.line.b - t.line.a;
  const double cross = Cross(u, v);
  constexpr double kParallel = 0.2;  // sine of 12 degrees
  if (std::abs(cross) < kParallel * glm::length(u) * glm::length(v)) return std::nullopt;
  return s.line.a + u * (Cross(t.line.a - s.line.a, v) / cross);
}

/// Where the corner between two sides lies: where their lines cross, unless that is far from both.
Vec2 CornerOf(const Side& s, const Side& t) {
  const Vec2 middle = (s.line.b + t.line.a) * 0.5;
  const auto crossing = Crossing(s, t);
  const double reach = 0.5 * std::max(s.length(), t.length());
  return crossing && glm::distance(*crossing, middle) <= reach ? *crossing : middle;
}

/// Sides that follow the same direction one after the other are steps of the hand: the longer
/// stays.
void DropSteps(std::vector<Side>* sides) {
  for (size_t i = 0; i < sides->size() && sides->size() > 3;) {
    const size_t next = (i + 1) % sides->size();
    const Side& a = (*sides)[i];
    const Side& b = (*sides)[next];
    if (!a.axis || a.axis != b.axis) {
      ++i;
      continue;
    }
    sides->erase(sides->begin() + static_cast<ptrdiff_t>(a.length() < b.length() ? i : next));
    i = 0;
  }
}

bool IsRectangle(const std::vector<Side>& sides) {
  return sides.size() == 4 && std::all_of(sides.begin(), sides.end(),
                                          [](const Side& side) { return side.axis.has_value(); });
}

Vec2 Rounded(const Vec2& p, double step) {
  return {NearestMultiple(p.x, step), NearestMultiple(p.y, step)};
}

double ShortestSide(const Ring& ring) {
  double shortest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < ring.size(); ++i) {
    shortest = std::min(shortest, glm::distance(ring[i], ring[(i + 1) % ring.size()]));
  }
  return shortest;
}

/// A square where its sides are nearly equal; corners opposite in ring[0] and ring[2].
void EqualiseRectangle(const LotParameters& parameters, Ring* ring) {
  const Vec2 size = glm::abs((*ring)[2] - (*ring)[0]);
  const double longer = std::max(size.x, size.y), mean = (size.x + size.y) / 2;
  if (std::abs(size.x - size.y) > parameters.equal_share * longer) return;
  const Vec2 middle = ((*ring)[0] + (*ring)[2]) * 0.5;
  for (Vec2& p : *ring) p = middle + (p - middle) * Vec2(mean / size.x, mean / size.y);
}

/// An equal-sided triangle on its first side, or one with two equal sides on its base.
void EqualiseTriangle(const LotParameters& parameters, Ring* ring) {
  for (int k = 0; k < 3; ++k) {
    Vec2& apex = (*ring)[static_cast<size_t>(k)];
    const Vec2 a = (*ring)[static_cast<size_t>(k + 1) % 3],
               b = (*ring)[static_cast<size_t>(k + 2) % 3];
    const double left = glm::distance(apex, a), right = glm::distance(apex, b);
    if (std::abs(left - right) > parameters.equal_share * std::max(left, right)) continue;
    const Vec2 base = b - a, middle = (a + b) * 0.5;
    const double length = glm::length(base), side = (left + right) / 2;
    const Vec2 up = Vec2(-base.y, base.x) / length;
    double height = glm::dot(apex - middle, up);
    if (std::abs(side - length) <= parameters.equal_share * std::max(side, length)) {
      height = std::copysign(std::sqrt(0.75) * length, height);
    }
    const Vec2 equal = middle + up * height;
    if (glm::distance(equal, apex) > parameters.equal_share * side) continue;
    apex = equal;
    return;
  }
}

/// Corners rounded in the frame, so that sides along it keep their direction.
void RoundCorners(double step, Ring* ring) {
  for (Vec2& p : *ring) p = Rounded(p, step);
}

/// The ends of a closed curve drawn to the middle between them, and what is near them with them.
std::vector<Vec2> Meeting(std::vector<Vec2> points) {
  constexpr double kShare = 0.12;  // of the points on either side
  const auto reach = static_cast<size_t>(kShare * static_cast<double>(points.size())) + 1;
  const Vec2 half = (points.back() - points.front()) * 0.5;
  for (size_t i = 0; i < reach && i < points.size(); ++i) {
    const double weight = 1 - static_cast<double>(i) / static_cast<double>(reach);
    points[i] += half * weight;
    points[points.size() - 1 - i] -= half * weight;
  }
  points.pop_back();
  return points;
}

/// Evenly spaced points with the hand's tremor averaged out; ends of open curves stay.
std::vector<Vec2> Smooth(std::vector<Vec2> points, bool closed) {
  constexpr int kRounds = 3;
  const size_t n = points.size();
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Vec2> next = points;
    for (size_t i = closed ? 0 : 1; i + (closed ? 0 : 1) < n; ++i) {
      next[i] = 0.25 * points[(i + n - 1) % n] + 0.5 * points[i] + 0.25 * points[(i + 1) % n];
    }
    points = std::move(next);
  }
  return points;
}

double TurnOf(const std::vector<Vec2>& points) {
  double turn = 0;
  for (size_t i = 2; i < points.size(); ++i) {
    const Vec2 u = points[i - 1] - points[i - 2], v = points[i] - points[i - 1];
    turn += std::abs(std::atan2(Cross(u, v), glm::dot(u, v)));
  }
  return turn;
}

/// The corners that a curve has between its ends, a turn of facet_deg apart.
void AddCurve(const OutlinePiece& piece, const LotParameters& parameters, Ring* ring) {
  constexpr size_t kFine = 64;
  const std::vector<Vec2> smooth = Smooth(EvenPoints(piece.points, kFine, false), false);
  const double facets = TurnOf(smooth) / Angle::Degrees(parameters.facet_deg).radians();
  const auto count =
      static_cast<size_t>(std::clamp(std::ceil(facets), 2.0, parameters.most_corners / 4.0));
  const std::vector<Vec2> corners = EvenPoints(smooth, count + 1, false);
  ring->insert(ring->end(), corners.begin() + 1, corners.end() - 1);
}

struct Circle {
  Vec2 centre{0, 0};
  double radius = 0;
  double scatter = 0;  ///< of the radius, relative
};

Circle CircleThrough(const std::vector<Vec2>& points) {
  Vec2 low = points[0], high = points[0];
  for (const Vec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Circle circle;
  for (const Vec2& p : points) circle.centre += p;
  circle.centre /= static_cast<double>(points.size());
  double sum = 0, squares = 0;
  for (const Vec2& p : points) {
    const double r = glm::distance(p, circle.centre);
    sum += r;
    squares += r * r;
  }
  const auto n = static_cast<double>(points.size());
  circle.radius = sum / n;
  circle.scatter = std::sqrt(std::max(0.0, squares / n - circle.radius * circle.radius)) /
                   std::max(circle.radius, 1e-12);
  return circle;
}

Ring RegularRing(const Circle& circle, const LotParameters& parameters) {
  const double step = ReadableStep(parameters.rounding_share * circle.radius);
  const double radius = NearestMultiple(circle.radius, step);
  const Vec2 centre = Rounded(circle.centre, step);
  Ring ring;
  for (int i = 0; i < parameters.circle_corners; ++i) {
    const double angle = 2 * kPi * i / parameters.circle_corners;
    ring.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Evenly spaced points around a closed curve.
Ring EvenRing(const std::vector<Vec2>& points) {
  constexpr size_t kFine = 128;
  return EvenPoints(Meeting(EvenPoints(points, kFine, false)), kFine, true);
}

/// An outline of curves alone.
Ring CurvedRing(const std::vector<Vec2>& points, const LotParameters& parameters) {
  const std::vector<Vec2> even = EvenRing(points);
  if (const Circle circle = CircleThrough(even); circle.scatter <= parameters.circle_share) {
    return RegularRing(circle, parameters);
  }
  const std::vector<Vec2> smooth = Smooth(even, true);
  const double facets = TurnOf(smooth) / Angle::Degrees(parameters.facet_deg).radians();
  const auto count = static_cast<size_t>(
      std::clamp(std::ceil(facets), 8.0, static_cast<double>(parameters.most_corners)));
  return EvenPoints(smooth, count, true);
}

Ring ToTheMillimetre(Ring ring) {
  constexpr double kPerMetre = 1000;
  for (Vec2& p : ring) p = glm::round(p * kPerMetre) / kPerMetre + Vec2(0.0);  // no minus zero
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

/// Straight sides alone.
Ring StraightRing(const std::vector<Segment2>& lines, const LotParameters& parameters) {
  const double square = SquareAngle(lines.size(), parameters);
  const Frame frame(ReadableAngle(MainAngle(lines, square), parameters));
  std::vector<Side> sides;
  for (const Segment2& line : lines) {
    sides.push_back(SideOf({frame.To(line.a), frame.To(line.b)}, square));
  }
  DropSteps(&sides);
  Ring ring;
  for (size_t i = 0; i < sides.size(); ++i) {
    ring.push_back(CornerOf(sides[i], sides[(i + 1) % sides.size()]));
  }
  const double step = ReadableStep(parameters.rounding_share * ShortestSide(ring));
  if (IsRectangle(sides)) EqualiseRectangle(parameters, &ring);
  if (ring.size() == 3) EqualiseTriangle(parameters, &ring);
  RoundCorners(step, &ring);
  for (Vec2& p : ring) p = frame.From(p);
  return ring;
}

/// Straight sides and curves: sides follow the main directions, curves go from side to side.
Ring MixedRing(const std::vector<OutlinePiece>& pieces, const std::vector<Segment2>& lines,
               const LotParameters& parameters) {
  const double square = SquareAngle(lines.size(), parameters);
  const Frame frame(ReadableAngle(MainAngle(lines, square), parameters));
  std::vector<std::optional<Side>> sides;
  for (const OutlinePiece& piece : pieces) {
    if (!piece.straight) {
      sides.emplace_back();
      continue;
    }
    const Segment2 line = LineOf(piece);
    sides.emplace_back(SideOf({frame.To(line.a), frame.To(line.b)}, square));
  }
  Ring ring;
  for (size_t i = 0; i < pieces.size(); ++i) {
    const size_t next = (i + 1) % pieces.size();
    if (!sides[i]) AddCurve(pieces[i], parameters, &ring);
    if (sides[i] && sides[next]) {
      ring.push_back(frame.From(CornerOf(*sides[i], *sides[next])));
    } else if (sides[i]) {
      ring.push_back(frame.From(sides[i]->line.b));
    } else if (sides[next]) {
      ring.push_back(frame.From(sides[next]->line.a));
    } else {
      ring.push_back((pieces[i].points.back() + pieces[next].points.front()) * 0.5);
    }
  }
  return ring;
}

}  // namespace

std::vector<Vec2> SquaredOutline(const std::vector<OutlinePiece>& pieces,
                                 const LotParameters& parameters) {
  std::vector<Segment2> lines;
  std::vector<Vec2> all;
  for (const OutlinePiece& piece : pieces) {
    if (piece.straight) lines.push_back(LineOf(piece));
    all.insert(all.end(), piece.points.begin(), piece.points.end());
  }
  if (lines.size() == pieces.size() && lines.size() >= 3) {
    return ToTheMillimetre(StraightRing(lines, parameters));
  }
  constexpr size_t kFine = 128;
  const bool round = CircleThrough(EvenPoints(all, kFine, true)).scatter <= parameters.circle_share;
  if (lines.empty() || round) return ToTheMillimetre(CurvedRing(all, parameters));
  return ToTheMillimetre(MixedRing(pieces, lines, parameters));
}

}  // namespace parti::app
