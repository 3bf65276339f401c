#include "app/ink_book.h"

#include <algorithm>

#include "app/scene_from_model.h"

namespace parti::app {
namespace {

using Drawn = std::shared_ptr<const DrawnStroke>;

/// Strokes of the sketch, read or not, in the order drawn. They live as long as the sketch.
std::vector<const Drawn*> StrokesOf(const Sketch& sketch) {
  std::vector<const Drawn*> strokes;
  strokes.reserve(sketch.strokes.size() + sketch.unread.size());
  for (const Drawn& drawn : sketch.strokes) strokes.push_back(&drawn);
  for (const Drawn& drawn : sketch.unread) strokes.push_back(&drawn);
  const auto is_earlier = [](const Drawn* a, const Drawn* b) {
    return (*a)->number < (*b)->number;
  };
  if (!std::is_sorted(strokes.begin(), strokes.end(), is_earlier)) {
    std::sort(strokes.begin(), strokes.end(), is_earlier);
  }
  return strokes;
}

/// Whether they are one stroke; drawn again after undo, another may have its number.
bool IsSame(const Drawn& a, const Drawn& b) {
  return a == b || (a->number == b->number && a->stroke == b->stroke);
}

double DistanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return glm::distance(p, a + along * t);
}

bool SegmentsCross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool Touches(const Stroke& stroke, const Vec2& a, const Vec2& b, double radius_px) {
  for (size_t i = 0; i < stroke.size(); ++i) {
    const Vec2& p = stroke[i].position;
    if (DistanceToSegment(p, a, b) <= radius_px) return true;
    if (i == 0) continue;
    const Vec2& before = stroke[i - 1].position;
    if (SegmentsCross(before, p, a, b) || DistanceToSegment(a, before, p) <= radius_px) return true;
  }
  return false;
}

}  // namespace

void InkBook::Posted(uint64_t id, uint64_t request, const Stroke& stroke) {
  waiting_.push_back({request, stroke, {id, std::make_shared<const render::Ink>(InkOf(stroke))}});
}

render::InkStroke InkBook::InkOfNew(const DrawnStroke& drawn) {
  const auto posted = std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& waiting) {
    return waiting.stroke == drawn.stroke;
  });
  if (posted != waiting_.end()) return posted->ink;
  return {NewId(), std::make_shared<const render::Ink>(InkOf(drawn.stroke))};
}

std::vector<render::InkStroke> InkBook::Shown(const SessionState& state, const Camera& now,
                                              uint64_t executed) {
  const std::vector<const Drawn*> strokes = StrokesOf(state.sketch);
  std::vector<render::InkStroke> shown;
  std::vector<Read> read;
  shown.reserve(strokes.size() + waiting_.size());
  read.reserve(strokes.size());
  auto known = read_.begin();
  for (const Drawn* drawn : strokes) {
    while (known != read_.end() && known->drawn->number < (*drawn)->number) ++known;
    const bool is_known = known != read_.end() && IsSame(known->drawn, *drawn);
    read.push_back({*drawn, is_known ? std::move(known->ink) : InkOfNew(**drawn)});
    if ((*drawn)->camera == now && !hidden_.count((*drawn)->number)) {
      shown.push_back(read.back().ink);
    }
  }
  read_ = std::move(read);
  std::erase_if(waiting_, [&](const Waiting& one) { return one.request <= executed; });
  for (const Waiting& one : waiting_) shown.push_back(one.ink);
  return shown;
}

std::vector<uint32_t> InkBook::Touched(const SessionState& state, const Camera& now, const Vec2& a,
                                       const Vec2& b, double radius_px) {
  std::vector<uint32_t> numbers;
  for (const Drawn* each : StrokesOf(state.sketch)) {
    const DrawnStroke& drawn = **each;
    if (drawn.camera == now && Touches(drawn.stroke, a, b, radius_px)) {
      numbers.push_back(drawn.number);
    }
  }
  return numbers;
}

}  // namespace parti::app
