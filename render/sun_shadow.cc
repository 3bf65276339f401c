#include "render/sun_shadow.h"

#include <algorithm>
#include <cmath>

namespace parti::render {

ShadowLookup ShadowLookupFor(const Bounds& faces, const Look& look) {
  const Vec3 down = -glm::normalize(Vec3(look.to_sun));
  const Vec3 right = glm::normalize(glm::cross(down, Vec3(0, 1, 0)));
  const Vec3 up = glm::cross(right, down);
  Bounds seen;  // in the sun's axes
  for (int corner = 0; corner < 8 && !faces.empty(); ++corner) {
    const Vec3 p(corner & 1 ? faces.high.x : faces.low.x, corner & 2 ? faces.high.y : faces.low.y,
                 corner & 4 ? faces.high.z : faces.low.z);
    seen.Add(Vec3(glm::dot(p, right), glm::dot(p, up), glm::dot(p, down)));
  }
  ShadowLookup lookup;
  lookup.texel = 1.0f / static_cast<float>(look.shadow_side);
  // A margin of texels keeps the map's border free of casters, where it would smear.
  const Vec3 extent = seen.empty() ? Vec3(1) : seen.high - seen.low;
  const double side = std::max({extent.x, extent.y, 1e-3}) * (1 + 8.0 * lookup.texel);
  const double deep = std::max(extent.z, 1e-3) * 1.01;
  const Vec3 middle = seen.middle();
  const auto row = [](const Vec3& axis, double size, double centre) {
    return Vec4(axis / size, 0.5 - centre / size);
  };
  const Mat4 rows(row(right, side, middle.x), row(up, side, middle.y), row(down, deep, middle.z),
                  Vec4(0, 0, 0, 1));
  lookup.shadow_from_world = glm::mat4(glm::transpose(rows));
  lookup.texel_m = static_cast<float>(side * lookup.texel);
  lookup.bias_m = lookup.texel_m * look.shadow_bias_texels;
  return lookup;
}

Result<SunShadow> SunShadow::Create(const Gl& gl, const GlProgram& depth_program,
                                    const GpuScene& scene, const Look& look,
                                    std::optional<SunShadow> instead_of) {
  FramebufferSpec spec{look.shadow_side, look.shadow_side, 0, GL_DEPTH_COMPONENT24, 0, true};
  Result<GlFramebuffer> map =
      instead_of ? std::move(instead_of->map_) : GlFramebuffer::Create(gl, spec);
  if (!map) return Fail(map);
  map->Bind();
  ShadowLookup lookup = ShadowLookupFor(scene.face_bounds, look);
  lookup.texture = map->depth_texture();
  gl.Viewport(0, 0, spec.width, spec.height);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(1, 1);
  depth_program.Use();
  const glm::mat4 clip_from_shadow =
      glm::mat4(glm::mat4x4(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1));
  depth_program.Set("clip_from_world", clip_from_shadow * lookup.shadow_from_world);
  scene.DrawAllFaces(gl);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  if (const auto checked = CheckGl(gl, "drawing the shadow"); !checked) return Fail(checked);
  return SunShadow(std::move(*map), lookup);
}

}  // namespace parti::render
