#include "app/tablet_mapping.h"

#include <algorithm>
#include <cmath>

namespace parti::app {

namespace {

/// By how much two surfaces differ in the side that differs more, as a ratio of at least 1.
double DifferenceOf(const Vec2& a, const Vec2& b) {
  const auto ratio = [](double x, double y) {
    return x > 0 && y > 0 ? std::max(x / y, y / x) : HUGE_VAL;
  };
  return std::max(ratio(a.x, b.x), ratio(a.y, b.y));
}

/// The part of the view that a screen shows, if that is known.
std::optional<ViewRect> Shown(const DeviceFacts& device, const Vec2& view_px,
                              const MappingOptions& options) {
  if (!device.has_display) return std::nullopt;
  if (options.own_output) return options.own_output;
  const Vec2 size = device.size_mm.value_or(view_px);  // of unknown size: of the view's shape
  const double ratio = (view_px.x * size.y) / (view_px.y * size.x);
  if (ratio > TabletMapping::kSameShape || ratio * TabletMapping::kSameShape < 1) {
    return std::nullopt;
  }
  return ViewRect{{0, 0}, view_px};
}

}  // namespace

std::optional<ViewRect> OwnOutput(const DeviceFacts& device, std::span<const OutputPlace> outputs) {
  if (!device.has_display || outputs.empty()) return std::nullopt;
  const bool unsaid = !device.size_mm || !outputs[0].size_mm;
  if (outputs.size() == 1 && unsaid) return outputs[0].in_view;
  if (!device.size_mm) return std::nullopt;
  const OutputPlace* own = nullptr;
  double own_part = 1 + kSamePart;
  for (const OutputPlace& output : outputs) {
    const double part = output.size_mm ? DifferenceOf(*output.size_mm, *device.size_mm) : HUGE_VAL;
    const bool as_near = own && part == own_part && output.in_view && !own->in_view;
    if (part >= own_part && !as_near) continue;
    own = &output;
    own_part = part;
  }
  return own ? own->in_view : std::nullopt;
}

TabletMapping::TabletMapping(const DeviceFacts& device, const Camera& camera,
                             const MappingOptions& options)
    : px_per_mm_(device.view_px_per_mm.value_or(0)), origin_px_(0, 0) {
  if (device.view_px_per_mm) return;
  Vec2 size = device.size_mm.value_or(kUsualSize_mm);
  if (!(size.x > 0 && size.y > 0)) size = kUsualSize_mm;
  const Vec2 view(camera.width_px, camera.height_px);
  if (const auto shown = Shown(device, view, options)) {
    px_per_mm_ = shown->size_px / size;
    origin_px_ = shown->origin_px;
    return;
  }
  px_per_mm_ = Vec2(std::max(view.x / size.x, view.y / size.y));
  if (options.left_handed && !device.has_display) px_per_mm_ = -px_per_mm_;
  origin_px_ = (view - size * px_per_mm_) * 0.5;
}

double TabletMapping::px_per_mm() const {
  return (std::abs(px_per_mm_.x) + std::abs(px_per_mm_.y)) * 0.5;
}

Vec2 TabletMapping::ToView_px(const Vec2& tablet_mm) const {
  return origin_px_ + tablet_mm * px_per_mm_;
}

Vec2 TabletMapping::ToTablet_mm(const Vec2& view_px) const {
  return (view_px - origin_px_) / px_per_mm_;
}

Stroke TabletMapping::ToView(const input::PenStroke& stroke) const {
  Stroke mapped;
  mapped.reserve(stroke.samples.size());
  for (const input::PenSample& s : stroke.samples) {
    mapped.push_back({ToView_px(s.position_mm), s.t_s, s.pressure});
  }
  return mapped;
}

}  // namespace parti::app
