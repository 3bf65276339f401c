#include "render/egl_window.h"

#include <EGL/eglext.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace parti::render {
namespace {

tl::unexpected<Error> EglFailure(const std::string& what) {
  return Fail(ErrorCode::kGraphics, fmt::format("EGL {} (error {:#x})", what, eglGetError()),
              "install libegl1 and libgl1-mesa-dri, or the driver of the graphics card");
}

bool Has(std::string_view extensions, std::string_view name) {
  for (size_t at = extensions.find(name); at != std::string_view::npos;
       at = extensions.find(name, at + 1)) {
    const size_t end = at + name.size();
    if (end == extensions.size() || extensions[end] == ' ') return true;
  }
  return false;
}

/// Keeps the drivers that EGL has loaded: LLVM's code inside them does not survive being unloaded
/// and loaded again, which the end of one display and the start of another would do.
void KeepDrivers() {
  std::vector<std::string> drivers;
  const auto note = [](dl_phdr_info* library, size_t, void* names) {
    const std::string_view name = library->dlpi_name;
    if (name.ends_with("_dri.so"))
      static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  };
  dl_iterate_phdr(note, &drivers);
  for (const std::string& driver : drivers) {
    dlopen(driver.c_str(), RTLD_LAZY | RTLD_NOLOAD | RTLD_NODELETE);
  }
}

/// What the window and the contexts that share with it have in common.
struct Connection {
  explicit Connection(const EglPlatform& from)
      : platform(from), display(eglGetPlatformDisplay(from.kind, from.native.get(), nullptr)) {}
  ~Connection() {
    if (initialised) eglTerminate(display);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  EglPlatform platform;
  EGLDisplay display;
  bool initialised = false;
  EGLConfig config = nullptr;
  bool has_buffer_age = false;
  PFNEGLSWAPBUFFERSWITHDAMAGEEXTPROC swap_with_damage = nullptr;
};

Result<void> ChooseConfig(Connection* connection) {
  const std::array<EGLint, 13> wanted = {EGL_SURFACE_TYPE,
                                         EGL_WINDOW_BIT,
                                         EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_ES3_BIT,
                                         EGL_RED_SIZE,
                                         8,
                                         EGL_GREEN_SIZE,
                                         8,
                                         EGL_BLUE_SIZE,
                                         8,
                                         EGL_SAMPLES,
                                         0,
                                         EGL_NONE};
  std::array<EGLConfig, 256> configs{};
  EGLint count = 0;
  if (eglChooseConfig(connection->display, wanted.data(), configs.data(),
                      static_cast<EGLint>(configs.size()), &count)) {
    for (EGLint i = 0; i < count; ++i) {
      EGLint visual = 0;
      eglGetConfigAttrib(connection->display, configs[static_cast<size_t>(i)], EGL_NATIVE_VISUAL_ID,
                         &visual);
      if (visual != connection->platform.visual) continue;
      connection->config = configs[static_cast<size_t>(i)];
      return {};
    }
  }
  return EglFailure("has no configuration that " + connection->platform.what + " can show");
}

Result<std::shared_ptr<Connection>> Connect(const EglPlatform& platform) {
  auto connection = std::make_shared<Connection>(platform);
  if (connection->display == EGL_NO_DISPLAY ||
      !eglInitialize(connection->display, nullptr, nullptr)) {
    return EglFailure("can't draw on " + platform.what);
  }
  connection->initialised = true;
  KeepDrivers();
  const std::string_view extensions = eglQueryString(connection->display, EGL_EXTENSIONS);
  if (!Has(extensions, "EGL_KHR_surfaceless_context")) {
    return EglFailure("lacks EGL_KHR_surfaceless_context");
  }
  connection->has_buffer_age = Has(extensions, "EGL_EXT_buffer_age");
  for (const char* suffix : {"EXT", "KHR"}) {
    if (!Has(extensions, fmt::format("EGL_{}_swap_buffers_with_damage", suffix))) continue;
    connection->swap_with_damage = reinterpret_cast<PFNEGLSWAPBUFFERSWITHDAMAGEEXTPROC>(
        eglGetProcAddress(fmt::format("eglSwapBuffersWithDamage{}", suffix).c_str()));
  }
  if (const auto chosen = ChooseConfig(connection.get()); !chosen) return Fail(chosen);
  return connection;
}

class Context final : public EglWindow {
 public:
  Context(std::shared_ptr<Connection> connection, EGLContext context)
      : connection_(std::move(connection)), context_(context) {}
  ~Context() override {
    // What is current would only be marked for later.
    if (eglGetCurrentContext() == context_) Context::Release();
    if (surface_ != EGL_NO_SURFACE) eglDestroySurface(connection_->display, surface_);
    eglDestroyContext(connection_->display, context_);
  }

  static Result<std::unique_ptr<Context>> Make(const std::shared_ptr<Connection>& connection,
                                               EGLContext share) {
    eglBindAPI(EGL_OPENGL_ES_API);
    const std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION,
                                           0, EGL_NONE};
    EGLContext context =
        eglCreateContext(connection->display, connection->config, share, version.data());
    if (context == EGL_NO_CONTEXT) return EglFailure("makes no OpenGL ES 3.0 context");
    return std::make_unique<Context>(connection, context);
  }

  Result<void> MakeCurrent() override {
    if (eglBindAPI(EGL_OPENGL_ES_API) &&
        eglMakeCurrent(connection_->display, surface_, surface_, context_)) {
      return {};
    }
    return EglFailure("can't make the context of " + connection_->platform.what + " current");
  }
  void Release() override {
    eglMakeCurrent(connection_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  GlLookup Lookup() const override {
    return [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); };
  }
  bool is_gles() const override { return true; }
  std::string_view name() const override { return "EGL"; }
  Result<std::unique_ptr<GlContext>> CreateShared() override { return Make(connection_, context_); }

  Result<void> SetWindow(void* native) override;
  int BufferAge() const override;
  Result<void> Swap(std::span<const PixelRect> damage, int height_px) override;
  std::string Renderer() const override {
    const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(eglGetProcAddress("glGetString"));
    const auto* text = reinterpret_cast<const char*>(get_string(GL_RENDERER));
    return text ? text : "an unknown renderer";
  }

 private:
  std::shared_ptr<Connection> connection_;
  EGLContext context_;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

Result<void> Context::SetWindow(void* native) {
  if (surface_ != EGL_NO_SURFACE) {
    Release();
    eglDestroySurface(connection_->display, surface_);
    surface_ = EGL_NO_SURFACE;
  }
  if (native) {
    surface_ =
        eglCreatePlatformWindowSurface(connection_->display, connection_->config, native, nullptr);
    if (surface_ == EGL_NO_SURFACE) {
      return EglFailure("can't draw into the window of " + connection_->platform.what);
    }
  }
  if (const auto made = MakeCurrent(); !made) return made;
  // Waiting for the screen is the display's, which asks before it draws.
  if (native) eglSwapInterval(connection_->display, 0);
  return {};
}

int Context::BufferAge() const {
  EGLint age = 0;
  if (!connection_->has_buffer_age ||
      !eglQuerySurface(connection_->display, surface_, EGL_BUFFER_AGE_EXT, &age)) {
    return 0;
  }
  return std::max(age, 0);
}

Result<void> Context::Swap(std::span<const PixelRect> damage, int height_px) {
  bool swapped = false;
  if (connection_->swap_with_damage) {
    std::vector<EGLint> rectangles;
    for (const PixelRect& rect : damage) {
      rectangles.insert(rectangles.end(),
                        {rect.x, height_px - rect.y - rect.height, rect.width, rect.height});
    }
    // No rectangle at all would mean the whole window.
    if (rectangles.empty()) rectangles = {0, 0, 1, 1};
    swapped = connection_->swap_with_damage(connection_->display, surface_, rectangles.data(),
                                            static_cast<EGLint>(rectangles.size() / 4));
  } else {
    swapped = eglSwapBuffers(connection_->display, surface_);
  }
  if (!swapped) return EglFailure("can't show a frame on " + connection_->platform.what);
  return {};
}

}  // namespace

Result<std::unique_ptr<EglWindow>> EglWindow::Create(const EglPlatform& platform) {
  const auto connection = Connect(platform);
  if (!connection) return Fail(connection);
  return Context::Make(*connection, EGL_NO_CONTEXT);
}

}  // namespace parti::render
