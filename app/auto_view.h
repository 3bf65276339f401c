// The view that shows a model at its best when nobody has chosen one.
// Views that were chosen and named are the document's.
#pragma once

#include "base/camera.h"
#include "render/bounds.h"

namespace parti::app {

/// A three-quarter view from the south and above, from the east or west of which the broader side
/// is seen more from the front; the lower the model, the more from above. The whole of the bounds
/// lies within the picture, with a margin. Empty bounds are seen as 10 m around the origin.
/// width_px and height_px in [1, 1e5].
/// Properties: (1) the camera is valid; (2) every corner of the bounds is within the picture;
/// (3) the bounds fill at least half of its width or height.
Camera AutoView(const render::Bounds& bounds, double width_px, double height_px);

}  // namespace parti::app
