// A framebuffer object with what is attached to it: pictures, samples, ink coverage, shadow maps.
// Windows bring their own; the renderer takes any by its name.
#pragma once

#include "render/gl.h"

namespace parti::render {

/// What to make; sizes in pixels, at least 1.
struct FramebufferSpec {
  int width = 0;
  int height = 0;
  GLenum color = 0;       ///< GL_SRGB8_ALPHA8, GL_RGBA8, GL_R8; 0: none
  GLenum depth = 0;       ///< GL_DEPTH_COMPONENT24; 0: none
  int samples = 0;        ///< 0: no multisampling; not with `readable`
  bool readable = false;  ///< by shaders: textures rather than renderbuffers

  bool operator==(const FramebufferSpec&) const = default;
};

/// Used and destroyed while its context is current.
class GlFramebuffer {
 public:
  /// errors  kGraphics  too large for the device, or a format it doesn't draw into.
  static Result<GlFramebuffer> Create(const Gl& gl, const FramebufferSpec& spec);
  GlFramebuffer(GlFramebuffer&& other) noexcept;
  GlFramebuffer& operator=(GlFramebuffer&& other) noexcept;
  ~GlFramebuffer();

  /// Leaves it to its context: for when that can't be current any more.
  void Abandon() { id_ = color_ = depth_ = 0; }

  void Bind() const { gl_->BindFramebuffer(GL_FRAMEBUFFER, id_); }
  GLuint id() const { return id_; }
  GLuint color_texture() const { return color_; }  ///< of a readable one
  GLuint depth_texture() const { return depth_; }  ///< of a readable one
  const FramebufferSpec& spec() const { return spec_; }

 private:
  GlFramebuffer(const Gl& gl, const FramebufferSpec& spec) : gl_(&gl), spec_(spec) {}
  GLuint Attach(GLenum attachment, GLenum format);
  GLuint AttachTexture(GLenum attachment, GLenum format);
  void Delete(GLuint attached);

  const Gl* gl_;
  FramebufferSpec spec_;
  GLuint id_ = 0, color_ = 0, depth_ = 0;
};

}  // namespace parti::render
