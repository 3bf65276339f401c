// The OpenGL functions that Parti calls: what GL 3.3 core and GLES 3.0 have in common.
// Each context has its own table, since OSMesa and EGL may live in one process; not a loader of
// libraries (see the contexts) and not the place for drawing.
#pragma once

#include <GL/glcorearb.h>

#include <functional>
#include <string>

#include "base/error.h"

// clang-format off
/// Calls X(UPPER, Name) for each function, as GL/glcorearb.h spells its type PFNGL<UPPER>PROC.
#define PARTI_GL_FUNCTIONS(X) \
  X(ACTIVETEXTURE, ActiveTexture) X(ATTACHSHADER, AttachShader) \
  X(BINDBUFFER, BindBuffer) X(BINDFRAMEBUFFER, BindFramebuffer) X(BINDRENDERBUFFER, BindRenderbuffer) \
  X(BINDTEXTURE, BindTexture) X(BINDVERTEXARRAY, BindVertexArray) X(BLENDEQUATION, BlendEquation) \
  X(BLENDFUNCSEPARATE, BlendFuncSeparate) X(BLITFRAMEBUFFER, BlitFramebuffer) X(BUFFERDATA, BufferData) X(BUFFERSUBDATA, BufferSubData) \
  X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus) X(CLEAR, Clear) X(CLEARCOLOR, ClearColor) \
  X(CLIENTWAITSYNC, ClientWaitSync) X(FENCESYNC, FenceSync) X(DELETESYNC, DeleteSync) X(FINISH, Finish) \
  X(FLUSH, Flush) X(SCISSOR, Scissor) X(DRAWELEMENTS, DrawElements) X(TEXSUBIMAGE2D, TexSubImage2D) \
  X(UNIFORMMATRIX3FV, UniformMatrix3fv) \
  X(COMPILESHADER, CompileShader) X(CREATEPROGRAM, CreateProgram) \
  X(CREATESHADER, CreateShader) X(DELETEBUFFERS, DeleteBuffers) X(DELETEFRAMEBUFFERS, DeleteFramebuffers) \
  X(DELETEPROGRAM, DeleteProgram) X(DELETERENDERBUFFERS, DeleteRenderbuffers) X(DELETESHADER, DeleteShader) \
  X(DELETETEXTURES, DeleteTextures) X(DELETEVERTEXARRAYS, DeleteVertexArrays) X(DEPTHFUNC, DepthFunc) \
  X(DEPTHMASK, DepthMask) X(DISABLE, Disable) X(DRAWARRAYS, DrawArrays) \
  X(DRAWARRAYSINSTANCED, DrawArraysInstanced) X(DRAWBUFFERS, DrawBuffers) X(ENABLE, Enable) \
  X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer) \
  X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D) X(GENBUFFERS, GenBuffers) X(GENERATEMIPMAP, GenerateMipmap) \
  X(GENFRAMEBUFFERS, GenFramebuffers) X(GENRENDERBUFFERS, GenRenderbuffers) X(GENTEXTURES, GenTextures) \
  X(GENVERTEXARRAYS, GenVertexArrays) X(GETERROR, GetError) X(GETINTEGERV, GetIntegerv) \
  X(GETPROGRAMINFOLOG, GetProgramInfoLog) X(GETPROGRAMIV, GetProgramiv) \
  X(GETSHADERINFOLOG, GetShaderInfoLog) X(GETSHADERIV, GetShaderiv) \
  X(GETUNIFORMLOCATION, GetUniformLocation) X(LINKPROGRAM, LinkProgram) X(PIXELSTOREI, PixelStorei) \
  X(POLYGONOFFSET, PolygonOffset) X(READPIXELS, ReadPixels) \
  X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) X(SHADERSOURCE, ShaderSource) \
  X(TEXIMAGE2D, TexImage2D) X(TEXPARAMETERI, TexParameteri) X(UNIFORM1F, Uniform1f) X(UNIFORM1I, Uniform1i) \
  X(UNIFORM2F, Uniform2f) X(UNIFORM3F, Uniform3f) X(UNIFORM4F, Uniform4f) \
  X(UNIFORMMATRIX4FV, UniformMatrix4fv) X(USEPROGRAM, UseProgram) \
  X(VERTEXATTRIBDIVISOR, VertexAttribDivisor) X(VERTEXATTRIBPOINTER, VertexAttribPointer) \
  X(VIEWPORT, Viewport)
// clang-format on

namespace parti::render {

/// The functions of one context, without their "gl" prefix: gl.DrawArrays(…).
struct Gl {
#define PARTI_GL_MEMBER(UPPER, Name) PFNGL##UPPER##PROC Name = nullptr;
  PARTI_GL_FUNCTIONS(PARTI_GL_MEMBER)  ///< one pointer each, named as the function
#undef PARTI_GL_MEMBER
  bool is_gles = false;
};

using GlLookup = std::function<void*(const char* name)>;

/// Fills a table from the current context's look-up (OSMesaGetProcAddress, eglGetProcAddress).
/// errors  kGraphics  names the first function that is missing.
Result<Gl> LoadGl(const GlLookup& lookup, bool is_gles);

/// errors  kGraphics  `doing` and the name of the first error that GL has noted since last asked.
Result<void> CheckGl(const Gl& gl, const std::string& doing);

}  // namespace parti::render
