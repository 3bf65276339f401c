#include "render/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>

namespace parti::render {
namespace {

tl::unexpected<Error> EglFailure(const char* what) {
  return Fail(ErrorCode::kGraphics, fmt::format("EGL {} (error {:#x})", what, eglGetError()),
              "install libegl1 and libgl1-mesa-dri, or libosmesa6");
}

class EglSurfacelessContext final : public GlContext {
 public:
  EglSurfacelessContext(EGLDisplay display, EGLConfig config, EGLContext context)
      : display_(display), config_(config), context_(context) {}
  // The display stays initialised: EGL has one per process, and others may be using it.
  ~EglSurfacelessContext() override { eglDestroyContext(display_, context_); }

  Result<void> MakeCurrent() override {
    // The current client API is a thread's setting, so it is set each time.
    if (eglBindAPI(EGL_OPENGL_ES_API) &&
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      return {};
    }
    return EglFailure("can't make its context current");
  }
  void Release() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  GlLookup Lookup() const override {
    return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
  }
  bool is_gles() const override { return true; }
  std::string_view name() const override { return "EGL surfaceless"; }
  Result<std::unique_ptr<GlContext>> CreateShared() override;

 private:
  EGLDisplay display_;
  EGLConfig config_;
  EGLContext context_;
};

/// `share`: the context with which it shares, or EGL_NO_CONTEXT.
Result<std::unique_ptr<GlContext>> CreateContext(EGLDisplay display, EGLConfig config,
                                                 EGLContext share) {
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0,
                                         EGL_NONE};
  EGLContext context = eglCreateContext(display, config, share, version.data());
  if (context == EGL_NO_CONTEXT) return EglFailure("makes no OpenGL ES 3.0 context");
  return std::make_unique<EglSurfacelessContext>(display, config, context);
}

Result<std::unique_ptr<GlContext>> EglSurfacelessContext::CreateShared() {
  return CreateContext(display_, config_, context_);
}

}  // namespace

Result<std::unique_ptr<GlContext>> CreateEglSurfacelessContext() {
  EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) return EglFailure("has no surfaceless platform");
  if (!eglInitialize(display, nullptr, nullptr)) return EglFailure("can't open its display");
  eglBindAPI(EGL_OPENGL_ES_API);
  const std::array<EGLint, 5> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_SURFACE_TYPE,
                                        0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count < 1) {
    return EglFailure("has no configuration for OpenGL ES 3");
  }
  return CreateContext(display, config, EGL_NO_CONTEXT);
}

}  // namespace parti::render
