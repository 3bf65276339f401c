// Pictures of panels over the drawing that they belong to.
#pragma once

#include "app/panels/panels.h"
#include "render/image.h"

namespace parti::app::tests {

/// The session's picture, ink and all, with the panels of `output` on it; `size_px` is the view's.
/// On bare paper where `session` is null.
render::Image PictureWith(const PanelOutput& output, const SessionSnapshot* session,
                          const Vec2& size_px);

/// The part of a picture with these sheets on it, and a margin; all of it where there are none.
render::Image AroundSheets(const render::Image& image, const PanelOutput& output,
                           const std::vector<std::string>& sheets, double margin_px);

}  // namespace parti::app::tests
