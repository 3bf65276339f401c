// What a framebuffer holds, as an Image: for screenshots and tests.
// Drawing into it is the renderer's and the canvas's.
#pragma once

#include <glm/vec2.hpp>

#include "render/gl.h"
#include "render/image.h"

namespace parti::render {

/// The pixels of `framebuffer` (0: the window) from its lower left corner; alpha is 255, since
/// windows have none to speak of. Waits for what is being drawn. Leaves the framebuffer bound.
/// errors  kGraphics  as CheckGl.
Result<Image> ReadImage(const Gl& gl, GLuint framebuffer, const glm::ivec2& size_px);

}  // namespace parti::render
