// Lines in the world, each four corners around a capsule of constant width on the picture.
#include "render/passes.h"

namespace parti::render {
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
  program.Set("depth_unit", frame.depth_unit);
  program.Set("scale", static_cast<float>(frame.detail.scale));
  program.Set("metre", static_cast<float>(frame.pixels_per_m_at_1_m));
  program.Set("full", Vec2f(frame.look.full_spacing_px, frame.look.full_line_px));
  program.Set("least", frame.look.faintest_line);
  program.Set("strength", 1.0f);
  gl.DepthFunc(GL_LEQUAL);
  scene.lines.DrawSeen(frame.volume);
  scene.lines_on_top.DrawSeen(frame.volume);
  program.Set("strength", frame.look.hidden_strength);
  gl.DepthFunc(GL_GREATER);
  scene.lines_on_top.DrawSeen(frame.volume);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

}  // namespace parti::render
