#include "app/placing/layer_drag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/placing/layer_arranging.h"

namespace parti::app {
namespace {

using grammar::InteractiveLayer;

LayerDragParams At(LayerDragParams params, double scale) {
  params.reach_px *= scale;
  params.still_px *= scale;
  params.snap_px *= scale;
  return params;
}

/// Within the face, or where it took hold beside it.
double Within(double at, double from, double size) {
  return std::clamp(at, std::min(0.0, from), std::max(size, from));
}

}  // namespace

LayerDrag::LayerDrag(std::shared_ptr<const PlacedLayers> placed, const LayerGrip& grip)
    : placed_(std::move(placed)), grip_(grip), others_(LayersBeside(*placed_, grip.layer)) {
  others_.push_back(held().rules.layer);
  now_.layer = held().rules.layer;
}

std::optional<LayerDrag> LayerDrag::Begin(std::shared_ptr<const PlacedLayers> placed,
                                          const View& view, const Vec2& px, double scale,
                                          const LayerDragParams& params) {
  const LayerDragParams scaled = At(params, scale);
  const auto grip = GripAt(*placed, view, px, scaled.reach_px);
  if (!grip) return std::nullopt;
  const auto from = OnFrame(placed->layers[grip->layer].frame, view, px);
  if (!from) return std::nullopt;
  LayerDrag drag(std::move(placed), *grip);
  drag.params_ = scaled;
  drag.from_px_ = px;
  drag.from_ = *from;
  return drag;
}

void LayerDrag::MoveTo(const View& view, const Vec2& px) {
  const grammar::Scope& frame = held().frame;
  const auto at = OnFrame(frame, view, px);
  if (!at) return;
  moved_ |= glm::distance(px, from_px_) > params_.still_px;
  if (!moved_) return;
  const Vec2 there(Within(at->x, from_.x, frame.size.x), Within(at->y, from_.y, frame.size.y));
  const Vec2 by = glm::round((there - from_) / params_.step_m) * params_.step_m;
  const InteractiveLayer pulled = grammar::Pulled(held().rules.layer, grip_.handle, by.y, by.x);
  const double px_per_m = view.PixelsPerMetre(frame.ToWorld({there, 0}));
  const double reach_m = px_per_m > 0 ? params_.snap_px / px_per_m : 0;
  been_away_ |= glm::distance(px, from_px_) > params_.snap_px;
  const std::span all(others_);  // the last is where it was: a small move is not to snap back to it
  const auto others = been_away_ ? all : all.first(all.size() - 1);
  now_ = grammar::Snapped(pulled, grip_.handle, others, reach_m);
}

InteractiveLayer LayerDrag::LayerNow(size_t layer) const {
  return grammar::Following(placed_->layers[layer].rules, held().rules, now_.layer);
}

std::string LayerDrag::Figures() const {
  const InteractiveLayer& now = now_.layer;
  // Two digits always: what follows the pen keeps its width.
  return grip_.handle.whole()
             ? fmt::format("{:.2f} m from the left, {:.2f} m up", now.left, now.bottom)
             : fmt::format("{:.2f} m wide, {:.2f} m high", now.width, now.height);
}

std::optional<PlaceElement> LayerDrag::Outcome() const {
  return ChangeBetween(held().rules.layer, now_.layer);
}

}  // namespace parti::app
