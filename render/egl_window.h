// An EGL context that draws into something that is seen: an X11 window, the buffers of a screen.
// Not responsible for making the window or for showing a screen's buffer (x11_window.h,
// kms_screen.h), nor for what is drawn.
#pragma once

#include <EGL/egl.h>

#include <memory>
#include <span>
#include <string>

#include "render/gl_context.h"
#include "render/pixel_rect.h"

namespace parti::render {

/// What EGL is told of the system that shows.
struct EglPlatform {
  EGLenum kind = 0;              ///< EGL_PLATFORM_X11_EXT, EGL_PLATFORM_GBM_KHR
  std::shared_ptr<void> native;  ///< Display*, gbm_device*; kept as long as EGL uses it
  EGLint visual = 0;             ///< the EGL_NATIVE_VISUAL_ID that its windows have
  std::string what;              ///< for messages: "X11", "the screen"
};

/// GLES 3.0. Bytes go to the screen as they are, so what is drawn looks as off screen.
/// The platform outlives the window and all contexts that share with it, whichever goes first.
class EglWindow : public GlContext {
 public:
  /// errors  kGraphics  EGL has no such platform, configuration or context; names the remedy.
  static Result<std::unique_ptr<EglWindow>> Create(const EglPlatform& platform);

  /// Draws into `native` (Window*, gbm_surface*) from now on, or nowhere (nullptr). The old native
  /// window may be destroyed afterwards. errors  kGraphics.
  virtual Result<void> SetWindow(void* native) = 0;
  /// How many frames ago what framebuffer 0 holds was shown; 0 where that is not known.
  virtual int BufferAge() const = 0;
  /// Hands the frame to the system. `height_px` is the window's, for EGL counts rows from the
  /// bottom. errors  kGraphics.
  virtual Result<void> Swap(std::span<const PixelRect> damage, int height_px) = 0;
  /// Who draws: "llvmpipe (LLVM 15.0.6, 256 bits)". Only while current.
  virtual std::string Renderer() const = 0;
};

}  // namespace parti::render
