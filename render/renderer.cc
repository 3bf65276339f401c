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
  auto ground = make("ground", "ground"), face = make("face", "face"),
       face_image = make("face", "face_image"), line = make("line", "line"),
       ink = make("ink", "ink"), ink_over = make("full_screen", "ink_over"), id = make("id", "id"),
       depth = make("depth", "depth");
  if (failed) return tl::unexpected(*failed);
  GLint most_samples = 0;
  gl.GetIntegerv(GL_MAX_SAMPLES, &most_samples);
  return Renderer(gl, look,
                  {std::move(*ground), std::move(*face), std::move(*face_image), std::move(*line),
                   std::move(*ink), std::move(*ink_over), std::move(*id), std::move(*depth)},
                  most_samples);
}

Result<LoadedScene> Renderer::Load(const Scene& scene,
                                   std::optional<LoadedScene> instead_of) const {
  std::optional<SunShadow> replaced;
  GpuTextures old_textures(*gl_);
  if (instead_of) {
    replaced.emplace(std::move(instead_of->shadow));
    old_textures = std::move(instead_of->scene.textures);
  }
  instead_of.reset();
  GpuScene uploaded(*gl_, scene, std::move(old_textures));
  if (const auto checked = CheckGl(*gl_, "uploading the scene"); !checked) return Fail(checked);
  Result<SunShadow> shadow =
      SunShadow::Create(*gl_, programs_.depth, uploaded, look_, std::move(replaced));
  if (!shadow) return Fail(shadow);
  return LoadedScene{std::move(uploaded), std::move(*shadow)};
}

Result<void> Renderer::SizeFor(const Tile& tile) {
  if (picture_ && picture_->spec().width >= tile.width && picture_->spec().height >= tile.height) {
    return {};
  }
  samples_.reset();
  picture_.reset();
  coverage_.reset();
  const FramebufferSpec picture{tile.width,           tile.height, GL_SRGB8_ALPHA8,
                                GL_DEPTH_COMPONENT24, 0,           false};
  FramebufferSpec samples = picture;
  samples.samples = std::min(look_.samples, most_samples_);
  Result<GlFramebuffer> many = GlFramebuffer::Create(*gl_, samples);
  if (!many) return Fail(many);
  Result<GlFramebuffer> one = GlFramebuffer::Create(*gl_, picture);
  if (!one) return Fail(one);
  Result<GlFramebuffer> coverage =
      GlFramebuffer::Create(*gl_, {tile.width, tile.height, GL_R8, 0, 0, true});
  if (!coverage) return Fail(coverage);
  samples_ = std::move(*many);
  picture_ = std::move(*one);
  coverage_ = std::move(*coverage);
  return {};
}

void Renderer::Resolve(const Tile& tile, const GlFramebuffer& from, GLuint to,
                       GLbitfield what) const {
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  gl_->BlitFramebuffer(0, 0, tile.width, tile.height, 0, 0, tile.width, tile.height, what,
                       GL_NEAREST);
}

Result<void> Renderer::Draw(const LoadedScene& loaded, const Camera& camera, const Tile& tile,
                            GLuint framebuffer, const Detail& detail) {
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  if (const auto sized = SizeFor(tile); !sized) return Fail(sized);
  const GpuScene& scene = loaded.scene;
  const Frame frame(camera, scene.bounds, tile, look_, detail);
  const bool many = detail.many_samples;
  // A face whose edge others cover would come through them. Depths of their own for lines cost a
  // pass, and so are left to scenes and pictures that show it.
  const bool own_depths = many && scene.has_covered_lines;
  // GLES encodes whatever goes into an sRGB framebuffer; GL does when asked to.
  if (!gl_->is_gles) gl_->Enable(GL_FRAMEBUFFER_SRGB);
  (many ? samples_ : picture_)->Bind();
  frame.SetViewport(*gl_);
  gl_->DepthMask(GL_TRUE);
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
  DrawFaces(*gl_, programs_.face, programs_.face_image, frame, scene, loaded.shadow.lookup(),
            own_depths ? FaceDepth::kWhereTheyAre : FaceDepth::kForLines);
  DrawGround(*gl_, programs_.ground, frame, scene, loaded.shadow.lookup(), full_screen_);
  // Lines smooth their own edges, and cost a quarter of what they would in the samples.
  if (own_depths) {
    picture_->Bind();
    gl_->Clear(GL_DEPTH_BUFFER_BIT);
    // The ids are drawn over by what is resolved next; their depths stay.
    DrawFaceIds(*gl_, programs_.id, frame, scene, FaceDepth::kForLines);
  }
  if (many) {
    Resolve(tile, *samples_, picture_->id(),
            GL_COLOR_BUFFER_BIT | (own_depths ? 0 : GL_DEPTH_BUFFER_BIT));
    picture_->Bind();
  }
  DrawLines(*gl_, programs_.line, frame, scene);
  Resolve(tile, *picture_, framebuffer, GL_COLOR_BUFFER_BIT);
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
