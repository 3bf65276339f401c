#include "app/session.h"

#include "app/session_commands.h"
#include "app/session_record.h"

namespace parti::app {
namespace {

SessionState StateOf(Model model, const Camera& camera) {
  SessionState state;
  state.model = std::move(model);
  state.camera = camera;
  return state;
}

}  // namespace

Session::Session(SessionOptions options) : Session(Model(), Camera(), options) {}

Session::Session(Model model, const Camera& camera, SessionOptions options)
    : options_(options), timeline_(StateOf(std::move(model), camera), options.undo) {}

Session::Session(Timeline timeline, uint32_t strokes_drawn, SessionOptions options)
    : options_(options), timeline_(std::move(timeline)), strokes_drawn_(strokes_drawn) {}

Result<void> Session::AddStroke(const Stroke& stroke) {
  const auto drawn =
      std::make_shared<const DrawnStroke>(DrawnStroke{stroke, state().camera, strokes_drawn_++});
  history_.push_back({drawn, std::nullopt});
  StrokeOutcome outcome = AfterStroke(state(), drawn, options_);
  if (outcome.begun) history_.push_back({nullptr, *outcome.begun});
  timeline_.Change(std::move(outcome.state));
  return outcome.read;
}

Result<void> Session::Execute(const Command& command) {
  const bool undo = std::holds_alternative<Undo>(command);
  if (undo || std::holds_alternative<Redo>(command)) {
    if (const auto done = StepTo(undo); !done) return done;
  } else {
    auto next = After(state(), command, options_);
    if (!next) return Fail(next);
    if (IsLooking(command)) {
      timeline_.Look(std::move(*next));
    } else {
      timeline_.Change(std::move(*next));
    }
  }
  history_.push_back({nullptr, command});
  return {};
}

Result<void> Session::StepTo(bool back) {
  const Timeline::Span span = timeline_.span();
  if (span.now == (back ? span.first : span.last)) {
    return Fail(ErrorCode::kNothingMade, back ? "nothing to undo" : "nothing to redo");
  }
  const uint64_t number = back ? span.now - 1 : span.now + 1;
  const TimelineStep& step = timeline_.step(number);
  auto state = step.state ? Result<SessionState>(*step.state)
                          : Restore(step.record, options_, &timeline_.present().model);
  if (!state) return Fail(state);
  state->camera = timeline_.present().camera;
  timeline_.GoTo(number, std::move(*state));
  return {};
}

}  // namespace parti::app
