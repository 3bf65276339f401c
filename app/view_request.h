// The standard views of panels and keys, as cameras.
// Which there are is panels' (panel_output.h); how cameras are found is auto_view's and
// camera_moves'.
#pragma once

#include "app/panels/panel_output.h"
#include "base/camera.h"
#include "render/bounds.h"

namespace parti::app {

/// From a valid camera to the one asked for, of the same size; valid again. `model` may be empty.
Camera ViewFor(ViewRequest request, const Camera& camera, const render::Bounds& model);

/// Models are seen as if at least so high, as a part of their longer side: walls want room.
inline constexpr double kHeadroom = 0.5;

/// How much nearer kNearer goes.
inline constexpr double kNearerFactor = 1.25;

}  // namespace parti::app
