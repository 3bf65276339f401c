// The drawing file (`.pen`): a whole session as a tablet and a hand made it (S1; docs/drawings.md).
// Two streams: device events, and commands keyed "after stroke n".
// Not responsible for what a command means (app/) or for files (base/text_file.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "input/drawing_rules.h"

namespace parti::input {

/// What the application was told, and when.
struct DrawingCommand {
  int after_stroke = 0;    ///< strokes completed before it (see PenContacts)
  std::string text;        ///< one line, not blank; for app/ to read
  SourcePlace place = {};  ///< of `text`; only where it was read from a file
};

/// A session: what devices sent, and what was chosen in between.
struct Drawing {
  std::vector<InputEvent> events;        ///< times from 0, the start, in seconds
  std::vector<DrawingCommand> commands;  ///< after_stroke never decreases
};

/// Equal events, and commands with equal texts after equal strokes, wherever they stand in a file.
bool operator==(const Drawing& a, const Drawing& b);

/// What could be read of a drawing, and why not more.
struct DrawingReading {
  Drawing drawing;              ///< everything before the damage
  std::optional<Error> damage;  ///< kDamagedFile or, for a wrong header, kBadText, with its place
};

/// Reads a drawing as far as it is sound. `file` only names the places.
/// Only a wrong header gives nothing at all. A file that does not end with its `end` line is
/// truncated, and its last line is kept only if a line break completes it.
/// Property  (1) ReadDrawing(WriteDrawing(d)) gives d, whole, for every d that can be written.
///           (2) any prefix of a file's bytes gives a prefix of its events and commands, and damage
///               unless the `end` line is in it.
/// Cost: linear in the text.
DrawingReading ReadDrawing(std::string_view text, std::string_view file = {});

/// errors  those of DrawingRules, naming the event or command; nothing is written that could not be
///         read again.
Result<std::string> WriteDrawing(const Drawing& drawing);

/// Writes a drawing piece by piece, for a recorder that appends each piece to its file at once.
class DrawingWriter {
 public:
  /// The first line of the file.
  static std::string Begin();

  /// The line of the next event or command, with its line break. errors as DrawingRules.
  Result<std::string> Add(const InputEvent& event);
  Result<std::string> AddCommand(std::string_view text);

  /// The last line of the file.
  static std::string End();

  int strokes() const { return rules_.strokes(); }

 private:
  DrawingRules rules_;
};

}  // namespace parti::input
