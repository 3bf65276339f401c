#include "render/osmesa_context.h"

#include <dlfcn.h>

#include <array>

namespace parti::render {
namespace {

// Of GL/osmesa.h, which newer Mesa no longer ships.
constexpr int kFormat = 0x22, kDepthBits = 0x30, kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37;

struct OsMesaLibrary {
  void* (*create)(const int* attributes, void* share);
  void (*destroy)(void* context);
  unsigned char (*make_current)(void* context, void* buffer, GLenum type, GLsizei w, GLsizei h);
  void* (*lookup)(const char* name);
};

template <typename Function>
bool Load(void* library, const char* name, Function* function) {
  *function = reinterpret_cast<Function>(dlsym(library, name));
  return *function != nullptr;
}

Result<OsMesaLibrary> LoadLibrary() {
  // Never closed: LLVM's code inside it does not survive being unloaded and loaded again.
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (!library) library = dlopen("libOSMesa.so.6", RTLD_NOW | RTLD_LOCAL);
  OsMesaLibrary functions{};
  if (!library || !Load(library, "OSMesaCreateContextAttribs", &functions.create) ||
      !Load(library, "OSMesaDestroyContext", &functions.destroy) ||
      !Load(library, "OSMesaMakeCurrent", &functions.make_current) ||
      !Load(library, "OSMesaGetProcAddress", &functions.lookup)) {
    return Fail(ErrorCode::kGraphics, "there is no OSMesa (libOSMesa.so.8)",
                "install libosmesa6, or libegl1 and libgl1-mesa-dri for EGL");
  }
  return functions;
}

class OsMesaContext final : public GlContext {
 public:
  OsMesaContext(const OsMesaLibrary& library, void* context)
      : library_(library), context_(context) {}
  ~OsMesaContext() override { library_.destroy(context_); }

  Result<void> MakeCurrent() override {
    if (library_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide)) return {};
    return Fail(ErrorCode::kGraphics, "OSMesa can't make its context current");
  }
  void Release() override { library_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0); }
  GlLookup Lookup() const override { return library_.lookup; }
  bool is_gles() const override { return false; }
  std::string_view name() const override { return "OSMesa"; }
  Result<std::unique_ptr<GlContext>> CreateShared() override;

 private:
  static constexpr int kSide = 4;  ///< px; pictures are drawn into framebuffer objects, not here
  OsMesaLibrary library_;
  void* context_;
  std::array<uint8_t, size_t{4} * kSide * kSide> buffer_{};
};

/// `share`: the context with which it shares, or null.
Result<std::unique_ptr<GlContext>> CreateContext(const OsMesaLibrary& library, void* share) {
  const std::array<int, 11> attributes = {
      kFormat,       GL_RGBA, kDepthBits,    0, kProfile, kCoreProfile,
      kMajorVersion, 3,       kMinorVersion, 3, 0};
  void* context = library.create(attributes.data(), share);
  if (!context) {
    return Fail(ErrorCode::kGraphics, "OSMesa makes no OpenGL 3.3 core context",
                "update the Mesa packages");
  }
  return std::make_unique<OsMesaContext>(library, context);
}

Result<std::unique_ptr<GlContext>> OsMesaContext::CreateShared() {
  return CreateContext(library_, context_);
}

}  // namespace

Result<std::unique_ptr<GlContext>> CreateOsMesaContext() {
  const Result<OsMesaLibrary> library = LoadLibrary();
  if (!library) return Fail(library);
  return CreateContext(*library, nullptr);
}

}  // namespace parti::render

#ifdef __SANITIZE_ADDRESS__
/// OSMesa keeps some 160 bytes of each context that it destroys; nothing of ours is in it.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa.so"; }
/// Nor is it told at the end of each program that draws: tests compare what those print.
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
/// The thread-local data of libraries that are loaded as the program runs, as OSMesa is: g++ 12's
/// ASan guesses their place from bytes that glibc 2.36 no longer writes wherever one begins 16
/// bytes into a page, and LeakSanitizer then dies of reading there (sanitizer_tls_get_addr.cpp).
extern "C" const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
#endif
