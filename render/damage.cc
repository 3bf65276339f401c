#include "render/damage.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace parti::render {

bool IsEmpty(const PixelRect& rect) { return rect.width <= 0 || rect.height <= 0; }

PixelRect Intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  const int right = std::min(a.x + a.width, b.x + b.width);
  const int bottom = std::min(a.y + a.height, b.y + b.height);
  if (IsEmpty(a) || IsEmpty(b) || right <= x || bottom <= y) return {};
  return {x, y, right - x, bottom - y};
}

PixelRect Union(const PixelRect& a, const PixelRect& b) {
  if (IsEmpty(a)) return b;
  if (IsEmpty(b)) return a;
  const int x = std::min(a.x, b.x), y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
          std::max(a.y + a.height, b.y + b.height) - y};
}

int64_t Area(const PixelRect& rect) { return int64_t{rect.width} * rect.height; }

PixelRect PixelsAround(const glm::vec2& low, const glm::vec2& high, float margin,
                       const glm::ivec2& size) {
  const auto cut = [](float at, int most) {
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
  };
  // NaN fails every comparison.
  if (!(low.x <= high.x && low.y <= high.y && margin >= 0)) return {};
  const int x = cut(std::floor(low.x - margin), size.x);
  const int y = cut(std::floor(low.y - margin), size.y);
  return {x, y, cut(std::ceil(high.x + margin), size.x) - x,
          cut(std::ceil(high.y + margin), size.y) - y};
}

void Damage::Add(const PixelRect& rect) {
  PixelRect added = Intersection(rect, {0, 0, size_.x, size_.y});
  if (IsEmpty(added)) return;
  // What overlaps becomes one, which may overlap others in turn.
  for (bool grown = true; grown;) {
    const auto meets = [&](const PixelRect& r) { return !IsEmpty(Intersection(r, added)); };
    const auto met = std::find_if(rects_.begin(), rects_.end(), meets);
    grown = met != rects_.end();
    if (!grown) break;
    added = Union(added, *met);
    rects_.erase(met);
  }
  rects_.push_back(added);
  if (rects_.size() > kMostRects) MergeClosest();
}

/// The pair whose union covers the fewest pixels that neither has.
void Damage::MergeClosest() {
  size_t first = 0, second = 1;
  int64_t least = std::numeric_limits<int64_t>::max();
  for (size_t i = 0; i < rects_.size(); ++i) {
    for (size_t j = i + 1; j < rects_.size(); ++j) {
      const int64_t waste = Area(Union(rects_[i], rects_[j])) - Area(rects_[i]) - Area(rects_[j]);
      if (waste >= least) continue;
      least = waste;
      first = i;
      second = j;
    }
  }
  const PixelRect merged = Union(rects_[first], rects_[second]);
  rects_.erase(rects_.begin() + static_cast<ptrdiff_t>(second));
  rects_.erase(rects_.begin() + static_cast<ptrdiff_t>(first));
  Add(merged);
}

void Damage::Add(const Damage& other) {
  for (const PixelRect& rect : other.rects_) Add(rect);
}

void Damage::AddAll() { rects_.assign(1, {0, 0, size_.x, size_.y}); }

bool Damage::Touches(const PixelRect& rect) const {
  return std::any_of(rects_.begin(), rects_.end(),
                     [&](const PixelRect& r) { return !IsEmpty(Intersection(r, rect)); });
}

int64_t Damage::area() const {
  int64_t sum = 0;
  for (const PixelRect& rect : rects_) sum += Area(rect);
  return sum;
}

Damage Common(const Damage& a, const Damage& b) {
  Damage common(a.size());
  for (const PixelRect& r : a.rects()) {
    for (const PixelRect& q : b.rects()) common.Add(Intersection(r, q));
  }
  return common;
}

Damage DamageHistory::ToRepair(const Damage& fresh, int age) const {
  Damage all(size_);
  if (age < 1 || static_cast<size_t>(age - 1) > frames_.size()) {
    all.AddAll();
    return all;
  }
  all.Add(fresh);
  for (size_t i = 0; i + 1 < static_cast<size_t>(age); ++i) all.Add(frames_[i]);
  return all;
}

void DamageHistory::Push(const Damage& fresh) {
  frames_.push_front(fresh);
  if (frames_.size() > kMostFrames) frames_.pop_back();
}

}  // namespace parti::render
