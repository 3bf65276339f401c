// The views that show a whole model: the best one when nobody has chosen, and those with names that
// every such program has. Views that were kept and named by the user are the document's.
#pragma once

#include <array>
#include <optional>
#include <string_view>

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

/// What PresetView knows. The front is seen from the south, the left side from the west; the top
/// from nearly above, north up; three-quarter is AutoView.
inline constexpr std::array<std::string_view, 6> kViewPresets{"front", "back", "left",
                                                              "right", "top",  "three-quarter"};

/// The bounds from a side, in the same perspective and with properties (1) and (2) of AutoView.
/// Nothing for a name that is not a preset's.
std::optional<Camera> PresetView(std::string_view name, const render::Bounds& bounds,
                                 double width_px, double height_px);

}  // namespace parti::app
