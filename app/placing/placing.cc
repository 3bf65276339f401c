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
  const bool ours = posted_ > executed_;
  executed_ = executed;
  if (state_ && LooksAlike(*state_, *state)) return SeeWhetherDone();
  const bool other_rules = !state_ || state_->model.ground->source != state->model.ground->source;
  if (other_rules && !ours) Cancel();
  state_ = std::move(state);
  if (HasNone(*state_)) {
    Cancel();
    meant_.reset();
    held_.LetGo();
    wanted_.reset();
    found_ = {state_, nullptr};
  } else {
    worker_.Ask(state_);
  }
  SeeWhetherDone();
}

bool Placing::Update() {
  if (!worker_.ready().Clear()) return false;
  auto newest = worker_.newest();
  if (!newest || newest->state != state_) return false;
  found_ = std::move(*newest);
  meant_.reset();
  SeeWhetherDone();
  return true;
}

void Placing::Want(const PlacedLayers& before, size_t layer, const InteractiveLayer& now) {
  wanted_ = std::make_shared<const PlacedLayers>(PlacedWith(before, layer, now));
  posted_ = UINT64_MAX;
}

void Placing::SeeWhetherDone() {
  if (posted_ > executed_ || !UpToDate() || !wanted_) return;
  wanted_.reset();
  meant_.reset();
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
  if (!placed()) return {};
  auto begun = LayerDrag::Begin(placed(), view, drag.px, scale);
  if (!begun) return {};
  device_ = drag.device;
  drag_ = std::move(begun);
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
  step.command = ended->Outcome();
  if (step.command) Want(ended->placed(), ended->grip().layer, ended->snapped().layer);
  return step;
}

std::optional<PlaceElement> Placing::Do(ElementCommand command) {
  if (command == ElementCommand::kLetGo) held_.LetGo();
  const auto layer = placed() ? held_.In(*placed()) : std::nullopt;
  if (!layer || drag_) return std::nullopt;
  if (command == ElementCommand::kByNext) held_.TakeNext(*placed());
  const PlacedLayers before = *placed();
  const InteractiveLayer& now = before.layers[*layer].rules.layer;
  const InteractiveLayer then = Arranged(now, command, held_.ByIn(before));
  auto change = ChangeBetween(now, then);
  if (change) Want(before, *layer, then);
  return change;
}

void Placing::Await(uint64_t number) {
  posted_ = number;
  SeeWhetherDone();
}

bool Placing::Cancel() { return std::exchange(drag_, std::nullopt).has_value(); }

bool Placing::HoverAt(const Vec2& px, const View& view, double scale) {
  std::optional<LayerGrip> meant;
  if (placed()) meant = GripAt(*placed(), view, px, LayerDragParams().reach_px * scale);
  return !(std::exchange(meant_, meant) == meant);
}

bool Placing::HoverEnd() { return std::exchange(meant_, std::nullopt).has_value(); }

std::string Placing::word() const {
  if (drag_) return drag_->moved() ? drag_->Figures() : "";
  if (!meant_) return "";
  const std::string& name = placed()->layers[meant_->layer].rules.layer.name;
  if (meant_->handle.whole()) return name;
  const bool corner = meant_->handle.across != 0 && meant_->handle.up != 0;
  return (corner ? "corner of " : "edge of ") + name;
}

std::optional<ElementInHand> Placing::InHand(const View& view) const {
  const auto layer = placed() ? held_.In(*placed()) : std::nullopt;
  if (!layer || (drag_ && drag_->moved())) return std::nullopt;
  const InteractiveLayer by = held_.ByIn(*placed());
  ElementInHand element;
  element.layer = placed()->layers[*layer].rules.layer;
  element.by = by.name;
  element.by_others = LayersBeside(*placed(), *layer).size() > 1;
  element.changes = ChangesOf(*placed(), *layer, by);
  const SeenElement seen = SeenAs(placed()->layers[*layer].frame, element.layer, view);
  element.low_px = seen.low_px;
  element.high_px = seen.high_px;
  return element;
}

std::vector<SeenElement> Placing::Seen(const View& view) const {
  std::vector<SeenElement> seen;
  if (!placed()) return seen;
  for (const PlacedLayer& layer : placed()->layers) {
    SeenElement element = SeenAs(layer.frame, layer.rules.layer, view);
    if (!element.handles_px.empty()) seen.push_back(std::move(element));
  }
  return seen;
}

void Placing::AddMarks(const View& view, std::vector<render::Mark>* marks) const {
  if (drag_ && drag_->moved()) return AddLayerMarks(*drag_, view, marks);
  if (!placed()) return;
  LayersMeant meant{drag_ ? std::optional(drag_->grip()) : meant_, held_.In(*placed()), {}};
  if (meant.held) meant.by = held_.ByIn(*placed());
  AddLayerMarks(*placed(), meant, view, marks);
}

}  // namespace parti::app
