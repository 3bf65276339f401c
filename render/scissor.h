// Rectangles of pixels as GL's scissor wants them.
// Which ones is the layers' business.
#pragma once

#include "render/gl.h"
#include "render/pixel_rect.h"

namespace parti::render {

/// Confines drawing to a rectangle of a framebuffer of this height, while GL_SCISSOR_TEST is on.
inline void SetScissor(const Gl& gl, const PixelRect& rect, int height_px) {
  gl.Scissor(rect.x, height_px - rect.y - rect.height, rect.width, rect.height);
}

}  // namespace parti::render
