// From pixels to shapes: what a picture's ids mean, and where a ray meets a shape.
// Which id lies at a pixel is the painter's knowledge (render/scene_painter.h).
#pragma once

#include <cstdint>
#include <optional>

#include "app/session_state.h"
#include "base/camera.h"

namespace parti::app {

/// The shape of an id in a picture of the model (AddModels with first_id 1); nothing for 0 and for
/// ids that the model does not have. O(lots).
std::optional<ShapeRef> RefOfId(const Model& model, uint32_t id);

/// The id that a shape has in such a picture.
uint32_t IdOfRef(const Model& model, const ShapeRef& ref);

/// The plane of the face of a shape that is nearest to the eye at a pixel, its normal towards the
/// eye; nothing where the shape is not there. O(triangles of the shape).
std::optional<Plane> PlaneAt(const Model& model, const ShapeRef& ref, const Camera& camera,
                             const Vec2& px);

}  // namespace parti::app
