#include "input/drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "input/event_text.h"

namespace parti::input {
namespace {

Result<void> Misplaced(const DrawingCommand& command) {
  return Fail(ErrorCode::kBadNumber,
              fmt::format("no place for the command after stroke {}", command.after_stroke),
              "commands go in the order of their strokes, and never after more than there are");
}

}  // namespace

bool operator==(const Drawing& a, const Drawing& b) {
  const auto same = [](const DrawingCommand& x, const DrawingCommand& y) {
    return x.after_stroke == y.after_stroke && x.text == y.text;
  };
  return a.events == b.events && std::equal(a.commands.begin(), a.commands.end(),
                                            b.commands.begin(), b.commands.end(), same);
}

std::string DrawingWriter::Begin() { return "parti-drawing 1\n"; }

std::string DrawingWriter::End() { return "end\n"; }

Result<std::string> DrawingWriter::Add(const InputEvent& event) {
  if (const auto fine = rules_.Take(event); !fine) return Fail(fine);
  return EventText(event) + '\n';
}

Result<std::string> DrawingWriter::AddCommand(std::string_view text) {
  if (const auto fine = rules_.TakeCommand(rules_.strokes(), text); !fine) return Fail(fine);
  return fmt::format("after {}: {}\n", rules_.strokes(), text);
}

Result<std::string> WriteDrawing(const Drawing& drawing) {
  DrawingWriter writer;
  std::string text = DrawingWriter::Begin();
  auto command = drawing.commands.begin();
  // Each command goes as early as its count allows: right after the event that completes a stroke.
  const auto add_commands = [&]() -> Result<void> {
    while (command != drawing.commands.end() && command->after_stroke <= writer.strokes()) {
      if (command->after_stroke < writer.strokes()) return Misplaced(*command);
      const auto line = writer.AddCommand(command->text);
      if (!line) return Fail(line);
      text += *line;
      ++command;
    }
    return {};
  };
  if (auto fine = add_commands(); !fine) return Fail(fine);
  for (const InputEvent& event : drawing.events) {
    const auto line = writer.Add(event);
    if (!line) return Fail(line);
    text += *line;
    if (auto fine = add_commands(); !fine) return Fail(fine);
  }
  if (command != drawing.commands.end()) return Fail(Misplaced(*command));
  return text + DrawingWriter::End();
}

}  // namespace parti::input
