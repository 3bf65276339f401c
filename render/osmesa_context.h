// Mesa's off-screen software context, which needs no display, no device and no permission.
// Looked for when the program runs, not when it is linked: newer Mesa has none.
#pragma once

#include <memory>

#include "render/gl_context.h"

namespace parti::render {

/// GL 3.3 core on libOSMesa.so.8 (or .so.6).
/// errors  kGraphics  there is no such library, or it makes no such context.
Result<std::unique_ptr<GlContext>> CreateOsMesaContext();

}  // namespace parti::render
