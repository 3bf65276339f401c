// The layers of a picture: each draws one kind of thing into the bound
// framebuffer with the state that it sets itself. Renderer says when; these say how.
#pragma once

#include "render/frame.h"
#include "render/full_screen.h"
#include "render/gl_framebuffer.h"
#include "render/gpu_scene.h"

namespace parti::render {

/// Paper where no face is (after faces, then); grid and shadow on y = 0 where the scene has ground
/// and the eye is above it.
void DrawGround(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene,
                const ShadowLookup& shadow, const FullScreenTriangle& all);

/// Where faces lie in depth. Lines need them farther than they are: an edge's line then lies in
/// front of both its faces, however grazing the view, and no farther edge comes through. But of two
/// faces that touch, the steeper one goes farther, and the other comes through it by a pixel.
enum class FaceDepth { kWhereTheyAre, kForLines };

/// Lit faces, with depth: those of one colour with the first program, those that wear images with
/// the second, which is not used where there are none.
void DrawFaces(const Gl& gl, const GlProgram& plain, const GlProgram& with_image,
               const Frame& frame, const GpuScene& scene, const ShadowLookup& shadow,
               FaceDepth depth);

/// Ids of faces, with depth: four bytes of colour, lowest in red.
void DrawFaceIds(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene,
                 FaceDepth depth = FaceDepth::kWhereTheyAre);

/// Lines where no face hides them; on_top lines also, faintly, where one does.
void DrawLines(const Gl& gl, const GlProgram& program, const Frame& frame, const GpuScene& scene);

/// Ink over a finished picture in `framebuffer`. `coverage` is a readable GL_R8 framebuffer at
/// least as large as the tile; it is overwritten.
void DrawInk(const Gl& gl, const GlProgram& ink_program, const GlProgram& over_program,
             const Frame& frame, const GpuScene& scene, const GlFramebuffer& coverage,
             GLuint framebuffer, const FullScreenTriangle& all);

}  // namespace parti::render
