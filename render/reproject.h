// Shows a picture through a camera that has moved since it was drawn, as if all that it shows lay
// on one plane: what is seen until the next picture is there. Not a way to draw scenes.
#pragma once

#include "base/camera.h"

namespace parti::render {

/// Pixels of `from`'s picture (homogeneous, y down) from pixels of `to`'s, by way of the plane
/// through `to`'s target that faces `to`. Both cameras must be valid.
/// Properties: (1) a point of that plane which both see is shown where `to` sees it; (2) the
/// identity for equal cameras; (3) the third coordinate is positive only where `from` looks.
glm::dmat3 PictureFromMoved(const Camera& from, const Camera& to);

}  // namespace parti::render
