#include "app/display/x11_display.h"

#include <X11/Xlib.h>

#include <algorithm>

#include "app/display/frame_pace.h"
#include "base/check.h"
#include "input/x11_source.h"
#include "render/x11_window.h"

namespace parti::app {
namespace {

constexpr double kPxPerMm = 96 / 25.4;  ///< at scale 1, by definition of the scale

class X11Display final : public Display {
 public:
  X11Display(std::shared_ptr<render::X11Connection> connection,
             std::unique_ptr<render::X11Window> window, std::unique_ptr<input::X11Source> source,
             const render::Gl& gl, double least_frame_s)
      : connection_(std::move(connection)),
        window_(std::move(window)),
        source_(std::move(source)),
        gl_(gl),
        least_frame_s_(least_frame_s),
        renderer_(window_->context().Renderer()),
        first_news_(source_->Begin()) {}
  ~X11Display() override { window_->context().Release(); }

  render::GlContext& context() override { return window_->context(); }
  const render::Gl& gl() const override { return gl_; }
  glm::ivec2 size_px() const override { return window_->size_px(); }
  double scale() const override { return window_->scale(); }
  // Servers make the millimetres up from 96 px an inch.
  std::optional<Vec2> size_mm() const override { return std::nullopt; }
  void SetLeftHanded(bool) override {}  // the desktop's own settings do
  bool shows_pointer() const override { return true; }
  std::string_view name() const override { return "x11"; }
  std::string Description() const override {
    return "a window on " + connection_->name() + ", " + renderer_;
  }
  void SetTitle(const std::string& title) override {
    window_->SetTitle(title);
    XFlush(connection_->get());
  }
  bool CanDraw() const override { return window_->visible() && pace_.open(); }
  Result<Target> BeginFrame() override;
  Result<void> Present(std::span<const render::PixelRect> damage) override;
  std::vector<int> fds() const override {
    return {ConnectionNumber(connection_->get()), pace_.fd()};
  }
  bool HasNews() const override {
    return !first_news_.empty() || connection_->lost() ||
           XEventsQueued(connection_->get(), QueuedAlready) > 0;
  }
  Result<DisplayNews> Dispatch() override;

 private:
  void Take(XEvent* event, DisplayNews* news);

  std::shared_ptr<render::X11Connection> connection_;
  std::unique_ptr<render::X11Window> window_;
  std::unique_ptr<input::X11Source> source_;
  render::Gl gl_;
  double least_frame_s_;
  FramePace pace_;
  std::string renderer_;
  std::vector<InputEvent> first_news_;  // the devices that were there
};

Result<Display::Target> X11Display::BeginFrame() {
  CHECK(CanDraw(), "frames are begun when they can be drawn");
  if (const auto made = context().MakeCurrent(); !made) return Fail(made);
  return Target{0, window_->context().BufferAge()};
}

Result<void> X11Display::Present(std::span<const render::PixelRect> damage) {
  if (connection_->lost()) return tl::unexpected(connection_->WhyLost());
  pace_.CloseFor(least_frame_s_);
  const auto swapped = window_->context().Swap(damage, size_px().y);
  // Mesa's software driver leaves the picture in the connection's buffer.
  XFlush(connection_->get());
  return swapped;
}

void X11Display::Take(XEvent* event, DisplayNews* news) {
  const render::X11WindowNews window = window_->Take(*event);
  news->resized |= window.resized;
  news->exposed |= window.exposed;
  news->close_asked |= window.close_asked;
  news->focus_lost |= window.focus_lost;
  if (window.shown || window.hidden) {
    news->shown = window.shown;  // the last one counts
    news->hidden = window.hidden;
  }
  auto input = window.focus_lost ? source_->ReleaseKeys() : source_->Take(event);
  std::move(input.begin(), input.end(), std::back_inserter(news->input));
}

Result<DisplayNews> X11Display::Dispatch() {
  pace_.Look();
  DisplayNews news;
  std::swap(news.input, first_news_);
  while (!connection_->lost() && XPending(connection_->get()) > 0) {
    XEvent event{};
    XNextEvent(connection_->get(), &event);
    if (connection_->lost()) break;
    Take(&event, &news);
  }
  if (connection_->lost()) return tl::unexpected(connection_->WhyLost());
  return news;
}

}  // namespace

Result<std::unique_ptr<Display>> OpenX11Display(const X11Spec& spec) {
  auto connection = render::X11Connection::Open(spec.server);
  if (!connection) return Fail(connection);
  auto window = render::X11Window::Create(*connection, spec.size, spec.title);
  if (!window) return Fail(window);
  auto source = input::X11Source::Create((*connection)->get(), (*window)->id(),
                                         kPxPerMm * (*window)->scale());
  if (!source) return Fail(source);
  render::EglWindow& context = (*window)->context();
  if (const auto made = context.MakeCurrent(); !made) return Fail(made);
  const auto gl = render::LoadGl(context.Lookup(), context.is_gles());
  if (!gl) return Fail(gl);
  return std::make_unique<X11Display>(std::move(*connection), std::move(*window),
                                      std::move(*source), *gl, spec.least_frame_s);
}

}  // namespace parti::app
