#include "render/picture_maker.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace parti::render {
namespace {

/// The same view in fewer pixels.
Camera Smaller(const Camera& camera, int divisor) {
  Camera smaller = camera;
  const glm::ivec2 size = PictureSize(camera);
  smaller.width_px = std::max(1, size.x / divisor);
  smaller.height_px = std::max(1, size.y / divisor);
  return smaller;
}

FramebufferSpec PictureSpec(const glm::ivec2& size) {
  return {size.x, size.y, GL_SRGB8_ALPHA8, 0, 0, true};
}

}  // namespace

PictureMaker::PictureMaker(std::unique_ptr<GlContext> context, const Gl& gl,
                           const PainterParams& params)
    : context_(std::move(context)), gl_(gl), params_(params), pool_(std::make_shared<Pool>()) {}

Result<std::unique_ptr<PictureMaker>> PictureMaker::Create(std::unique_ptr<GlContext> context,
                                                           const PainterParams& params) {
  if (const auto made = context->MakeCurrent(); !made) return Fail(made);
  const Result<Gl> gl = LoadGl(context->Lookup(), context->is_gles());
  if (!gl) return Fail(gl);
  std::unique_ptr<PictureMaker> maker(new PictureMaker(std::move(context), *gl, params));
  Result<Renderer> renderer = Renderer::Create(maker->gl_);
  if (!renderer) return Fail(renderer);
  maker->renderer_.emplace(std::move(*renderer));
  const int side = params.tile_side_px;
  Result<GlFramebuffer> color =
      GlFramebuffer::Create(maker->gl_, {side, side, GL_SRGB8_ALPHA8, 0, 0, false});
  if (!color) return Fail(color);
  Result<GlFramebuffer> ids =
      GlFramebuffer::Create(maker->gl_, {side, side, GL_RGBA8, GL_DEPTH_COMPONENT24, 0, false});
  if (!ids) return Fail(ids);
  maker->tile_.emplace(TileTargets{std::move(*color), std::move(*ids)});
  return maker;
}

PictureMaker::~PictureMaker() {
  {
    const std::lock_guard lock(pool_->mutex);
    pool_->closed = true;
    pool_->free.clear();
  }
  loaded_.reset();
  tile_.reset();
  renderer_.reset();
  context_->Release();
}

Result<void> PictureMaker::Load(const std::shared_ptr<const Scene>& scene) {
  if (loaded_ && scene == scene_) return {};
  Result<LoadedScene> loaded = renderer_->Load(*scene, std::exchange(loaded_, std::nullopt));
  if (!loaded) return Fail(loaded);
  ++uploads_;
  scene_ = scene;
  loaded_.emplace(std::move(*loaded));
  return {};
}

/// A framebuffer that returns to the pool when the last picture lets go of it.
Result<std::shared_ptr<GlFramebuffer>> PictureMaker::Slot(const glm::ivec2& size) {
  std::optional<GlFramebuffer> slot;
  {
    const std::lock_guard lock(pool_->mutex);
    std::erase_if(pool_->free, [&](const GlFramebuffer& f) {
      // Two sizes are in use at a time, the fine and the coarse one; others are out of date.
      return pool_->free.size() > 4 && !(f.spec() == PictureSpec(size));
    });
    const auto fits = std::find_if(pool_->free.begin(), pool_->free.end(),
                                   [&](const auto& f) { return f.spec() == PictureSpec(size); });
    if (fits != pool_->free.end()) {
      slot.emplace(std::move(*fits));
      pool_->free.erase(fits);
    }
  }
  if (!slot) {
    Result<GlFramebuffer> made = GlFramebuffer::Create(gl_, PictureSpec(size));
    if (!made) return Fail(made);
    slot.emplace(std::move(*made));
  }
  const auto give_back = [pool = pool_](GlFramebuffer* used) {
    const std::lock_guard lock(pool->mutex);
    if (pool->closed) {
      used->Abandon();
    } else {
      pool->free.push_back(std::move(*used));
    }
    delete used;
  };
  return std::shared_ptr<GlFramebuffer>(new GlFramebuffer(std::move(*slot)), give_back);
}

Result<std::shared_ptr<const PaintedPicture>> PictureMaker::Make(
    const std::shared_ptr<const Scene>& scene, const Camera& camera, bool coarse,
    const std::function<bool()>& stop) {
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  if (const auto loaded = Load(scene); !loaded) return Fail(loaded);
  const Camera drawn = coarse ? Smaller(camera, params_.coarse_divisor) : camera;
  const glm::ivec2 size = PictureSize(drawn);
  const auto slot = Slot(size);
  if (!slot) return Fail(slot);
  auto picture = std::make_shared<PaintedPicture>();
  *picture = {(*slot)->color_texture(), size,     scene, camera, coarse, {},
              PictureCells::Of(size),   uploads_, *slot};
  picture->ids.resize(static_cast<size_t>(size.x) * size.y);
  const int side = params_.tile_side_px;
  for (int y = 0; y < size.y; y += side) {
    for (int x = 0; x < size.x; x += side) {
      if (stop()) return nullptr;
      const Tile tile{x, y, std::min(side, size.x - x), std::min(side, size.y - y)};
      if (auto done = DrawTile(drawn, tile, picture.get(), **slot); !done) return Fail(done);
    }
  }
  return picture;
}

Result<void> PictureMaker::DrawTile(const Camera& camera, const Tile& tile, PaintedPicture* picture,
                                    const GlFramebuffer& slot) {
  const Detail detail = picture->coarse ? Detail{false, 1.0 / params_.coarse_divisor} : Detail{};
  const auto drawn = renderer_->Draw(*loaded_, camera, tile, tile_->color.id(), detail);
  if (!drawn) return drawn;
  tile_->color.Bind();
  const std::vector<uint8_t> bytes = Read(tile);
  picture->cells.SetTile({tile.x, tile.y}, {tile.width, tile.height}, bytes.data());
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, slot.id());
  gl_.BlitFramebuffer(0, 0, tile.width, tile.height, tile.x, tile.y, tile.x + tile.width,
                      tile.y + tile.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.Finish();
  tile_->ids.Bind();
  if (const auto ids = renderer_->DrawIds(*loaded_, camera, tile); !ids) return ids;
  ReadIds(tile, picture);
  return CheckGl(gl_, "painting the model");
}

/// RGBA bytes of the bound framebuffer, rows from the bottom.
std::vector<uint8_t> PictureMaker::Read(const Tile& tile) const {
  std::vector<uint8_t> bytes(size_t{4} * tile.width * tile.height);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, tile.width, tile.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

void PictureMaker::ReadIds(const Tile& tile, PaintedPicture* picture) const {
  const std::vector<uint8_t> bytes = Read(tile);
  for (int y = 0; y < tile.height; ++y) {
    const size_t from_top = static_cast<size_t>(picture->size_px.y - 1 - tile.y - y);
    uint32_t* row = &picture->ids[from_top * picture->size_px.x + tile.x];
    const uint8_t* b = &bytes[size_t{4} * tile.width * y];
    for (int x = 0; x < tile.width; ++x, b += 4) {
      row[x] = b[0] | uint32_t{b[1]} << 8 | uint32_t{b[2]} << 16 | uint32_t{b[3]} << 24;
    }
  }
}

}  // namespace parti::render
