#include "app/play.h"

#include <chrono>

#include "input/pen_contacts.h"

namespace parti::app {
namespace {

using Clock = std::chrono::steady_clock;

Result<void> DoCommand(const input::DrawingCommand& line, Application* application) {
  const auto command = ParseCommand(line.text);
  if (!command) {
    Error error = command.error();
    if (!line.place.line_text.empty()) error.place = line.place;  // read from a file
    return tl::unexpected<Error>(std::move(error));
  }
  if (auto settled = Settle(application); !settled || application->close_asked()) return settled;
  application->Do(PanelCommand(*command));
  return Settle(application);
}

Result<void> PlayAll(const input::Drawing& drawing, Application* application) {
  input::PenContacts contacts;
  int strokes = 0;  // completed: what commands are keyed to
  auto next = drawing.commands.begin();
  const auto run_commands = [&]() -> Result<void> {
    for (; next != drawing.commands.end() && next->after_stroke <= strokes; ++next) {
      if (application->close_asked()) return {};
      if (auto done = DoCommand(*next, application); !done) return done;
    }
    return {};
  };
  for (const InputEvent& event : drawing.events) {
    if (application->close_asked()) return {};
    const auto* pen = std::get_if<PenEvent>(&event);
    if (pen && pen->kind == PenEvent::Kind::kDown) {
      if (auto done = run_commands(); !done) return done;
    }
    if (contacts.Feed(event).ended) ++strokes;
    application->Feed(event);
    if (auto turned = application->Turn(0); !turned) return turned;
  }
  strokes += static_cast<int>(contacts.down().size());
  for (const int device : contacts.down()) {
    PenEvent out;
    out.kind = PenEvent::Kind::kProximityOut;
    out.device = device;
    application->Feed(out);
  }
  if (auto settled = Settle(application); !settled) return settled;
  return run_commands();
}

}  // namespace

Result<void> Settle(Application* application, double most_s) {
  const auto end = Clock::now() + std::chrono::duration<double>(most_s);
  constexpr double kNap_s = 0.01;
  do {
    if (Clock::now() > end) {
      return Fail(ErrorCode::kLimitReached, "the application did not come to rest");
    }
    if (auto turned = application->Turn(kNap_s); !turned) return turned;
  } while (!application->Settled() && !application->close_asked());
  return {};
}

Result<void> Play(const input::Drawing& drawing, Application* application) {
  application->SetPlaying(true);
  auto played = PlayAll(drawing, application);
  application->SetPlaying(false);
  return played;
}

}  // namespace parti::app
