#include "app/view_request.h"

#include <algorithm>
#include <string_view>

#include "app/auto_view.h"
#include "app/camera_moves.h"

namespace parti::app {
namespace {

std::string_view PresetOf(ViewRequest request) {
  switch (request) {
    case ViewRequest::kSouth:
      return "front";
    case ViewRequest::kNorth:
      return "back";
    case ViewRequest::kWest:
      return "left";
    case ViewRequest::kEast:
      return "right";
    case ViewRequest::kAbove:
      return "top";
    default:
      return "three-quarter";
  }
}

/// With room to draw walls up from a lot.
render::Bounds WithHeadroom(render::Bounds bounds) {
  if (bounds.empty()) return bounds;
  const Vec3 size = bounds.high - bounds.low;
  const double least = kHeadroom * std::max(size.x, size.z);
  bounds.high.y = std::max(bounds.high.y, bounds.low.y + least);
  return bounds;
}

}  // namespace

Camera ViewFor(ViewRequest request, const Camera& camera, const render::Bounds& model) {
  const Vec2 middle(camera.width_px / 2, camera.height_px / 2);
  if (request == ViewRequest::kNearer) return ZoomTowards(camera, middle, kNearerFactor);
  if (request == ViewRequest::kFarther) return ZoomTowards(camera, middle, 1 / kNearerFactor);
  return PresetView(PresetOf(request), WithHeadroom(model), camera.width_px, camera.height_px)
      .value_or(camera);
}

}  // namespace parti::app
