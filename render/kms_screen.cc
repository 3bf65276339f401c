#include "render/kms_screen.h"

#include <EGL/eglext.h>
#include <fmt/format.h>
#include <gbm.h>
#include <poll.h>
#include <xf86drm.h>

#include <cerrno>
#include <cstring>

namespace parti::render {
namespace {

constexpr uint32_t kFormat = GBM_FORMAT_XRGB8888;  ///< every driver can show it
constexpr uint32_t kDepth = 24, kBitsPerPixel = 32;
constexpr int kSettle_ms = 100;  ///< several pictures of the slowest screen

/// The kernel's number for a page, made when the page is first shown and kept with it.
struct Page {
  int card = -1;
  uint32_t framebuffer = 0;
};

void ForgetPage(gbm_bo*, void* data) {
  const std::unique_ptr<Page> page(static_cast<Page*>(data));
  drmModeRmFB(page->card, page->framebuffer);
}

/// 0 where the kernel can't show it.
uint32_t FramebufferOf(int card, gbm_bo* buffer) {
  if (const auto* page = static_cast<Page*>(gbm_bo_get_user_data(buffer))) return page->framebuffer;
  uint32_t framebuffer = 0;
  const int failed =
      drmModeAddFB(card, gbm_bo_get_width(buffer), gbm_bo_get_height(buffer), kDepth, kBitsPerPixel,
                   gbm_bo_get_stride(buffer), gbm_bo_get_handle(buffer).u32, &framebuffer);
  if (failed != 0) return 0;
  gbm_bo_set_user_data(buffer, new Page{card, framebuffer}, ForgetPage);
  return framebuffer;
}

struct DestroySurface {
  void operator()(gbm_surface* surface) const { gbm_surface_destroy(surface); }
};

class Screen final : public KmsScreen {
 public:
  Screen(int card, std::shared_ptr<gbm_device> device, std::unique_ptr<EglWindow> context)
      : card_(card), device_(std::move(device)), context_(std::move(context)) {}
  ~Screen() override { Screen::Leave(); }

  EglWindow& context() override { return *context_; }
  Result<void> Use(const KmsOutput& output, const drmModeModeInfo& mode) override;
  void Leave() override;
  void SetModeAgain() override { mode_is_set_ = false; }
  glm::ivec2 size_px() const override {
    return pages_ ? glm::ivec2(mode_.hdisplay, mode_.vdisplay) : glm::ivec2(0);
  }
  bool flip_pending() const override { return next_ != nullptr; }
  Result<void> Present(std::span<const PixelRect> damage) override;
  void HandleEvents() override;
  void Settle() override;

 private:
  static void NoteFlip(int, unsigned, unsigned, unsigned, void* self) {
    auto* screen = static_cast<Screen*>(self);
    if (screen->next_) screen->Show(std::exchange(screen->next_, nullptr));
  }
  void Show(gbm_bo* page);
  int SetMode(uint32_t framebuffer);

  int card_;
  std::shared_ptr<gbm_device> device_;
  std::unique_ptr<EglWindow> context_;
  std::unique_ptr<gbm_surface, DestroySurface> pages_;
  uint32_t connector_ = 0;
  uint32_t crtc_ = 0;
  drmModeModeInfo mode_{};
  bool mode_is_set_ = false;
  bool can_flip_ = true;
  gbm_bo* shown_ = nullptr;
  gbm_bo* next_ = nullptr;  // shown once its flip is done
};

Result<void> Screen::Use(const KmsOutput& output, const drmModeModeInfo& mode) {
  Leave();
  std::unique_ptr<gbm_surface, DestroySurface> pages(
      gbm_surface_create(device_.get(), mode.hdisplay, mode.vdisplay, kFormat,
                         GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
  if (!pages) {
    return Fail(ErrorCode::kGraphics, fmt::format("the driver makes no pages of {} x {} px for {}",
                                                  mode.hdisplay, mode.vdisplay, output.name));
  }
  if (const auto set = context_->SetWindow(pages.get()); !set) return set;
  pages_ = std::move(pages);
  connector_ = output.connector;
  crtc_ = output.crtcs.front();
  mode_ = mode;
  mode_is_set_ = false;
  can_flip_ = true;
  return {};
}

void Screen::Leave() {
  if (!pages_) return;
  Settle();
  // The page that is shown goes with its surface, and a screen whose page goes turns dark.
  if (const auto left = context_->SetWindow(nullptr); !left) context_->Release();
  for (gbm_bo* page : {shown_, next_}) {
    if (page) gbm_surface_release_buffer(pages_.get(), page);
  }
  shown_ = next_ = nullptr;
  pages_.reset();
}

void Screen::Show(gbm_bo* page) {
  if (shown_) gbm_surface_release_buffer(pages_.get(), shown_);
  shown_ = page;
}

/// 0, or a negative errno value.
int Screen::SetMode(uint32_t framebuffer) {
  drmModeSetCursor(card_, crtc_, 0, 0, 0);  // another program may have left its own
  return drmModeSetCrtc(card_, crtc_, framebuffer, 0, 0, &connector_, 1, &mode_);
}

Result<void> Screen::Present(std::span<const PixelRect> damage) {
  if (const auto swapped = context_->Swap(damage, mode_.vdisplay); !swapped) return swapped;
  gbm_bo* page = gbm_surface_lock_front_buffer(pages_.get());
  const uint32_t framebuffer = page ? FramebufferOf(card_, page) : 0;
  if (framebuffer == 0) {
    if (page) gbm_surface_release_buffer(pages_.get(), page);
    return Fail(ErrorCode::kGraphics, "the kernel can't show what was drawn");
  }
  int failed = 0;
  if (mode_is_set_ && can_flip_) {
    failed = drmModePageFlip(card_, crtc_, framebuffer, DRM_MODE_PAGE_FLIP_EVENT, this);
    if (failed == 0) {
      next_ = page;
      return {};
    }
    can_flip_ = failed != -EINVAL;  // some drivers can't, ever
  }
  // Waits for the screen, and has no event to wait for afterwards.
  failed = SetMode(framebuffer);
  mode_is_set_ = failed == 0;
  if (failed != 0) {
    gbm_surface_release_buffer(pages_.get(), page);
    return Fail(ErrorCode::kDevice,
                fmt::format("the screen can't be set to {} x {} px: {}", mode_.hdisplay,
                            mode_.vdisplay, std::strerror(-failed)),
                failed == -EACCES ? "another program drives the screen: end it" : "");
  }
  Show(page);
  return {};
}

void Screen::HandleEvents() {
  drmEventContext handlers{};
  handlers.version = 2;
  handlers.page_flip_handler = NoteFlip;
  pollfd waiting{card_, POLLIN, 0};
  if (::poll(&waiting, 1, 0) > 0) drmHandleEvent(card_, &handlers);
}

void Screen::Settle() {
  pollfd waiting{card_, POLLIN, 0};
  for (int tries = 0; next_ && tries < 2; ++tries) {
    if (::poll(&waiting, 1, kSettle_ms / 2) > 0) HandleEvents();
  }
  if (next_) Show(std::exchange(next_, nullptr));
}

}  // namespace

Result<std::unique_ptr<KmsScreen>> KmsScreen::Create(int card_fd) {
  std::shared_ptr<gbm_device> device(gbm_create_device(card_fd), [](gbm_device* made) {
    if (made) gbm_device_destroy(made);
  });
  if (!device) {
    return Fail(ErrorCode::kGraphics, "the graphics driver has no GBM",
                "install libgbm1 and libgl1-mesa-dri, or the driver of the graphics card");
  }
  auto context =
      EglWindow::Create({EGL_PLATFORM_GBM_KHR, device, static_cast<EGLint>(kFormat), "the screen"});
  if (!context) return Fail(context);
  return std::make_unique<Screen>(card_fd, std::move(device), std::move(*context));
}

}  // namespace parti::render
