#include "app/placing/placing.h"

#include <utility>

#include "app/placing/layer_arranging.h"

namespace parti::app {
namespace {

using grammar::InteractiveLayer;
using input::DragPhase;

/// Whether the same can be placed in both: shapes, selection and rules are the same values.
bool LooksAlike(const SessionState& a, const SessionState& b) {
  return a.model.ground == b.model.ground && a.model.derived == b.model.derived &&
         a.selection.shapes == b.selection.shapes;
}

bool HasNone(const SessionState& state) {
  return state.selection.shapes.empty() || state.model.ground->source == nullptr;
}

PlacingStep Taken() {
  PlacingStep step;
  step.taken = true;
  return step;
}

}  // namespace

Placing::Found Placing::Finder::operator()(const State& state) {
  const Model& model = state->model;
  if (model.ground->source != source_) {
    source_ = model.ground->source;
    rules_ = RulesInReach(*source_);
  }
  return {state, std::make_shared<const PlacedLayers>(
                     PlacedLayersOf(model, state->selection.shapes, rules_))};
}

void Placing::SetState(State state, uint64_t executed) {
  executed_ = executed;
  if (state_ && LooksAlike(*state_, *state)) return LetGoOfLeft();
  const bool other_rules = !state_ || state_->model.ground->source != state->model.ground->source;
  if (other_rules) Cancel();
  state_ = std::move(state);
  if (HasNone(*state_)) {
    Cancel();
    meant_.reset();
    held_.LetGo();
    found_ = {state_, nullptr};
  } else {
    worker_.Ask(state_);
  }
  LetGoOfLeft();
}

bool Placing::Update() {
  if (!worker_.ready().Clear()) return false;
  auto newest = worker_.newest();
  if (!newest || newest->state != state_) return false;
  found_ = std::move(*newest);
  meant_.reset();
  LetGoOfLeft();
  return true;
}

void Placing::LetGoOfLeft() {
  if (!Waits()) left_.reset();
}

PlacingStep Placing::Take(const DragAct& drag, const View& view, double scale) {
  if (drag.phase == DragPhase::kBegin && !device_) return Begin(drag, view, scale);
  if (device_ != drag.device) return {};
  if (drag.phase == DragPhase::kMove) {
    if (drag_) drag_->MoveTo(view, drag.px);
    return Taken();
  }
  if (drag.phase == DragPhase::kCancel) Cancel();
  return End(drag, view);
}

PlacingStep Placing::Begin(const DragAct& drag, const View& view, double scale) {
  if (!found_.placed) return {};
  auto begun = LayerDrag::Begin(found_.placed, view, drag.px, scale);
  if (!begun) return {};
  device_ = drag.device;
  if (!Waits()) drag_ = std::move(begun);
  meant_.reset();
  return Taken();
}

PlacingStep Placing::End(const DragAct& drag, const View& view) {
  device_.reset();
  PlacingStep step = Taken();
  auto ended = std::exchange(drag_, std::nullopt);
  if (!ended) return step;
  ended->MoveTo(view, drag.px);
  step.tapped = !ended->moved();
  held_.Hold(ended->placed(), ended->grip().layer);
  if (auto file = ended->Outcome()) {
    step.command = SetRuleText{std::move(file->name), std::move(file->text)};
    left_ = std::move(ended);
    posted_ = UINT64_MAX;
  }
  return step;
}

std::optional<SetRuleText> Placing::Do(ElementCommand command) {
  if (command == ElementCommand::kLetGo) held_.LetGo();
  const auto layer = found_.placed ? held_.In(*found_.placed) : std::nullopt;
  if (!layer || drag_ || Waits()) return std::nullopt;
  if (command == ElementCommand::kByNext) held_.TakeNext(*found_.placed);
  auto file = FileWith(
      *found_.placed, *layer,
      Arranged(found_.placed->layers[*layer].rules.layer, command, held_.ByIn(*found_.placed)));
  if (!file) return std::nullopt;
  posted_ = UINT64_MAX;
  return SetRuleText{std::move(file->name), std::move(file->text)};
}

void Placing::Await(uint64_t number) {
  posted_ = number;
  LetGoOfLeft();
}

bool Placing::Cancel() { return std::exchange(drag_, std::nullopt).has_value(); }

bool Placing::HoverAt(const Vec2& px, const View& view, double scale) {
  std::optional<LayerGrip> meant;
  if (!Waits() && found_.placed)
    meant = GripAt(*found_.placed, view, px, LayerDragParams().reach_px * scale);
  return !(std::exchange(meant_, meant) == meant);
}

bool Placing::HoverEnd() { return std::exchange(meant_, std::nullopt).has_value(); }

std::string Placing::word() const {
  if (drag_) return drag_->moved() ? drag_->Figures() : "";
  if (!meant_) return "";
  const std::string& name = found_.placed->layers[meant_->layer].rules.layer.name;
  if (meant_->handle.whole()) return name;
  const bool corner = meant_->handle.across != 0 && meant_->handle.up != 0;
  return (corner ? "corner of " : "edge of ") + name;
}

std::optional<ElementInHand> Placing::InHand(const View& view) const {
  const auto layer = found_.placed ? held_.In(*found_.placed) : std::nullopt;
  if (!layer || (drag_ && drag_->moved())) return std::nullopt;
  const PlacedLayers& placed = *found_.placed;
  const InteractiveLayer by = held_.ByIn(placed);
  ElementInHand element;
  element.layer = left_ ? left_->LayerNow(*layer) : placed.layers[*layer].rules.layer;
  element.by = by.name;
  element.by_others = LayersBeside(placed, *layer).size() > 1;
  if (!Waits()) element.changes = ChangesOf(placed, *layer, by);
  const SeenElement seen = SeenAs(placed.layers[*layer].frame, element.layer, view);
  element.low_px = seen.low_px;
  element.high_px = seen.high_px;
  return element;
}

std::vector<SeenElement> Placing::Seen(const View& view) const {
  std::vector<SeenElement> seen;
  if (!found_.placed) return seen;
  for (const PlacedLayer& placed : found_.placed->layers) {
    SeenElement element = SeenAs(placed.frame, placed.rules.layer, view);
    if (!element.handles_px.empty()) seen.push_back(std::move(element));
  }
  return seen;
}

void Placing::AddMarks(const View& view, std::vector<render::Mark>* marks) const {
  if (drag_ && drag_->moved()) return AddLayerMarks(*drag_, view, marks);
  if (left_) return AddLayerMarks(*left_, view, marks);
  if (!found_.placed) return;
  LayersMeant meant{drag_ ? std::optional(drag_->grip()) : meant_, held_.In(*found_.placed), {}};
  if (meant.held) meant.by = held_.ByIn(*found_.placed);
  AddLayerMarks(*found_.placed, meant, view, marks);
}

}  // namespace parti::app
