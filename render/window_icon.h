// The picture that desktops show for Parti's window: a house in ink on paper.
// Made of arithmetic, so that no file has to be found when the program starts.
#pragma once

#include "render/image.h"

namespace parti::render {

/// side >= 1 px; drawn for that size, transparent around.
Image WindowIcon(int side);

}  // namespace parti::render
