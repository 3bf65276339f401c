#include "app/panels/panels.h"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/drafts.h"
#include "app/panels/element_bar.h"
#include "app/panels/keyboard.h"
#include "app/panels/node_sheet.h"
#include "app/panels/queries.h"
#include "app/panels/rules_sheet.h"
#include "app/panels/sheet_keys.h"
#include "app/panels/sheets.h"
#include "app/panels/status.h"
#include "app/panels/suggestions.h"
#include "app/panels/tools.h"
#include "app/panels/ui.h"

namespace parti::app {

using namespace panels;  // NOLINT(google-build-using-namespace): its own parts

namespace {

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
  bool TypesOnScreen(const PanelEvent& event);
  void FeedKey(const KeyEvent& key);
  void ListFiles();
  void Once(double step_s);
  void DrawAll();
  void DrawColumn();
  bool keyboard_shown() const { return ui_.field_active() && !view_.has_keys; }
  void Obey();

  FontFiles files_;
  ImGuiHost host_;
  Ui ui_;
  Memory memory_;
  Sheet listed_for_ = Sheet::kNone;  ///< what was open in the last frame
  ScreenKeyboard keyboard_;
  Box keyboard_box_;
  bool keyboard_held_ = false;  ///< the pointer came down on it
  double scale_ = 0;
  double now_s_ = 0;
  bool took_key_ = false;  ///< a key of this frame was the panels'
  size_t obeyed_ = 0;      ///< commands that view_ already knows of
  PanelView view_;         ///< of this frame, with what its commands have changed
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
  took_key_ = false;
  view_ = view;
  view_.size_px = SaneSize(view.size_px);
  // Letters that can't be drawn at this scale are left at the one before.
  static_cast<void>(UseScale(SteadyScale(view_)));
  output_.reach_px = kMeasures.reach * scale_;
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
  output_.takes_keys = took_key_ || ui_.field_active();
  return output_;
}

void Panels::Parts::Feed(const PanelEvent& event) {
  if (TypesOnScreen(event)) return;
  if (const auto* key = std::get_if<KeyEvent>(&event)) return FeedKey(*key);
  host_.Feed(event);
}

/// Whether the event is the keyboard's on the screen: the field that it types into keeps the focus.
bool Panels::Parts::TypesOnScreen(const PanelEvent& event) {
  const auto* pointer = std::get_if<PanelPointer>(&event);
  const bool gone = std::holds_alternative<PanelPointerGone>(event);
  if (keyboard_held_ && (gone || (pointer && !pointer->down))) {
    keyboard_held_ = false;
    keyboard_.Release();
    return true;
  }
  if (!pointer || !keyboard_shown() || !keyboard_box_.Contains(pointer->px)) return keyboard_held_;
  if (!pointer->down || keyboard_held_) return true;
  keyboard_held_ = true;
  for (const KeyEvent& key : keyboard_.Press(pointer->px, keyboard_box_, scale_)) {
    FeedKey(key);
    Once(0);
  }
  return true;
}

void Panels::Parts::FeedKey(const KeyEvent& key) {
  if (key.repeat) {  // to a field each is a press of its own
    KeyEvent let_go = key;
    let_go.pressed = false;
    host_.Feed(let_go);
    Once(0);
  }
  host_.Feed(key);
  if (ui_.field_active() || !PressSheetKey(key, host_.control(), &memory_)) return ui_.FeedKey(key);
  took_key_ = true;
  if (key.code == KEY_ESC) ui_.LetGoOfFocus();  // it was in what has just closed
}

/// What has been opened and is about files is told what there is now, whoever opened it.
void Panels::Parts::ListFiles() {
  const Sheet before = std::exchange(listed_for_, memory_.open);
  if (memory_.open == before) return;
  for (const Sheet sheet : {Sheet::kDocument, Sheet::kOpen, Sheet::kSaveAs, Sheet::kExport}) {
    if (memory_.open == sheet) output_.commands.emplace_back(ListFolder{view_.files.folder});
  }
}

void Panels::Parts::Once(double step_s) {
  host_.NewFrame(view_.size_px, step_s);
  ui_.Begin(view_, scale_, &output_);
  DrawAll();
  ui_.End();
  output_.mesh = host_.Render(output_.sheets);
  took_key_ = took_key_ || ui_.took_key();
  ListFiles();
  Obey();
}

void Panels::Parts::DrawAll() {
  output_.preview.reset();
  Vec2 size = view_.size_px;
  if (keyboard_shown()) {
    const float height = ScreenKeyboard::Height(scale_);
    keyboard_box_ =
        BoxAt(0, static_cast<float>(size.y) - height, static_cast<float>(size.x), height);
    size.y = std::max(1.0, size.y - height);
  } else {
    keyboard_.Reset();
  }
  const bool left_handed = view_.settings.left_handed;
  LayoutNeeds needs{size, scale_, left_handed, memory_.rules_shown, kToolCount, kMenuCount};
  needs.bottom_px = StatusHeight(&ui_, memory_, LayoutOf(needs).bottom.width());
  memory_.layout = LayoutOf(needs);
  DrawHead(&ui_, &memory_);
  DrawTools(&ui_, memory_);
  if (!keyboard_shown()) DrawStatus(&ui_, &memory_);
  DrawColumn();
  output_.preview = DrawSuggestions(&ui_, &memory_);
  output_.query_preview = DrawQueries(&ui_, &memory_);
  DrawElementBar(&ui_, &memory_);
  DrawLeftDrafts(&ui_, &memory_);
  DrawOpenSheet(&ui_, &memory_);
  if (keyboard_shown()) keyboard_.Draw(&ui_, keyboard_box_);
  ui_.DrawPenWord();
}

/// The rules, and under them the node in hand.
void Panels::Parts::DrawColumn() {
  if (view_.session) memory_.typed_files.Settle(view_.session->state->model);
  const auto* node = NodeShown(view_, memory_);
  output_.node_shown = node != nullptr;
  if (!memory_.rules_shown) return;
  Box column = memory_.layout.rules;
  const float gap = ui_.U(8), rules = RulesHeight(&ui_, &memory_, column.width());
  if (!node) return DrawRules(&ui_, &memory_, column.CutTop(rules));
  const float wanted = NodeHeight(&ui_, *node, column.width());
  const float most = std::max(column.height() * 0.58f, column.height() - rules - gap);
  const float below = std::min(wanted, most);
  DrawRules(&ui_, &memory_, column.CutTop(std::min(rules, column.height() - below - gap), gap));
  DrawNode(&ui_, *node, column.CutTop(below));
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
