#include "render/passes.h"

namespace parti::render {
namespace {

void DrawStream(const Gl& gl, const VertexStream& lines) {
  lines.ForEachBlock([&gl](GLsizei n) { gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, n); });
}

}  // namespace

void DrawLines(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene) {
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(GL_FUNC_ADD);
  // Colours come multiplied by their alpha; the picture stays opaque.
  gl.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  program.Use();
  program.Set("clip_from_world", frame.clip_from_world);
  program.Set("eye", frame.eye);
  program.Set("picture", Vec2f(frame.size));
  program.Set("near", static_cast<float>(frame.range.near_m));
  program.Set("pull", frame.look.line_pull);
  program.Set("strength", 1.0f);
  gl.DepthFunc(GL_LEQUAL);
  DrawStream(gl, scene.lines);
  DrawStream(gl, scene.lines_on_top);
  program.Set("strength", frame.look.hidden_strength);
  gl.DepthFunc(GL_GREATER);
  DrawStream(gl, scene.lines_on_top);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

}  // namespace parti::render
