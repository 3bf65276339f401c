#include "app/replay.h"

#include <fmt/format.h>

#include <map>

#include "app/tablet_mapping.h"
#include "input/strokes_from_events.h"
#include "sketch/segmentation.h"

namespace parti::app {
namespace {

class Player {
 public:
  Player(const input::Drawing& drawing, Session* session, ReplayReport* report)
      : drawing_(drawing), session_(session), report_(report) {}

  Result<void> Play() {
    for (const InputEvent& event : drawing_.events) {
      if (const auto* device = std::get_if<DeviceEvent>(&event)) Meet(*device);
      // Commands keyed to the strokes drawn so far come before whatever the pen does next.
      if (const auto* pen = std::get_if<PenEvent>(&event); pen && IsContact(*pen)) {
        if (const auto run = RunCommands(); !run) return run;
      }
      if (const auto stroke = machine_.Feed(event)) Draw(*stroke);
    }
    for (const input::PenStroke& stroke : machine_.Finish()) Draw(stroke);
    return RunCommands();
  }

 private:
  static bool IsContact(const PenEvent& pen) { return pen.kind == PenEvent::Kind::kDown; }

  void Meet(const DeviceEvent& device) {
    if (device.kind == DeviceEvent::Kind::kAdded) devices_[device.device] = device.facts;
  }

  Result<void> RunCommands() {
    for (; next_ < drawing_.commands.size(); ++next_) {
      const input::DrawingCommand& line = drawing_.commands[next_];
      if (line.after_stroke > strokes_) return {};
      const auto done = Run(line.text);
      if (!done) {
        Error error = done.error();
        if (!line.place.line_text.empty()) error.place = line.place;  // read from a file
        return tl::unexpected<Error>(std::move(error));
      }
    }
    return {};
  }

  Result<void> Run(const std::string& text) {
    const auto command = ParseCommand(text);
    if (!command) return Fail(command);
    if (report_->before_command) {
      if (const auto noted = report_->before_command(*command); !noted) return noted;
    }
    return session_->Execute(*command);
  }

  void Draw(const input::PenStroke& stroke) {
    ++strokes_;
    if (stroke.tool == PenTool::kEraser || stroke.tool == PenTool::kMouse) return;
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

  const input::Drawing& drawing_;
  Session* session_;
  ReplayReport* report_;
  input::StrokesFromEvents machine_;
  std::map<int, DeviceFacts> devices_;
  size_t next_ = 0;  // command
  int strokes_ = 0;  // completed, erasers included: what commands are keyed to
};

}  // namespace

Result<void> Replay(const input::Drawing& drawing, Session* session, ReplayReport* report) {
  return Player(drawing, session, report).Play();
}

}  // namespace parti::app
