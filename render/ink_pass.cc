// Ink: the coverage of a stroke first, then its colour through it, so that pieces join unseen.
#include "render/passes.h"

namespace parti::render {
namespace {

/// The greatest coverage of a group's pieces at each pixel of the tile.
void DrawCoverage(const Gl& gl, const GlProgram& program, const Frame& frame,
                  const VertexStream& pieces, const GlFramebuffer& coverage) {
  coverage.Bind();
  frame.SetViewport(gl);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BlendEquation(GL_MAX);
  program.Use();
  program.Set("picture", Vec2f(frame.size));
  pieces.Draw();
}

void DrawOver(const Gl& gl, const GlProgram& program, const Frame& frame, const Vec4f& color,
              const GlFramebuffer& coverage, GLuint framebuffer, const FullScreenTriangle& all) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, frame.tile.width, frame.tile.height);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  program.Use();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, coverage.color_texture());
  program.Set("coverage", 0);
  program.Set("color", color);
  all.Draw();
}

}  // namespace

void DrawInk(const Gl& gl, const GlProgram& ink_program, const GlProgram& over_program,
             const Frame& frame, const GpuScene& scene, const GlFramebuffer& coverage,
             GLuint framebuffer, const FullScreenTriangle& all) {
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  for (const InkGroup& group : scene.ink) {
    DrawCoverage(gl, ink_program, frame, group.pieces, coverage);
    DrawOver(gl, over_program, frame, group.color, coverage, framebuffer, all);
  }
  gl.Disable(GL_BLEND);
}

}  // namespace parti::render
