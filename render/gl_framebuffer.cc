#include "render/gl_framebuffer.h"

#include <fmt/format.h>

#include <utility>

namespace parti::render {
namespace {

/// The layout of pixels that GLES takes with an internal format; GL takes any.
GLenum LayoutOf(GLenum format) {
  if (format == GL_DEPTH_COMPONENT24) return GL_DEPTH_COMPONENT;
  return format == GL_R8 ? GL_RED : GL_RGBA;
}

}  // namespace

Result<GlFramebuffer> GlFramebuffer::Create(const Gl& gl, const FramebufferSpec& spec) {
  GlFramebuffer made(gl, spec);
  gl.GenFramebuffers(1, &made.id_);
  made.Bind();
  if (spec.color) made.color_ = made.Attach(GL_COLOR_ATTACHMENT0, spec.color);
  if (spec.depth) made.depth_ = made.Attach(GL_DEPTH_ATTACHMENT, spec.depth);
  if (!spec.color) {
    const GLenum none = GL_NONE;
    gl.DrawBuffers(1, &none);
  }
  const std::string what = fmt::format("a framebuffer of {} x {} px", spec.width, spec.height);
  if (const auto checked = CheckGl(gl, what); !checked) return Fail(checked);
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    return Fail(ErrorCode::kGraphics, fmt::format("{} can't be made ({:#x})", what, status));
  }
  return made;
}

GLuint GlFramebuffer::Attach(GLenum attachment, GLenum format) {
  if (spec_.readable) return AttachTexture(attachment, format);
  GLuint buffer = 0;
  gl_->GenRenderbuffers(1, &buffer);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, buffer);
  gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, spec_.samples, format, spec_.width,
                                      spec_.height);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  return buffer;
}

GLuint GlFramebuffer::AttachTexture(GLenum attachment, GLenum format) {
  const bool is_depth = attachment == GL_DEPTH_ATTACHMENT;
  const GLint filter = is_depth ? GL_LINEAR : GL_NEAREST;
  GLuint texture = 0;
  gl_->GenTextures(1, &texture);
  gl_->BindTexture(GL_TEXTURE_2D, texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), spec_.width, spec_.height, 0,
                  LayoutOf(format), is_depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  if (is_depth) {
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
  return texture;
}

void GlFramebuffer::Delete(GLuint attached) {
  if (!attached) return;
  if (spec_.readable) {
    gl_->DeleteTextures(1, &attached);
  } else {
    gl_->DeleteRenderbuffers(1, &attached);
  }
}

GlFramebuffer::GlFramebuffer(GlFramebuffer&& other) noexcept
    : gl_(other.gl_),
      spec_(other.spec_),
      id_(std::exchange(other.id_, 0)),
      color_(std::exchange(other.color_, 0)),
      depth_(std::exchange(other.depth_, 0)) {}

GlFramebuffer& GlFramebuffer::operator=(GlFramebuffer&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(spec_, other.spec_);
  std::swap(id_, other.id_);
  std::swap(color_, other.color_);
  std::swap(depth_, other.depth_);
  return *this;
}

GlFramebuffer::~GlFramebuffer() {
  if (id_) gl_->DeleteFramebuffers(1, &id_);
  Delete(color_);
  Delete(depth_);
}

}  // namespace parti::render
