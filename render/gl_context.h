// A way to reach OpenGL: a context that can be made current. What a picture is drawn *into* is a
// framebuffer; windows (KMS, X11, Wayland) add theirs and their swapping to this.
#pragma once

#include <memory>
#include <string_view>

#include "base/error.h"
#include "render/gl.h"

namespace parti::render {

/// Several contexts may live in one process; each is used by one thread at a time.
class GlContext {
 public:
  virtual ~GlContext() = default;

  /// errors  kGraphics.
  virtual Result<void> MakeCurrent() = 0;
  /// No context is current on this thread afterwards. Needed before another *kind* of context is
  /// made current: Mesa's kinds share their notion of the current one and don't notice each other.
  virtual void Release() = 0;
  /// Where GL functions come from; valid while current.
  virtual GlLookup Lookup() const = 0;
  virtual bool is_gles() const = 0;
  virtual std::string_view name() const = 0;  ///< "OSMesa", "EGL surfaceless"
  /// Another context, for another thread, that knows this one's textures, buffers and programs by
  /// the same names; framebuffers and vertex arrays are each context's own. What one thread has
  /// written, another sees once the first has finished (glFinish or a fence) and the second has
  /// bound it again. Called by the thread that uses this context; either may be destroyed first.
  /// errors  kGraphics.
  virtual Result<std::unique_ptr<GlContext>> CreateShared() = 0;
};

/// Current while in scope.
class CurrentScope {
 public:
  explicit CurrentScope(GlContext& context) : context_(context), made_(context.MakeCurrent()) {}
  ~CurrentScope() { context_.Release(); }
  CurrentScope(const CurrentScope&) = delete;
  CurrentScope& operator=(const CurrentScope&) = delete;
  const Result<void>& made() const { return made_; }

 private:
  GlContext& context_;
  Result<void> made_;
};

}  // namespace parti::render
