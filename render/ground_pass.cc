// The paper, and on the plane y = 0 the grid and the shadow: one triangle, all worked out per
// pixel.
#include <algorithm>
#include <cmath>

#include "render/passes.h"

namespace parti::render {
namespace {

void SetRays(const GlProgram& program, const Frame& frame) {
  const View& view = frame.view;
  const Camera& camera = view.camera();
  const double half_high = std::tan(camera.vertical_fov.radians() * 0.5);
  const double per_px = half_high / (camera.height_px * 0.5);
  const Vec2 middle = Vec2(frame.size) * 0.5;  // in pixels, where clip x and y are 0
  const Vec3 ray = view.forward() + view.right() * ((middle.x - camera.width_px * 0.5) * per_px) -
                   view.up() * ((middle.y - camera.height_px * 0.5) * per_px);
  program.Set("ray_middle", Vec3f(ray));
  program.Set("ray_right", Vec3f(view.right() * (middle.x * per_px)));
  program.Set("ray_up", Vec3f(view.up() * (middle.y * per_px)));
  program.Set("eye", frame.eye);
}

}  // namespace

void DrawGround(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene,
                const ShadowLookup& shadow, const FullScreenTriangle& all) {
  const Look& look = frame.look;
  // At the far end of the depth range: only where nothing else is, and shaded only there.
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Disable(GL_BLEND);
  program.Use();
  SetRays(program, frame);
  program.Set("paper_low", look.paper_low);
  program.Set("paper_high", look.paper_high);
  program.Set("grid_ink", look.grid_ink);
  // Its lines are a pixel wide: in fewer pixels, paler.
  program.Set("grid_strength", look.grid_strength * static_cast<float>(frame.detail.scale));
  program.Set("shadow_ink", look.shadow_ink);
  const bool has_faces = !scene.face_bounds.empty();
  const Vec3 middle = has_faces ? scene.face_bounds.middle() : frame.view.camera().target;
  const double radius = std::max<double>(scene.face_bounds.radius(), look.least_ground_m);
  program.Set("ground_middle", Vec3f(middle.x, 0, middle.z));
  program.Set("ground_fade", Vec2f(radius * look.ground_full, radius * look.ground_none));
  program.Set("with_ground", scene.ground ? 1.0f : 0.0f);
  SetShadow(gl, program, shadow, frame);
  all.Draw();
  gl.DepthMask(GL_TRUE);
}

}  // namespace parti::render
