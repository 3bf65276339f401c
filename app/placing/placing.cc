#include "app/placing/placing.h"

#include <utility>

namespace parti::app {
namespace {

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
  if (left_ && left_request_ <= executed_ && UpToDate()) left_.reset();
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
  // What is seen is not what the model is by now: the hand has to wait for a moment.
  if (UpToDate() && !left_) drag_ = std::move(begun);
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
  if (auto file = ended->Outcome()) {
    step.command = SetRuleText{std::move(file->name), std::move(file->text)};
    left_ = std::move(ended);
    left_request_ = UINT64_MAX;
  }
  return step;
}

void Placing::Await(uint64_t number) {
  left_request_ = number;
  LetGoOfLeft();
}

bool Placing::Cancel() { return std::exchange(drag_, std::nullopt).has_value(); }

bool Placing::HoverAt(const Vec2& px, const View& view, double scale) {
  std::optional<LayerGrip> meant;
  const bool waits = !UpToDate() || left_ || !found_.placed;
  if (!waits) meant = GripAt(*found_.placed, view, px, LayerDragParams().reach_px * scale);
  return !(std::exchange(meant_, meant) == meant);
}

bool Placing::HoverEnd() { return std::exchange(meant_, std::nullopt).has_value(); }

std::string Placing::word() const {
  if (!meant_) return "";
  const std::string& name = found_.placed->layers[meant_->layer].rules.layer.name;
  if (meant_->handle.whole()) return name;
  const bool corner = meant_->handle.across != 0 && meant_->handle.up != 0;
  return (corner ? "corner of " : "edge of ") + name;
}

void Placing::AddMarks(const View& view, std::vector<render::Mark>* marks) const {
  if (drag_ && drag_->moved()) return AddLayerMarks(*drag_, view, marks);
  if (left_) return AddLayerMarks(*left_, view, marks);
  if (!found_.placed) return;
  const auto held = drag_ ? std::optional(drag_->grip()) : meant_;
  AddLayerMarks(*found_.placed, held, view, marks);
}

}  // namespace parti::app
