#include "app/document_report.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>

#include "base/text_file.h"

namespace parti::app {
namespace {

constexpr double kPause_s = 0.5;

DeviceFacts RecordedPen() {
  DeviceFacts facts;
  facts.name = "Parti document";
  facts.has_pen = true;
  facts.has_pressure = true;
  facts.view_px_per_mm = 1;
  return facts;
}

/// Turns strokes back into the events of a pen, one after the other.
class PenEvents {
 public:
  explicit PenEvents(std::vector<InputEvent>* events) : events_(events) {
    events_->push_back(DeviceEvent{DeviceEvent::Kind::kAdded, 0, 0, RecordedPen()});
  }

  /// Times stay as they are where they can, and are moved by whole seconds where they can't: the
  /// differences between them are evidence, and must not be rounded.
  void Draw(const Stroke& stroke) {
    const double earliest = last_s_ + kPause_s;
    const double begins = stroke.front().t_s;
    const double shift = begins >= last_s_ ? 0 : std::ceil(earliest - begins);
    PenEvent event;
    for (const StrokeSample& sample : stroke) {
      event.kind = &sample == &stroke.front() ? PenEvent::Kind::kDown : PenEvent::Kind::kMotion;
      event.t_s = std::max(sample.t_s + shift, last_s_);
      event.position_mm = sample.position;
      event.pressure = sample.pressure;
      Add(event);
    }
    event.kind = PenEvent::Kind::kUp;
    Add(event);
  }

 private:
  void Add(const PenEvent& event) {
    last_s_ = event.t_s;
    events_->push_back(event);
  }

  std::vector<InputEvent>* events_;
  double last_s_ = 0;
};

/// Rules may be typed on several lines; a drawing's commands are one each.
std::string OneLine(std::string line) {
  for (char& c : line) {
    if (c == '\n' || c == '\r' || c == '\0') c = ' ';
  }
  return line;
}

/// N of "stroke N".
std::optional<uint32_t> StrokeNumber(std::string_view line) {
  constexpr std::string_view kStroke = "stroke ";
  if (line.substr(0, kStroke.size()) != kStroke) return std::nullopt;
  uint32_t number = 0;
  std::from_chars(line.data() + kStroke.size(), line.data() + line.size(), number);
  return number;
}

}  // namespace

Result<input::Drawing> DrawingOf(const Document& document) {
  if (document.history.empty()) {
    return Fail(ErrorCode::kNothingMade, "nothing has been done in this document yet");
  }
  std::map<uint32_t, const DrawnStroke*> strokes;
  for (const auto& drawn : document.strokes) strokes[drawn->number] = drawn.get();
  input::Drawing drawing;
  PenEvents pen(&drawing.events);
  int drawn = 0;
  for (const std::string& line : document.history) {
    const auto number = StrokeNumber(line);
    if (!number) {
      drawing.commands.push_back({drawn, OneLine(line)});
      continue;
    }
    const auto found = strokes.find(*number);
    if (found == strokes.end()) {
      return Fail(ErrorCode::kDamagedFile, fmt::format("stroke {} is missing", *number));
    }
    if (found->second->stroke.empty()) continue;
    pen.Draw(found->second->stroke);
    ++drawn;
  }
  return drawing;
}

Result<void> WriteReport(const Document& document, const std::string& path) {
  const auto drawing = DrawingOf(document);
  if (!drawing) return Fail(drawing);
  const auto text = input::WriteDrawing(*drawing);
  if (!text) return Fail(text);
  return WriteFile(path, *text);
}

}  // namespace parti::app
