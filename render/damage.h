// Which pixels of a canvas have changed, as a few rectangles; and over the last frames, so that a
// buffer that is some frames old can be repaired. Values only; drawing is Canvas's.
#pragma once

#include <cstdint>
#include <deque>
#include <glm/vec2.hpp>
#include <vector>

#include "render/pixel_rect.h"

namespace parti::render {

/// Without pixels.
bool IsEmpty(const PixelRect& rect);
/// Pixels of both; empty when they don't meet.
PixelRect Intersection(const PixelRect& a, const PixelRect& b);
/// The least rectangle around both; an empty one adds nothing.
PixelRect Union(const PixelRect& a, const PixelRect& b);
/// In pixels.
int64_t Area(const PixelRect& rect);

/// The pixels of a `size` picture that a shape between two corners [px] touches, `margin` px wider
/// on each side. Empty for corners that are not finite; those far outside are cut at the picture.
PixelRect PixelsAround(const glm::vec2& low, const glm::vec2& high, float margin,
                       const glm::ivec2& size);

/// At most kMostRects disjoint, non-empty rectangles within a picture. Properties: (1) every pixel
/// added and within the picture is inside one; (2) no two overlap.
class Damage {
 public:
  explicit Damage(const glm::ivec2& size) : size_(size) {}

  /// What lies outside the picture is cut off.
  void Add(const PixelRect& rect);
  void Add(const Damage& other);
  void AddAll();  ///< the whole picture
  void Clear() { rects_.clear(); }

  bool empty() const { return rects_.empty(); }
  const std::vector<PixelRect>& rects() const { return rects_; }
  /// Whether any of its pixels is inside.
  bool Touches(const PixelRect& rect) const;
  int64_t area() const;  ///< pixels
  const glm::ivec2& size() const { return size_; }

  static constexpr size_t kMostRects = 6;

 private:
  void MergeClosest();

  glm::ivec2 size_;
  std::vector<PixelRect> rects_;
};

/// The pixels that are in both; the sizes must agree.
Damage Common(const Damage& a, const Damage& b);

/// The damage of the last frames, newest first.
class DamageHistory {
 public:
  explicit DamageHistory(const glm::ivec2& size) : size_(size) {}

  /// What to draw into a buffer that shows the frame `age` frames ago (1: the last one), now that
  /// `fresh` has changed. Everything for buffers of unknown (0 or less) or too great an age.
  Damage ToRepair(const Damage& fresh, int age) const;
  /// A frame with this damage has been drawn.
  void Push(const Damage& fresh);
  /// Nothing is known of any buffer.
  void Forget() { frames_.clear(); }

  static constexpr size_t kMostFrames = 8;

 private:
  glm::ivec2 size_;
  std::deque<Damage> frames_;
};

}  // namespace parti::render
