// Many small pictures on one.
#pragma once

#include <vector>

#include "render/image.h"

namespace parti::tests {

/// Pictures of equal size in rows of `columns`, on white.
render::Image ContactSheet(const std::vector<render::Image>& pictures, int columns);

}  // namespace parti::tests
