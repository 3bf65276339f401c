// EGL without any surface: pictures where there is no OSMesa, with or without a GPU.
// Windows get EGL contexts of their own, with surfaces.
#pragma once

#include <memory>

#include "render/gl_context.h"

namespace parti::render {

/// GLES 3.0 on EGL_MESA_platform_surfaceless.
/// errors  kGraphics  EGL has no such platform, display or context.
Result<std::unique_ptr<GlContext>> CreateEglSurfacelessContext();

}  // namespace parti::render
