// Faces: lit flat, with the sun's shadow on them; and their ids.
#include "render/passes.h"

namespace parti::render {
namespace {

void SetLight(const GlProgram& program, const Frame& frame, const GpuScene& scene) {
  const Look& look = frame.look;
  program.Set("to_sun", glm::normalize(look.to_sun));
  program.Set("to_fill", glm::normalize(look.to_fill));
  program.Set("sun_light", look.sun_light);
  program.Set("fill_light", look.fill_light);
  program.Set("sky_light", look.sky_light);
  program.Set("ground_light", look.ground_light);
  program.Set("base_shade", look.base_shade);
  program.Set("base_height", static_cast<float>(scene.face_bounds.low.y));
}

void SetDepthState(const Gl& gl, const Look& look, FaceDepth depth) {
  if (depth == FaceDepth::kForLines) {
    // Farther by their slope over the pixels that a line is wide.
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(look.face_slope_offset, look.face_offset_units);
  }
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
}

void SetPlace(const GlProgram& program, const Frame& frame) {
  program.Set("clip_from_world", frame.clip_from_world);
  program.Set("eye", frame.eye);
  program.Set("back_push", frame.look.back_push);
  program.Set("layer_push", frame.look.layer_push);
  program.Set("depth_unit", frame.depth_unit);
}

void SetAll(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene,
            const ShadowLookup& shadow) {
  program.Use();
  SetPlace(program, frame);
  SetLight(program, frame, scene);
  SetShadow(gl, program, shadow, frame);
}

/// With the program in use; the shadow's map is in unit 0.
void DrawImageFaces(const Gl& gl, const GlProgram& program, const Frame& frame,
                    const GpuScene& scene) {
  program.Set("image", 1);
  gl.ActiveTexture(GL_TEXTURE1);
  for (const ImageFaces& worn : scene.image_faces) {
    gl.BindTexture(GL_TEXTURE_2D, worn.texture);
    worn.faces.DrawNearFirst(gl, frame.volume);
  }
  gl.ActiveTexture(GL_TEXTURE0);
}

}  // namespace

void DrawFaces(const Gl& gl, const GlProgram& plain, const GlProgram& with_image,
               const Frame& frame, const GpuScene& scene, const ShadowLookup& shadow,
               FaceDepth depth) {
  SetDepthState(gl, frame.look, depth);
  SetAll(gl, plain, frame, scene, shadow);
  scene.plain_faces.DrawNearFirst(gl, frame.volume);
  if (!scene.image_faces.empty()) {
    SetAll(gl, with_image, frame, scene, shadow);
    DrawImageFaces(gl, with_image, frame, scene);
  }
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void DrawFaceIds(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene,
                 FaceDepth depth) {
  SetDepthState(gl, frame.look, depth);
  program.Use();
  SetPlace(program, frame);
  scene.DrawFacesNearFirst(gl, frame.volume);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace parti::render
