#include "app/replay.h"

#include <fmt/format.h>

#include "app/tablet_mapping.h"
#include "sketch/segmentation.h"

namespace parti::app {

void Player::Feed(const InputEvent& event) {
  if (const auto* device = std::get_if<DeviceEvent>(&event)) {
    if (device->kind == DeviceEvent::Kind::kAdded) devices_[device->device] = device->facts;
  }
  // What a stroke does is settled as it begins, and asked for when it has ended.
  const auto stroke = machine_.Feed(event);
  const auto drags = bindings_.Feed(event);
  if (stroke) Draw(*stroke);
  for (const input::PenDrag& drag : drags) {
    if (drag.phase == input::DragPhase::kBegin) acts_[drag.event.device] = drag.act;
  }
}

Result<void> Player::Execute(const std::string& command) {
  const auto parsed = ParseCommand(command);
  if (!parsed) return Fail(parsed);
  if (report_->before_command) {
    if (const auto noted = report_->before_command(*parsed); !noted) return noted;
  }
  return session_->Execute(*parsed);
}

void Player::Finish() {
  for (const input::PenStroke& stroke : machine_.Finish()) Draw(stroke);
}

void Player::Draw(const input::PenStroke& stroke) {
  ++strokes_;
  const auto act = acts_.find(stroke.device);
  if (act == acts_.end() || act->second != input::PenAct::kDraw) return;
  const TabletMapping mapping(devices_[stroke.device], session_->state().camera);
  const Stroke in_view = mapping.ToView(stroke);
  ++report_->strokes;
  if (const auto s = sketch::SegmentStroke(in_view)) report_->segments += s->segments.size();
  if (const auto read = session_->AddStroke(in_view); !read) {
    Error error = read.error();
    error.message = fmt::format("stroke {}: {}", strokes_, error.message);
    report_->unread.push_back(std::move(error));
  }
}

namespace {

/// The commands that are keyed to the strokes completed so far, from number *next on.
Result<void> RunDue(const std::vector<input::DrawingCommand>& commands, Player* player,
                    size_t* next) {
  for (; *next < commands.size(); ++*next) {
    const input::DrawingCommand& line = commands[*next];
    if (line.after_stroke > player->strokes()) return {};
    const auto done = player->Execute(line.text);
    if (done) continue;
    Error error = done.error();
    if (!line.place.line_text.empty()) error.place = line.place;  // read from a file
    return tl::unexpected<Error>(std::move(error));
  }
  return {};
}

bool IsContact(const InputEvent& event) {
  const auto* pen = std::get_if<PenEvent>(&event);
  return pen != nullptr && pen->kind == PenEvent::Kind::kDown;
}

}  // namespace

Result<void> Replay(const input::Drawing& drawing, Session* session, ReplayReport* report) {
  Player player(session, report);
  size_t next = 0;
  for (const InputEvent& event : drawing.events) {
    // Commands keyed to the strokes drawn so far come before whatever the pen does next.
    if (IsContact(event)) {
      if (const auto run = RunDue(drawing.commands, &player, &next); !run) return run;
    }
    player.Feed(event);
  }
  player.Finish();
  return RunDue(drawing.commands, &player, &next);
}

}  // namespace parti::app
