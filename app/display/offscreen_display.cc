#include "app/display/offscreen_display.h"

#include <sys/eventfd.h>
#include <unistd.h>

#include <mutex>

#include "base/check.h"
#include "render/gl_framebuffer.h"
#include "render/read_image.h"

namespace parti::app {
namespace {

using render::GlContext;
using render::GlFramebuffer;

/// What was asked for since the last Dispatch; the part that other threads reach.
struct Wishes {
  DisplayNews news;
  std::optional<glm::ivec2> size_px;
  std::optional<double> scale;
  std::optional<bool> visible;
  std::optional<std::vector<OutputPlace>> outputs;
  std::optional<Error> broken;
};

class MemoryDisplay final : public OffscreenDisplay {
 public:
  MemoryDisplay(std::unique_ptr<GlContext> context, const render::Gl& gl, const OffscreenSpec& spec)
      : context_(std::move(context)),
        gl_(gl),
        size_px_(spec.size_px),
        scale_(spec.scale),
        wake_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
    CHECK(wake_ >= 0, "the system has descriptors left");
  }
  ~MemoryDisplay() override {
    if (context_->MakeCurrent()) framebuffer_.reset();
    context_->Release();
    ::close(wake_);
  }

  GlContext& context() override { return *context_; }
  const render::Gl& gl() const override { return gl_; }
  glm::ivec2 size_px() const override { return size_px_; }
  double scale() const override { return scale_; }
  std::optional<Vec2> size_mm() const override { return std::nullopt; }
  std::vector<OutputPlace> outputs() const override { return outputs_; }
  void SetLeftHanded(bool left_handed) override { left_handed_ = left_handed; }
  bool left_handed() const override { return left_handed_; }
  bool shows_pointer() const override { return false; }
  std::string_view name() const override { return "offscreen"; }
  std::string Description() const override {
    return "a picture in memory, " + std::string(context_->name());
  }
  void SetTitle(const std::string&) override {}
  bool CanDraw() const override { return visible_; }
  Result<Target> BeginFrame() override;
  Result<void> Present(std::span<const render::PixelRect> damage) override;
  std::vector<int> fds() const override { return {wake_}; }
  bool HasNews() const override { return false; }
  Result<DisplayNews> Dispatch() override;

  void Inject(const InputEvent& event) override {
    Wish([&](Wishes* wishes) { wishes->news.input.push_back(event); });
  }
  void Resize(const glm::ivec2& size_px, double scale) override {
    CHECK(size_px.x > 0 && size_px.y > 0 && scale > 0, "a view has a size");
    Wish([&](Wishes* wishes) { wishes->size_px = size_px, wishes->scale = scale; });
  }
  void PlugOutputs(std::vector<OutputPlace> outputs) override {
    Wish([&](Wishes* wishes) { wishes->outputs = std::move(outputs); });
  }
  void AskToClose() override {
    Wish([](Wishes* wishes) { wishes->news.close_asked = true; });
  }
  void LoseFocus() override {
    Wish([](Wishes* wishes) { wishes->news.focus_lost = true; });
  }
  void SetVisible(bool visible) override {
    Wish([=](Wishes* wishes) { wishes->visible = visible; });
  }
  void Break(const Error& error) override {
    Wish([&](Wishes* wishes) { wishes->broken = error; });
  }

  Result<render::Image> ReadPixels() override;
  const std::vector<render::PixelRect>& presented() const override { return presented_; }
  int frames() const override { return frames_; }

  Result<void> MakeFramebuffer();

 private:
  template <typename Change>
  void Wish(const Change& change);

  std::unique_ptr<GlContext> context_;
  render::Gl gl_;
  std::optional<GlFramebuffer> framebuffer_;
  glm::ivec2 size_px_;
  double scale_;
  bool visible_ = true;
  bool left_handed_ = false;
  std::vector<OutputPlace> outputs_;
  bool fresh_ = true;  // nothing has been presented in the framebuffer
  std::vector<render::PixelRect> presented_;
  int frames_ = 0;

  int wake_;
  std::mutex mutex_;
  Wishes wishes_;
};

template <typename Change>
void MemoryDisplay::Wish(const Change& change) {
  const std::lock_guard lock(mutex_);
  change(&wishes_);
  const uint64_t one = 1;
  const auto written = ::write(wake_, &one, sizeof(one));
  CHECK(written == sizeof(one), "a counter of wishes takes one more");
}

Result<void> MemoryDisplay::MakeFramebuffer() {
  if (const auto made = context_->MakeCurrent(); !made) return Fail(made);
  framebuffer_.reset();
  Result<GlFramebuffer> made =
      GlFramebuffer::Create(gl_, {size_px_.x, size_px_.y, GL_RGBA8, 0, 0, false});
  if (!made) return Fail(made);
  framebuffer_ = std::move(*made);
  fresh_ = true;
  return {};
}

Result<Display::Target> MemoryDisplay::BeginFrame() {
  CHECK(CanDraw(), "frames are begun when they can be drawn");
  if (const auto made = context_->MakeCurrent(); !made) return Fail(made);
  if (!framebuffer_) return Fail(ErrorCode::kGraphics, "the picture in memory is lost");
  return Target{framebuffer_->id(), fresh_ ? 0 : 1};
}

Result<void> MemoryDisplay::Present(std::span<const render::PixelRect> damage) {
  presented_.assign(damage.begin(), damage.end());
  ++frames_;
  fresh_ = false;
  // As a screen would: a frame counts once it is done.
  gl_.Finish();
  return render::CheckGl(gl_, "drawing a frame");
}

Result<DisplayNews> MemoryDisplay::Dispatch() {
  Wishes wishes;
  {
    const std::lock_guard lock(mutex_);
    uint64_t count = 0;
    if (::read(wake_, &count, sizeof(count)) < 0) return DisplayNews{};
    std::swap(wishes, wishes_);
  }
  if (wishes.broken) return tl::unexpected(*wishes.broken);
  DisplayNews news = std::move(wishes.news);
  if (wishes.visible && *wishes.visible != visible_) {
    visible_ = *wishes.visible;
    (visible_ ? news.shown : news.hidden) = true;
  }
  if (wishes.outputs) {
    outputs_ = std::move(*wishes.outputs);
    news.resized = true;
  }
  if (wishes.size_px && (*wishes.size_px != size_px_ || *wishes.scale != scale_)) {
    size_px_ = *wishes.size_px;
    scale_ = *wishes.scale;
    news.resized = news.exposed = true;
    if (const auto made = MakeFramebuffer(); !made) return Fail(made);
  }
  return news;
}

Result<render::Image> MemoryDisplay::ReadPixels() {
  if (const auto made = context_->MakeCurrent(); !made) return Fail(made);
  if (!framebuffer_) return Fail(ErrorCode::kGraphics, "the picture in memory is lost");
  return render::ReadImage(gl_, framebuffer_->id(), size_px_);
}

}  // namespace

Result<std::unique_ptr<OffscreenDisplay>> OffscreenDisplay::Create(const OffscreenSpec& spec) {
  if (spec.size_px.x < 1 || spec.size_px.y < 1 || !(spec.scale > 0)) {
    return Fail(ErrorCode::kBadNumber, "a view needs a size of at least 1 x 1 px and a scale");
  }
  auto context = render::CreateOffscreenContext(spec.target);
  if (!context) return Fail(context);
  if (const auto made = (*context)->MakeCurrent(); !made) return Fail(made);
  const auto gl = render::LoadGl((*context)->Lookup(), (*context)->is_gles());
  if (!gl) return Fail(gl);
  auto display = std::make_unique<MemoryDisplay>(std::move(*context), *gl, spec);
  if (const auto made = display->MakeFramebuffer(); !made) return Fail(made);
  return display;
}

}  // namespace parti::app
