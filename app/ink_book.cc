#include "app/ink_book.h"

#include <algorithm>

#include "app/scene_from_model.h"

namespace parti::app {
namespace {

/// Strokes of the sketch, read or not, in the order drawn.
std::vector<const DrawnStroke*> StrokesOf(const Sketch& sketch) {
  std::vector<const DrawnStroke*> strokes;
  for (const auto& drawn : sketch.strokes) strokes.emplace_back(drawn.get());
  for (const auto& drawn : sketch.unread) strokes.emplace_back(drawn.get());
  std::sort(strokes.begin(), strokes.end(),
            [](const auto* a, const auto* b) { return a->number < b->number; });
  return strokes;
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
  posted_.push_back({id, request, stroke, std::make_shared<const render::Ink>(InkOf(stroke))});
}

const InkBook::Page& InkBook::PageOf(const DrawnStroke& drawn) {
  const auto known = read_.find(drawn.number);
  if (known != read_.end() && known->second.stroke == drawn.stroke) return known->second;
  const auto posted = std::find_if(posted_.begin(), posted_.end(),
                                   [&](const Page& page) { return page.stroke == drawn.stroke; });
  Page page;
  if (posted != posted_.end()) {
    page = *posted;
  } else {
    page = {NewId(), 0, drawn.stroke, std::make_shared<const render::Ink>(InkOf(drawn.stroke))};
  }
  return read_.insert_or_assign(drawn.number, std::move(page)).first->second;
}

std::vector<render::InkStroke> InkBook::Shown(const SessionState& state, const Camera& now,
                                              uint64_t executed) {
  std::vector<render::InkStroke> shown;
  std::map<uint32_t, Page> still_read;
  for (const DrawnStroke* drawn : StrokesOf(state.sketch)) {
    const Page& page = PageOf(*drawn);
    still_read.emplace(drawn->number, page);
    if (drawn->camera == now && !hidden_.count(drawn->number)) {
      shown.push_back({page.id, page.ink});
    }
  }
  read_ = std::move(still_read);
  posted_.erase(std::remove_if(posted_.begin(), posted_.end(),
                               [&](const Page& page) { return page.request <= executed; }),
                posted_.end());
  for (const Page& page : posted_) shown.push_back({page.id, page.ink});
  return shown;
}

std::vector<uint32_t> InkBook::Touched(const SessionState& state, const Camera& now, const Vec2& a,
                                       const Vec2& b, double radius_px) {
  std::vector<uint32_t> numbers;
  for (const DrawnStroke* drawn : StrokesOf(state.sketch)) {
    if (drawn->camera == now && Touches(drawn->stroke, a, b, radius_px)) {
      numbers.emplace_back(drawn->number);
    }
  }
  return numbers;
}

}  // namespace parti::app
