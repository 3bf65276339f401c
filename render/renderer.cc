#include "render/renderer.h"

#include <algorithm>

#include "render/passes.h"

namespace parti::render {

Renderer::Renderer(const Gl& gl, const Look& look, Programs programs, GLint most_samples)
    : gl_(&gl),
      look_(look),
      programs_(std::move(programs)),
      most_samples_(most_samples),
      full_screen_(gl) {}

Result<Renderer> Renderer::Create(const Gl& gl, const Look& look) {
  std::optional<Error> failed;
  const auto make = [&](const char* vertex, const char* fragment) -> std::optional<GlProgram> {
    Result<GlProgram> program = GlProgram::Create(gl, vertex, fragment);
    if (program) return std::move(*program);
    if (!failed) failed = program.error();
    return std::nullopt;
  };
  auto ground = make("ground", "ground"), face = make("face", "face"), line = make("line", "line"),
       ink = make("ink", "ink"), ink_over = make("full_screen", "ink_over"), id = make("id", "id"),
       depth = make("depth", "depth");
  if (failed) return tl::unexpected(*failed);
  GLint most_samples = 0;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most_samples);
  return Renderer(gl, look,
                  {std::move(*ground), std::move(*face), std::move(*line), std::move(*ink),
                   std::move(*ink_over), std::move(*id), std::move(*depth)},
                  most_samples);
}

Result<LoadedScene> Renderer::Load(const Scene& scene) const {
  GpuScene uploaded(*gl_, scene);
  if (const auto checked = CheckGl(*gl_, "uploading the scene"); !checked) return Fail(checked);
  Result<SunShadow> shadow = SunShadow::Create(*gl_, programs_.depth, uploaded, look_);
  if (!shadow) return Fail(shadow);
  return LoadedScene{std::move(uploaded), std::move(*shadow)};
}

Result<void> Renderer::SizeFor(const Tile& tile) {
  const FramebufferSpec samples{tile.width,
                                tile.height,
                                GL_SRGB8_ALPHA8,
                                GL_DEPTH_COMPONENT24,
                                std::min(look_.samples, most_samples_),
                                false};
  if (samples_ && samples_->spec() == samples) return {};
  samples_.reset();
  coverage_.reset();
  Result<GlFramebuffer> made = GlFramebuffer::Create(*gl_, samples);
  if (!made) return Fail(made);
  Result<GlFramebuffer> coverage =
      GlFramebuffer::Create(*gl_, {tile.width, tile.height, GL_R8, 0, 0, true});
  if (!coverage) return Fail(coverage);
  samples_ = std::move(*made);
  coverage_ = std::move(*coverage);
  return {};
}

Result<void> Renderer::Draw(const LoadedScene& loaded, const Camera& camera, const Tile& tile,
                            GLuint framebuffer) {
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  if (const auto sized = SizeFor(tile); !sized) return Fail(sized);
  const GpuScene& scene = loaded.scene;
  const Frame frame(camera, scene.bounds, tile, look_);
  // GLES encodes whatever goes into an sRGB framebuffer; GL does when asked to.
  if (!gl_->is_gles) gl_->Enable(GL_FRAMEBUFFER_SRGB);
  samples_->Bind();
  frame.SetViewport(*gl_);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
  DrawGround(*gl_, programs_.ground, frame, scene, loaded.shadow.lookup(), full_screen_);
  DrawFaces(*gl_, programs_.face, frame, scene, loaded.shadow.lookup());
  DrawLines(*gl_, programs_.line, frame, scene);
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, samples_->id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl_->BlitFramebuffer(0, 0, tile.width, tile.height, 0, 0, tile.width, tile.height,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
  DrawInk(*gl_, programs_.ink, programs_.ink_over, frame, scene, *coverage_, framebuffer,
          full_screen_);
  return CheckGl(*gl_, "drawing");
}

Result<void> Renderer::DrawIds(const LoadedScene& loaded, const Camera& camera,
                               const Tile& tile) const {
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  const Frame frame(camera, loaded.scene.bounds, tile, look_);
  frame.SetViewport(*gl_);
  gl_->ClearColor(0, 0, 0, 0);
  gl_->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  DrawFaceIds(*gl_, programs_.id, frame, loaded.scene);
  return CheckGl(*gl_, "drawing ids");
}

}  // namespace parti::render
