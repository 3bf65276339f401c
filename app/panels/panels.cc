#include "app/panels/panels.h"

#include <algorithm>
#include <cmath>

#include "app/panels/status.h"
#include "app/panels/suggestions.h"
#include "app/panels/tools.h"
#include "app/panels/ui.h"

namespace parti::app {

using namespace panels;  // NOLINT(google-build-using-namespace): its own parts

namespace {

/// What tells one view from the next while the pen draws.
struct Seen {
  std::shared_ptr<const SessionSnapshot> session;
  Vec2 size_px{0, 0};
  bool pen_down = false;
};

/// Scales are rounded, so that dragging a window's edge does not draw the letters anew all the way.
double SteadyScale(const PanelView& view) {
  return std::max(0.25, std::floor(UsedScale(view.scale, view.size_px) * 8) / 8);
}

Vec2 SaneSize(const Vec2& size_px) {
  const auto sane = [](double v) { return v >= 1 ? std::min(v, 1e5) : 1; };  // NaN: 1
  return {sane(size_px.x), sane(size_px.y)};
}

/// Motions between which nothing else happened: only where they end matters.
bool IsPassedOver(const std::vector<PanelEvent>& events, size_t i) {
  if (i + 1 == events.size()) return false;
  const auto* now = std::get_if<PanelPointer>(&events[i]);
  const auto* next = std::get_if<PanelPointer>(&events[i + 1]);
  const auto* before = i > 0 ? std::get_if<PanelPointer>(&events[i - 1]) : nullptr;
  return now && next && before && before->down == now->down && now->down == next->down;
}

}  // namespace

class Panels::Parts {
 public:
  explicit Parts(FontFiles files) : files_(std::move(files)), ui_(&host_) {}

  const PanelOutput& Frame(const PanelView& view, const PanelInput& input);
  Result<void> UseScale(double scale);

 private:
  void Feed(const PanelEvent& event);
  void Once(double step_s);
  void DrawAll();
  void Obey();

  FontFiles files_;
  ImGuiHost host_;
  Ui ui_;
  Memory memory_;
  double scale_ = 0;
  double now_s_ = 0;
  size_t obeyed_ = 0;  ///< commands that view_ already knows of
  PanelView view_;     ///< of this frame, with what its commands have changed
  Seen seen_;
  PanelOutput output_;
};

Result<void> Panels::Parts::UseScale(double scale) {
  if (scale == scale_) return {};
  auto letters = panels::DrawLetters(files_, scale);
  if (!letters) return Fail(letters);
  output_.letters = letters->picture;
  host_.SetLetters(std::move(*letters));
  scale_ = scale;
  return {};
}

const PanelOutput& Panels::Parts::Frame(const PanelView& view, const PanelInput& input) {
  output_.commands.clear();
  obeyed_ = 0;
  output_.changed = false;
  const bool drawing = seen_.pen_down && view.pen.down && input.events.empty();
  const bool same = seen_.session == view.session && seen_.size_px == view.size_px;
  if (drawing && same && !ui_.WouldStepAside(view.pen)) return output_;
  seen_ = {view.session, view.size_px, view.pen.down};

  view_ = view;
  view_.size_px = SaneSize(view.size_px);
  // Letters that can't be drawn at this scale are left at the one before.
  static_cast<void>(UseScale(SteadyScale(view_)));
  if (view_.pen.down && !ui_.field_active()) memory_.open = Sheet::kNone;
  const double step_s = input.now_s - now_s_;
  now_s_ = input.now_s;
  render::UiMesh before = std::move(output_.mesh);
  for (size_t i = 0; i < input.events.size(); ++i) {
    if (IsPassedOver(input.events, i)) continue;
    Feed(input.events[i]);
    Once(step_s);
  }
  if (input.events.empty()) Once(step_s);
  // What was pressed changes what is shown; a few frames later all has come to rest.
  for (int i = 0; i < 4 && ui_.touched(); ++i) Once(0);
  output_.changed = !(output_.mesh == before);
  output_.takes_pointer = ui_.pointer_over();
  output_.focus = ui_.focus();
  output_.takes_keys = ui_.field_active();
  return output_;
}

void Panels::Parts::Feed(const PanelEvent& event) {
  const auto* key = std::get_if<KeyEvent>(&event);
  if (key && key->repeat) {  // to the fields each is a press of its own
    KeyEvent let_go = *key;
    let_go.pressed = false;
    host_.Feed(let_go);
    Once(0);
  }
  host_.Feed(event);
  if (key) ui_.FeedKey(*key);
}

void Panels::Parts::Once(double step_s) {
  host_.NewFrame(view_.size_px, step_s);
  ui_.Begin(view_, scale_, &output_);
  DrawAll();
  ui_.End();
  output_.mesh = host_.Render();
  Obey();
}

void Panels::Parts::DrawAll() {
  output_.preview.reset();
  LayoutNeeds needs{view_.size_px,       scale_,     view_.settings.left_handed,
                    memory_.rules_shown, kToolCount, kMenuCount};
  needs.bottom_px = StatusHeight(&ui_, memory_, LayoutOf(needs).bottom.width());
  memory_.layout = LayoutOf(needs);
  DrawHead(&ui_, &memory_);
  DrawTools(&ui_, memory_);
  DrawStatus(&ui_, &memory_);
  output_.preview = DrawSuggestions(&ui_, memory_);
}

/// What a command changed is seen by the next press of the same frame.
void Panels::Parts::Obey() {
  for (; obeyed_ < output_.commands.size(); ++obeyed_) {
    const PanelCommand& command = output_.commands[obeyed_];
    if (const auto* settings = std::get_if<Settings>(&command)) view_.settings = *settings;
    if (const auto* mode = std::get_if<PointerMode>(&command)) view_.mode = *mode;
  }
}

Panels::Panels(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Panels::~Panels() = default;

Result<std::unique_ptr<Panels>> Panels::Create() {
  auto files = FindFont();
  if (!files) return Fail(files);
  auto parts = std::make_unique<Parts>(std::move(*files));
  if (const auto drawn = parts->UseScale(1); !drawn) return Fail(drawn);
  return std::unique_ptr<Panels>(new Panels(std::move(parts)));
}

const PanelOutput& Panels::Frame(const PanelView& view, const PanelInput& input) {
  return parts_->Frame(view, input);
}

}  // namespace parti::app
