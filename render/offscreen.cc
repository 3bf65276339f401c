#include "render/offscreen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>

#include "render/egl_context.h"
#include "render/osmesa_context.h"
#include "render/renderer.h"

namespace parti::render {
namespace {

class Offscreen final : public OffscreenRenderer {
 public:
  Offscreen(std::unique_ptr<GlContext> context, const Gl& gl, int tile_side)
      : context_(std::move(context)), gl_(gl), tile_side_(tile_side) {}
  ~Offscreen() override;

  Result<void> Start();
  Result<Image> Draw(const Scene& scene, const Camera& camera) override;
  Result<std::vector<uint32_t>> DrawIds(const Scene& scene, const Camera& camera) override;
  std::string_view name() const override { return context_->name(); }

 private:
  Result<void> CheckSize(const Camera& camera) const;
  template <typename DrawTile>
  Result<void> DrawTiles(const Camera& camera, const FramebufferSpec& kind, const DrawTile& draw,
                         uint8_t* pixels);
  void ReadTile(const Tile& tile, const glm::ivec2& size, uint8_t* pixels) const;

  std::unique_ptr<GlContext> context_;
  Gl gl_;
  int tile_side_;
  GLint most_px_ = 0;
  std::optional<Renderer> renderer_;
};

Offscreen::~Offscreen() {
  const CurrentScope current(*context_);
  renderer_.reset();
}

Result<void> Offscreen::Start() {
  const CurrentScope current(*context_);
  if (!current.made()) return Fail(current.made());
  GLint most[2] = {0, 0};
  gl_.GetIntegerv(GL_MAX_VIEWPORT_DIMS, most);
  most_px_ = std::min(most[0], most[1]);
  Result<Renderer> renderer = Renderer::Create(gl_);
  if (!renderer) return Fail(renderer);
  renderer_.emplace(std::move(*renderer));
  return {};
}

Result<void> Offscreen::CheckSize(const Camera& camera) const {
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  const glm::ivec2 size = PictureSize(camera);
  if (size.x <= most_px_ && size.y <= most_px_) return {};
  return Fail(ErrorCode::kGraphics,
              fmt::format("a picture of {} x {} px is too large for {}", size.x, size.y, name()),
              fmt::format("at most {} px a side", most_px_));
}

/// Calls draw(tile, framebuffer) for each tile of the picture and gathers its pixels.
template <typename DrawTile>
Result<void> Offscreen::DrawTiles(const Camera& camera, const FramebufferSpec& kind,
                                  const DrawTile& draw, uint8_t* pixels) {
  const glm::ivec2 size = PictureSize(camera);
  std::optional<GlFramebuffer> target;
  for (int y = 0; y < size.y; y += tile_side_) {
    for (int x = 0; x < size.x; x += tile_side_) {
      const Tile tile{x, y, std::min(tile_side_, size.x - x), std::min(tile_side_, size.y - y)};
      FramebufferSpec spec = kind;
      spec.width = tile.width;
      spec.height = tile.height;
      if (!target || !(target->spec() == spec)) {
        Result<GlFramebuffer> made = GlFramebuffer::Create(gl_, spec);
        if (!made) return Fail(made);
        target = std::move(*made);
      }
      target->Bind();
      if (Result<void> drawn = draw(tile, target->id()); !drawn) return drawn;
      target->Bind();
      ReadTile(tile, size, pixels);
    }
  }
  return CheckGl(gl_, "reading the picture back");
}

void Offscreen::ReadTile(const Tile& tile, const glm::ivec2& size, uint8_t* pixels) const {
  const size_t row = size_t{4} * tile.width;
  std::vector<uint8_t> read(row * tile.height);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
  for (int i = 0; i < tile.height; ++i) {
    const size_t from_top = static_cast<size_t>(size.y - 1 - (tile.y + i));
    std::memcpy(pixels + (from_top * size.x + tile.x) * 4, read.data() + row * i, row);
  }
}

Result<Image> Offscreen::Draw(const Scene& scene, const Camera& camera) {
  if (const auto fits = CheckSize(camera); !fits) return Fail(fits);
  const CurrentScope current(*context_);
  if (!current.made()) return Fail(current.made());
  const Result<LoadedScene> loaded = renderer_->Load(scene);
  if (!loaded) return Fail(loaded);
  const glm::ivec2 size = PictureSize(camera);
  Image image{size.x, size.y, std::vector<uint8_t>(size_t{4} * size.x * size.y)};
  const auto draw = [&](const Tile& tile, GLuint framebuffer) {
    return renderer_->Draw(*loaded, camera, tile, framebuffer);
  };
  const Result<void> drawn =
      DrawTiles(camera, {0, 0, GL_SRGB8_ALPHA8, 0, 0, false}, draw, image.pixels.data());
  if (!drawn) return Fail(drawn);
  return image;
}

Result<std::vector<uint32_t>> Offscreen::DrawIds(const Scene& scene, const Camera& camera) {
  if (const auto fits = CheckSize(camera); !fits) return Fail(fits);
  const CurrentScope current(*context_);
  if (!current.made()) return Fail(current.made());
  const Result<LoadedScene> loaded = renderer_->Load(scene);
  if (!loaded) return Fail(loaded);
  const glm::ivec2 size = PictureSize(camera);
  std::vector<uint8_t> bytes(size_t{4} * size.x * size.y);
  const auto draw = [&](const Tile& tile, GLuint) {
    return renderer_->DrawIds(*loaded, camera, tile);
  };
  const Result<void> drawn =
      DrawTiles(camera, {0, 0, GL_RGBA8, GL_DEPTH_COMPONENT24, 0, false}, draw, bytes.data());
  if (!drawn) return Fail(drawn);
  std::vector<uint32_t> ids(bytes.size() / 4);
  for (size_t i = 0; i < ids.size(); ++i) {
    const uint8_t* b = &bytes[4 * i];
    ids[i] = b[0] | uint32_t{b[1]} << 8 | uint32_t{b[2]} << 16 | uint32_t{b[3]} << 24;
  }
  return ids;
}

}  // namespace

Result<std::unique_ptr<GlContext>> CreateOffscreenContext(OffscreenTarget target) {
  if (target == OffscreenTarget::kOsMesa) return CreateOsMesaContext();
  if (target == OffscreenTarget::kEglSurfaceless) return CreateEglSurfacelessContext();
  auto osmesa = CreateOsMesaContext();
  if (osmesa) return osmesa;
  auto egl = CreateEglSurfacelessContext();
  if (egl) return egl;
  return Fail(ErrorCode::kGraphics,
              "no way to draw off screen: " + osmesa.error().message + "; " + egl.error().message,
              "install libosmesa6, or libegl1 and libgl1-mesa-dri");
}

Result<std::unique_ptr<OffscreenRenderer>> OffscreenRenderer::Create(OffscreenTarget target,
                                                                     int tile_side_px) {
  Result<std::unique_ptr<GlContext>> context = CreateOffscreenContext(target);
  if (!context) return Fail(context);
  Result<Gl> gl = [&]() -> Result<Gl> {
    const CurrentScope current(**context);
    if (!current.made()) return Fail(current.made());
    return LoadGl((*context)->Lookup(), (*context)->is_gles());
  }();
  if (!gl) return Fail(gl);
  auto renderer = std::make_unique<Offscreen>(std::move(*context), *gl, std::max(tile_side_px, 1));
  if (const Result<void> started = renderer->Start(); !started) return Fail(started);
  return renderer;
}

}  // namespace parti::render
