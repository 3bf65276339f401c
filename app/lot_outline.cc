#include "app/lot_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sketch/segmentation.h"

namespace parti::app {
namespace {

/// A stroke with the ground under its samples.
struct GroundStroke {
  Stroke stroke;             // px
  std::vector<Vec2> ground;  // x, z; m
};

/// A piece with its ends on the screen, where hands judge whether lines meet.
struct DrawnPiece {
  OutlinePiece piece;
  Vec2 from_px{0, 0}, to_px{0, 0};
};
using Chain = std::vector<DrawnPiece>;

Result<GroundStroke> OnGround(const DrawnStroke& drawn, const LotParameters& parameters) {
  const View view(drawn.camera);
  const double least_slope = std::sin(Angle::Degrees(parameters.least_angle_deg).radians());
  GroundStroke result{drawn.stroke, {}};
  for (const StrokeSample& sample : drawn.stroke) {
    if (!IsFinite(sample.position) || !std::isfinite(sample.t_s)) {
      return Fail(ErrorCode::kBadNumber, "a sample of the stroke is not finite");
    }
    const Ray ray = view.RayThrough(sample.position);
    const auto point = Intersect(ray, Plane{});
    if (!point || std::abs(ray.direction.y) < least_slope) {
      return Fail(ErrorCode::kGrazingView, "the ground is not seen where this was drawn",
                  "draw below the horizon, or look from higher up");
    }
    result.ground.emplace_back(point->x, point->z);
  }
  return result;
}

/// Cuts off what the ends overlap: where the first and last parts of the path come nearest to each
/// other, the less cut off the better.
void TrimOverlap(double share, GroundStroke* s) {
  const size_t n = s->stroke.size();
  std::vector<double> along(n, 0);
  for (size_t i = 1; i < n; ++i) {
    along[i] = along[i - 1] + glm::distance(s->stroke[i - 1].position, s->stroke[i].position);
  }
  const double reach = share * along.back();
  size_t from = 0, to = n - 1;
  double best = std::numeric_limits<double>::infinity();
  // Pens that report often don't need every pair looked at.
  const size_t stride = 1 + n / 512;
  for (size_t i = 0; i < n && along[i] <= reach; i += stride) {
    for (size_t j = n - 1; j > i + stride && along.back() - along[j] <= reach; j -= stride) {
      const double cut = along[i] + along.back() - along[j];
      const double apart = glm::distance(s->stroke[i].position, s->stroke[j].position);
      if (cut > reach || apart + 0.25 * cut >= best) continue;
      best = apart + 0.25 * cut;
      from = i;
      to = j;
    }
  }
  const auto cut = [&](auto* values) {
    values->erase(values->begin() + static_cast<ptrdiff_t>(to) + 1, values->end());
    values->erase(values->begin(), values->begin() + static_cast<ptrdiff_t>(from));
  };
  cut(&s->stroke);
  cut(&s->ground);
}

double LengthOf(const DrawnPiece& piece) { return glm::distance(piece.from_px, piece.to_px); }

/// Drops pieces at either end that are short against the longest.
void DropHooks(double share, Chain* chain) {
  double longest = 0;
  for (const DrawnPiece& piece : *chain) longest = std::max(longest, LengthOf(piece));
  const auto is_hook = [&](const DrawnPiece& p) { return LengthOf(p) < share * longest; };
  if (chain->size() > 1 && is_hook(chain->back())) chain->pop_back();
  if (chain->size() > 1 && is_hook(chain->front())) chain->erase(chain->begin());
}

Result<Chain> PiecesOf(const GroundStroke& s, const LotParameters& parameters) {
  const auto segmentation = sketch::SegmentStroke(s.stroke);
  if (!segmentation) return Fail(segmentation);
  Chain chain;
  for (const sketch::StrokeSegment& segment : segmentation->segments) {
    const auto from = static_cast<size_t>(segment.from), to = static_cast<size_t>(segment.to);
    DrawnPiece piece;
    piece.piece.straight = segment.kind == sketch::SegmentKind::kLine;
    piece.piece.points.assign(s.ground.begin() + segment.from, s.ground.begin() + segment.to + 1);
    piece.from_px = s.stroke[from].position;
    piece.to_px = s.stroke[to].position;
    chain.push_back(std::move(piece));
  }
  DropHooks(parameters.hook, &chain);
  return chain;
}

void Reverse(Chain* chain) {
  std::reverse(chain->begin(), chain->end());
  for (DrawnPiece& piece : *chain) {
    std::reverse(piece.piece.points.begin(), piece.piece.points.end());
    std::swap(piece.from_px, piece.to_px);
  }
}

/// Appends to the first chain whichever begins or ends nearest to its end, until all are used.
/// Returns the widest gap, that of closing included.
double Link(std::vector<Chain>* chains, Chain* linked) {
  *linked = std::move(chains->front());
  chains->erase(chains->begin());
  double widest = 0;
  while (!chains->empty()) {
    const Vec2 end = linked->back().to_px;
    size_t next = 0;
    bool turned = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < chains->size(); ++i) {
      const double forward = glm::distance(end, (*chains)[i].front().from_px);
      const double backward = glm::distance(end, (*chains)[i].back().to_px);
      if (std::min(forward, backward) >= nearest) continue;
      nearest = std::min(forward, backward);
      next = i;
      turned = backward < forward;
    }
    widest = std::max(widest, nearest);
    Chain& chain = (*chains)[next];
    if (turned) Reverse(&chain);
    linked->insert(linked->end(), chain.begin(), chain.end());
    chains->erase(chains->begin() + static_cast<ptrdiff_t>(next));
  }
  return std::max(widest, glm::distance(linked->back().to_px, linked->front().from_px));
}

double TurnBetween(const OutlinePiece& a, const OutlinePiece& b) {
  const Segment2 l = LineOf(a), m = LineOf(b);
  const Vec2 u = l.b - l.a, v = m.b - m.a;
  return std::abs(std::atan2(Cross(u, v), glm::dot(u, v)));
}

/// Makes straight pieces that go on in one direction one, around the outline.
void JoinStraight(double joint_deg, std::vector<OutlinePiece>* pieces) {
  const double joint = Angle::Degrees(joint_deg).radians();
  for (size_t i = 0; i < pieces->size() && pieces->size() > 2;) {
    OutlinePiece& piece = (*pieces)[i];
    const size_t next = (i + 1) % pieces->size();
    OutlinePiece& other = (*pieces)[next];
    if (!piece.straight || !other.straight || TurnBetween(piece, other) > joint) {
      ++i;
      continue;
    }
    piece.points.insert(piece.points.end(), other.points.begin(), other.points.end());
    pieces->erase(pieces->begin() + static_cast<ptrdiff_t>(next));
    i = 0;
  }
}

bool Crossing(const Segment2& s, const Segment2& t) {
  const auto side = [](const Segment2& line, const Vec2& p) {
    return Cross(line.b - line.a, p - line.a) > 0;
  };
  return side(s, t.a) != side(s, t.b) && side(t, s.a) != side(t, s.b);
}

/// Whether the line drawn crosses itself in more than the small loops of overshot corners.
bool CrossesItself(const std::vector<OutlinePiece>& pieces, double small_loop) {
  constexpr size_t kFine = 96;
  std::vector<Vec2> all;
  for (const OutlinePiece& piece : pieces) {
    all.insert(all.end(), piece.points.begin(), piece.points.end());
  }
  const std::vector<Vec2> path = EvenPoints(all, kFine, true);
  const auto edge = [&](size_t i) { return Segment2{path[i], path[(i + 1) % kFine]}; };
  for (size_t i = 0; i < kFine; ++i) {
    for (size_t j = i + 2; j < kFine; ++j) {
      const size_t loop = std::min(j - i, kFine - (j - i));
      if (static_cast<double>(loop) > small_loop * kFine && Crossing(edge(i), edge(j))) return true;
    }
  }
  return false;
}

double DiagonalOf(std::span<const std::shared_ptr<const DrawnStroke>> strokes) {
  Stroke all;
  for (const auto& drawn : strokes) {
    all.insert(all.end(), drawn->stroke.begin(), drawn->stroke.end());
  }
  return Diagonal(all);
}

}  // namespace

Segment2 LineOf(const OutlinePiece& piece) {
  const std::vector<Vec2>& points = piece.points;
  constexpr size_t kShareOfEnds = 10;
  const size_t skip = points.size() < 2 * kShareOfEnds ? 0 : points.size() / kShareOfEnds;
  const std::span<const Vec2> inner(points.data() + skip, points.size() - 2 * skip);
  Vec2 mean(0);
  for (const Vec2& p : inner) mean += p;
  mean /= static_cast<double>(inner.size());
  double xx = 0, xy = 0, yy = 0;
  for (const Vec2& p : inner) {
    const Vec2 d = p - mean;
    xx += d.x * d.x;
    xy += d.x * d.y;
    yy += d.y * d.y;
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  const Vec2 along(std::cos(angle), std::sin(angle));
  return {mean + along * glm::dot(points.front() - mean, along),
          mean + along * glm::dot(points.back() - mean, along)};
}

std::vector<Vec2> EvenPoints(const std::vector<Vec2>& points, size_t count, bool closed) {
  std::vector<double> along = {0};
  std::vector<Vec2> path = points;
  if (closed) path.push_back(path.front());
  for (size_t i = 1; i < path.size(); ++i) {
    along.push_back(along.back() + glm::distance(path[i - 1], path[i]));
  }
  std::vector<Vec2> even;
  const size_t steps = closed ? count : count - 1;
  size_t at = 1;
  for (size_t k = 0; k < count; ++k) {
    const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(steps);
    while (at + 1 < path.size() && along[at] < wanted) ++at;
    const double length = along[at] - along[at - 1];
    const double u = length > 0 ? (wanted - along[at - 1]) / length : 0;
    even.push_back(path[at - 1] + (path[at] - path[at - 1]) * std::clamp(u, 0.0, 1.0));
  }
  return even;
}

Result<std::vector<OutlinePiece>> ClosedOutline(
    std::span<const std::shared_ptr<const DrawnStroke>> strokes, const LotParameters& parameters) {
  if (strokes.empty()) return Fail(ErrorCode::kTooShort, "nothing is drawn", "draw an outline");
  std::vector<Chain> chains;
  for (const auto& drawn : strokes) {
    auto stroke = OnGround(*drawn, parameters);
    if (!stroke) return Fail(stroke);
    if (strokes.size() == 1 && stroke->stroke.size() > 3) {
      TrimOverlap(parameters.overlap, &*stroke);
    }
    auto chain = PiecesOf(*stroke, parameters);
    if (!chain) return Fail(chain);
    chains.push_back(std::move(*chain));
  }
  Chain linked;
  const double gap = Link(&chains, &linked);
  const double share = strokes.size() == 1 ? parameters.closing_gap : parameters.meeting_gap;
  if (gap > share * DiagonalOf(strokes)) {
    return Fail(ErrorCode::kNoFit, "the outline of the lot is not closed yet",
                "draw on to where it began, or begin anew: clear");
  }
  std::vector<OutlinePiece> pieces;
  for (DrawnPiece& piece : linked) pieces.push_back(std::move(piece.piece));
  if (CrossesItself(pieces, parameters.small_loop)) {
    return Fail(ErrorCode::kSelfIntersecting, "this outline crosses itself",
                "draw it around the lot once");
  }
  JoinStraight(parameters.joint_deg, &pieces);
  return pieces;
}

}  // namespace parti::app
