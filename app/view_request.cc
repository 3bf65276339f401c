#include "app/view_request.h"

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

}  // namespace

Camera ViewFor(ViewRequest request, const Camera& camera, const render::Bounds& model) {
  const Vec2 middle(camera.width_px / 2, camera.height_px / 2);
  if (request == ViewRequest::kNearer) return ZoomTowards(camera, middle, kNearerFactor);
  if (request == ViewRequest::kFarther) return ZoomTowards(camera, middle, 1 / kNearerFactor);
  return PresetView(PresetOf(request), model, camera.width_px, camera.height_px).value_or(camera);
}

}  // namespace parti::app
