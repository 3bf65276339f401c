#include "app/display/kms_display.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <map>

#include "app/display/card.h"
#include "app/display/card_watch.h"
#include "app/display/console_keys.h"
#include "app/display/frame_pace.h"
#include "app/display/seat.h"
#include "app/display/wake_watch.h"
#include "base/check.h"
#include "input/eager_reader.h"
#include "input/libinput_source.h"
#include "render/kms_screen.h"

namespace parti::app {
namespace {

using render::KmsOutput;

constexpr double kRetry_s = 0.2;  ///< after the kernel refused a frame
constexpr int kMostRetries = 15;  ///< then the screen counts as lost

class KmsDisplay final : public Display {
 public:
  // In the order in which they need each other.
  KmsDisplay(KmsSpec spec, std::unique_ptr<Seat> seat, std::shared_ptr<std::string> denied,
             input::LibinputSource source, std::unique_ptr<Card> card,
             std::unique_ptr<render::KmsScreen> screen)
      : spec_(std::move(spec)),
        seat_(std::move(seat)),
        denied_(std::move(denied)),
        source_(std::move(source)),
        card_(std::move(card)),
        screen_(std::move(screen)) {}
  ~KmsDisplay() override { context().Release(); }

  Result<void> Start();

  render::GlContext& context() override { return screen_->context(); }
  const render::Gl& gl() const override { return gl_; }
  glm::ivec2 size_px() const override { return size_px_; }
  double scale() const override { return scale_; }
  std::optional<Vec2> size_mm() const override { return output_ ? output_->size_mm : std::nullopt; }
  std::vector<OutputPlace> outputs() const override;
  void SetLeftHanded(bool left_handed) override {
    reader_->Alone([&] { source_.SetLeftHanded(left_handed); });
  }
  bool shows_pointer() const override { return false; }
  std::string_view name() const override { return "kms"; }
  std::string Description() const override;
  void SetTitle(const std::string&) override {}
  bool CanDraw() const override {
    return seat_->active() && output_ && !screen_->flip_pending() && retry_.open();
  }
  Result<Target> BeginFrame() override;
  Result<void> Present(std::span<const render::PixelRect> damage) override;
  std::vector<int> fds() const override;
  bool HasNews() const override { return !first_news_.empty(); }
  Result<DisplayNews> Dispatch() override;

 private:
  Result<void> LookForScreens(bool anew, DisplayNews* news);
  Result<void> ChooseScreen(bool anew, DisplayNews* news);
  Result<void> TakeSeatNews(DisplayNews* news);
  Result<void> TakeInput(DisplayNews* news);
  void TakeDevice(const DeviceEvent& event);
  bool Swallows(const InputEvent& event, DisplayNews* news);
  std::vector<Vec2> Pens_mm() const;
  bool Visible() const { return seat_->active() && output_.has_value(); }

  KmsSpec spec_;
  std::unique_ptr<Seat> seat_;
  std::shared_ptr<const std::string> denied_;  // the first input device that may not be read
  input::LibinputSource source_;               // once there is a reader, only while it rests
  std::optional<input::EagerReader> reader_;
  std::unique_ptr<Card> card_;
  std::unique_ptr<render::KmsScreen> screen_;
  render::Gl gl_;
  std::string renderer_;
  std::vector<KmsOutput> outputs_;  // as they were read last
  std::optional<KmsOutput> output_;
  drmModeModeInfo mode_{};
  glm::ivec2 size_px_{1, 1};
  double scale_ = 1;
  CardWatch cards_;
  WakeWatch wake_;
  FramePace retry_;
  int retries_ = 0;
  ConsoleKeys console_keys_;
  std::map<int, Vec2> pens_mm_;  // areas of display tablets, by device
  bool pen_came_ = false;        // since the screen was chosen
  std::vector<InputEvent> first_news_;
};

Result<void> KmsDisplay::Start() {
  auto first = source_.Dispatch();
  if (!first) return Fail(first);
  // Without keys and without a pen there would be no way out again.
  if (source_.present() == 0 && !denied_->empty()) {
    return tl::unexpected(input::CannotOpen(*denied_, EACCES));
  }
  for (const InputEvent& event : *first) {
    if (const auto* device = std::get_if<DeviceEvent>(&event)) TakeDevice(*device);
  }
  first_news_ = std::move(*first);
  reader_.emplace(source_.fd(), [this] { return source_.Dispatch(); });
  if (const auto made = context().MakeCurrent(); !made) return made;
  const auto gl = render::LoadGl(context().Lookup(), context().is_gles());
  if (!gl) return Fail(gl);
  gl_ = *gl;
  renderer_ = screen_->context().Renderer();
  DisplayNews unused;
  if (const auto chosen = LookForScreens(false, &unused); !chosen) return chosen;
  if (!output_ && !spec_.output.empty()) {
    return Fail(ErrorCode::kDevice, fmt::format("no screen is plugged into {}", spec_.output),
                fmt::format("`ls /sys/class/drm` shows the sockets of {}", card_->path()));
  }
  if (!output_) {
    return Fail(ErrorCode::kDevice, fmt::format("no screen is plugged into {}", card_->path()),
                "plug one in and switch it on");
  }
  return {};
}

std::string KmsDisplay::Description() const {
  return fmt::format("the screen {} of {} ({} x {}), {}, {}", output_ ? output_->name : "(none)",
                     card_->path(), size_px_.x, size_px_.y, renderer_, seat_->Description());
}

std::vector<Vec2> KmsDisplay::Pens_mm() const {
  std::vector<Vec2> areas;
  for (const auto& [device, area] : pens_mm_) areas.push_back(area);
  return areas;
}

std::vector<OutputPlace> KmsDisplay::outputs() const {
  std::vector<OutputPlace> places;
  for (const KmsOutput& output : outputs_) {
    if (!output.connected) continue;
    OutputPlace place{output.size_mm, std::nullopt};
    const bool shown = output_ && output_->connector == output.connector;
    if (shown) place.in_view = ViewRect{{0, 0}, Vec2(size_px_)};
    places.push_back(place);
  }
  return places;
}

/// Looks which screens are there, which may take a while, and chooses among them.
Result<void> KmsDisplay::LookForScreens(bool anew, DisplayNews* news) {
  auto outputs = render::ReadKmsOutputs(card_->fd());
  if (!outputs) return Fail(outputs);
  const std::vector<OutputPlace> before = this->outputs();
  outputs_ = std::move(*outputs);
  const auto chosen = ChooseScreen(anew, news);
  news->resized |= this->outputs() != before;
  return chosen;
}

/// Goes to another screen, or another mode, where that is better.
/// anew: what is chosen already has to be set once more.
Result<void> KmsDisplay::ChooseScreen(bool anew, DisplayNews* news) {
  pen_came_ = false;
  const auto chosen = render::ChooseOutput(outputs_, spec_.output, Pens_mm());
  const auto mode = chosen ? render::ChooseMode(outputs_[*chosen]) : std::nullopt;
  if (!mode) {
    if (output_) screen_->Leave();
    output_.reset();
    return {};
  }
  const KmsOutput& output = outputs_[*chosen];
  const bool same = output_ && output_->connector == output.connector &&
                    mode->hdisplay == mode_.hdisplay && mode->vdisplay == mode_.vdisplay &&
                    mode->clock == mode_.clock;
  if (!same) {
    if (const auto used = screen_->Use(output, *mode); !used) return used;
    size_px_ = screen_->size_px();
    scale_ = render::ScaleOf(size_px_, output.size_mm);
    reader_->Alone([&] { source_.SetView(size_px_, scale_); });
    news->resized = true;
  }
  if (anew) screen_->SetModeAgain();
  output_ = output;
  mode_ = *mode;
  news->exposed |= anew || !same;
  return {};
}

Result<Display::Target> KmsDisplay::BeginFrame() {
  CHECK(CanDraw(), "frames are begun when they can be drawn");
  if (const auto made = context().MakeCurrent(); !made) return Fail(made);
  return Target{0, screen_->context().BufferAge()};
}

Result<void> KmsDisplay::Present(std::span<const render::PixelRect> damage) {
  const auto presented = screen_->Present(damage);
  if (presented) {
    retries_ = 0;
    return {};
  }
  if (presented.error().code != ErrorCode::kDevice || ++retries_ > kMostRetries) return presented;
  // Most often the seat is on its way to another console, and its word for it is not here yet.
  retry_.CloseFor(kRetry_s);
  return {};
}

std::vector<int> KmsDisplay::fds() const {
  std::vector<int> all = {seat_->fd(), reader_->fd(), card_->fd(), wake_.fd(), retry_.fd()};
  if (cards_.fd() >= 0) all.push_back(cards_.fd());
  return all;
}

Result<void> KmsDisplay::TakeSeatNews(DisplayNews* news) {
  const auto seat = seat_->Dispatch();
  if (!seat) return Fail(seat);
  if (seat->pause_asked) {
    screen_->Settle();
    reader_->Alone([&] { source_.Suspend(); });
    seat_->ConfirmPause();
    console_keys_.Forget();
    news->focus_lost = true;
  }
  if (seat->resumed) {
    const auto resumed = reader_->Alone([&] { return source_.Resume(); });
    if (!resumed) return resumed;
    retries_ = 0;
    return LookForScreens(true, news);
  }
  return {};
}

void KmsDisplay::TakeDevice(const DeviceEvent& event) {
  if (event.kind == DeviceEvent::Kind::kRemoved) {
    pens_mm_.erase(event.device);
  } else if (event.facts.has_pen && event.facts.has_display && event.facts.size_mm) {
    // An opaque tablet has no screen, though one may be of its size.
    pens_mm_[event.device] = *event.facts.size_mm;
    pen_came_ = true;
  }
}

/// Keys that are the console's are not the program's.
bool KmsDisplay::Swallows(const InputEvent& event, DisplayNews* news) {
  if (const auto* device = std::get_if<DeviceEvent>(&event)) TakeDevice(*device);
  const auto* key = std::get_if<KeyEvent>(&event);
  const auto wish = key ? console_keys_.Feed(*key) : std::nullopt;
  if (!wish) return false;
  news->close_asked |= wish->end;
  if (wish->console) seat_->SwitchTo(*wish->console);
  return true;
}

Result<void> KmsDisplay::TakeInput(DisplayNews* news) {
  auto events = reader_->Take();
  if (!events) return Fail(events);
  for (InputEvent& event : *events) {
    if (!Swallows(event, news)) news->input.push_back(std::move(event));
  }
  return {};
}

Result<DisplayNews> KmsDisplay::Dispatch() {
  DisplayNews news;
  std::swap(news.input, first_news_);
  const bool was_visible = Visible();
  if (seat_->active()) screen_->HandleEvents();
  if (const auto seat = TakeSeatNews(&news); !seat) return Fail(seat);
  // After the seat's: devices that go and come with it are told at once.
  if (const auto input = TakeInput(&news); !input) return Fail(input);
  if (retry_.Look()) {
    screen_->SetModeAgain();
    news.exposed = true;
  }
  const bool slept = wake_.Look();
  const auto plugged = cards_.Look(output_ ? output_->connector : 0);
  if (seat_->active() && (slept || plugged != CardWatch::News::kNone)) {
    // A screen that was switched off and on says no more than that something happened.
    const bool anew = slept || plugged == CardWatch::News::kPerhapsOurs;
    if (const auto chosen = LookForScreens(anew, &news); !chosen) return Fail(chosen);
  } else if (seat_->active() && pen_came_) {
    // A display tablet tells its screen and its pen one after the other.
    if (const auto chosen = ChooseScreen(false, &news); !chosen) return Fail(chosen);
  }
  news.shown = !was_visible && Visible();
  news.hidden = was_visible && !Visible();
  news.exposed |= news.shown;
  return news;
}

}  // namespace

Result<std::unique_ptr<Display>> OpenKmsDisplay(const KmsSpec& spec) {
  // Before a console is taken over for nothing.
  if (const auto cards = CardPaths(); !cards) return Fail(cards);
  auto seat = OpenSeat();
  if (!seat) return Fail(seat);
  Seat* opener = seat->get();
  auto card = OpenCard(opener, spec.card);
  if (!card) return Fail(card);
  const auto denied = std::make_shared<std::string>();
  input::LibinputOptions options;
  options.opener = {[opener, denied](const char* node, int) {
                      const int fd = opener->Open(node);
                      if ((fd == -EACCES || fd == -EPERM) && denied->empty()) *denied = node;
                      return fd;
                    },
                    [opener](int fd) { opener->Close(fd); }};
  options.mice_and_keys = true;
  auto source = input::LibinputSource::OpenSeat(opener->name(), options);
  if (!source) return Fail(source);
  auto screen = render::KmsScreen::Create((*card)->fd());
  if (!screen) return Fail(screen);
  auto display = std::make_unique<KmsDisplay>(spec, std::move(*seat), denied, std::move(*source),
                                              std::move(*card), std::move(*screen));
  if (const auto started = display->Start(); !started) return Fail(started);
  return display;
}

}  // namespace parti::app
