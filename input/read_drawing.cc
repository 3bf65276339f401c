// The reader of drawings: see drawing.h.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "input/drawing.h"
#include "input/event_text.h"
#include "input/line_scanner.h"

namespace parti::input {
namespace {

constexpr std::string_view kHeader = "parti-drawing 1";
constexpr std::string_view kFormat = "parti-drawing ";
constexpr size_t kShownBytes = 80;  // of a line that is too long to show
constexpr const char* kKeepTheRest =
    "all before it is kept; to be rid of this message, put `end` in its place";

std::string_view WithoutCarriageReturn(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

/// One pass over the lines of a drawing.
class Reader {
 public:
  Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  DrawingReading Read() {
    DrawingReading reading;
    Result<void> sound = ReadHeader();
    while (sound && !ended_ && NextLine()) sound = ReadLine(&reading.drawing);
    if (sound) sound = ended_ ? CheckNothingFollows() : Truncated();
    if (!sound) reading.damage = std::move(sound.error());
    return reading;
  }

 private:
  /// Moves to the next line; false at the end of the text.
  bool NextLine() {
    if (next_ >= text_.size()) return false;
    const size_t stop = text_.find('\n', next_);
    complete_ = stop != std::string_view::npos;
    line_ = WithoutCarriageReturn(text_.substr(next_, complete_ ? stop - next_ : stop));
    next_ = complete_ ? stop + 1 : text_.size();
    ++number_;
    return true;
  }

  Result<void> ReadHeader() {
    if (NextLine() && line_ == kHeader) return {};
    if (line_.starts_with(kFormat)) {
      return Damaged(ErrorCode::kBadText, "a drawing of another version than 1",
                     "it was made by another version of Parti: use that, or a newer one");
    }
    return Damaged(ErrorCode::kBadText, "this is not a drawing",
                   "its first line must be `parti-drawing 1`");
  }

  Result<void> ReadLine(Drawing* drawing) {
    if (line_.size() > DrawingLimits::kLineBytes) {
      const size_t bytes = std::exchange(line_, line_.substr(0, kShownBytes)).size();
      return Damaged(ErrorCode::kDamagedFile, fmt::format("a line of {} bytes; at most {} are read",
                                                          bytes, DrawingLimits::kLineBytes));
    }
    if (drawing->events.size() + drawing->commands.size() >= DrawingLimits::kLines) {
      return Damaged(ErrorCode::kDamagedFile,
                     fmt::format("more than {} events", DrawingLimits::kLines));
    }
    LineScanner line(line_);
    if (line.AtEnd() || line_[line_.find_first_not_of(" \t")] == '#') return {};
    const Word word = *line.Next("");
    if (word.text == "end") return ReadEnd(line);
    if (!complete_) return CutLine();
    if (word.text == "after") return ReadCommand(line, drawing);
    auto event = ReadEvent(line_);
    if (!event) return Damaged(std::move(event.error()));
    if (auto fine = rules_.Take(*event); !fine) return Damaged(std::move(fine.error()));
    drawing->events.push_back(std::move(*event));
    return {};
  }

  Result<void> ReadCommand(LineScanner& line, Drawing* drawing) {
    Word rest = line.Rest();
    const size_t colon = rest.text.find(':');
    if (colon == std::string_view::npos) {
      return Damaged(
          line.FailAt(rest, "a command without a colon", "write `after STROKES: COMMAND`").value());
    }
    const auto after = IntegerIn(line, {rest.text.substr(0, colon), rest.column}, 0, 1 << 30);
    if (!after) return Damaged(after.error());
    size_t skip = colon + 1;
    if (rest.text.substr(skip).starts_with(' ')) ++skip;
    rest = {rest.text.substr(skip), rest.column + static_cast<int>(skip)};
    if (auto fine = rules_.TakeCommand(*after, rest.text); !fine) {
      return Damaged(std::move(fine.error()));
    }
    drawing->commands.push_back({*after, std::string(rest.text), PlaceOf(rest)});
    return {};
  }

  Result<void> ReadEnd(LineScanner& line) {
    if (!line.AtEnd()) return Damaged(line.FailAt(line.Rest(), "words after `end`").value());
    ended_ = true;
    return {};
  }

  Result<void> CheckNothingFollows() {
    while (NextLine()) {
      if (LineScanner(line_).AtEnd()) continue;
      return Damaged(ErrorCode::kDamagedFile, "text after the drawing's end",
                     "delete it, or the `end` before it");
    }
    return {};
  }

  Result<void> CutLine() {
    Error error{ErrorCode::kDamagedFile, "the drawing is cut off within this line", kKeepTheRest,
                PlaceOf({line_.substr(line_.size()), static_cast<int>(line_.size()) + 1})};
    return tl::unexpected<Error>(std::move(error));
  }

  Result<void> Truncated() {
    std::string message = "the drawing is cut off: its last line is not `end`";
    if (rules_.pen_is_down()) {
      message += fmt::format(", and stroke {} is not complete", rules_.strokes() + 1);
    }
    Error error{ErrorCode::kDamagedFile, std::move(message),
                "all up to here is kept; to be rid of this message, add the line `end`",
                PlaceOf({line_.substr(line_.size()), static_cast<int>(line_.size()) + 1})};
    return tl::unexpected<Error>(std::move(error));
  }

  SourcePlace PlaceOf(const Word& word) const {
    return {std::string(file_), number_, word.column,
            std::max(1, static_cast<int>(word.text.size())), std::string(line_)};
  }

  /// The whole line is at fault.
  Result<void> Damaged(ErrorCode code, std::string message, std::string hint = kKeepTheRest) const {
    return tl::unexpected<Error>(
        Error{code, std::move(message), std::move(hint), PlaceOf({line_, 1})});
  }

  /// An error of a part that knew nothing of files, or broke a rule of drawings.
  Result<void> Damaged(Error error) const {
    error.code = ErrorCode::kDamagedFile;
    if (error.hint.empty()) error.hint = kKeepTheRest;
    if (!error.place) error.place = PlaceOf({line_, 1});
    error.place->file = file_;
    error.place->line = number_;
    return tl::unexpected<Error>(std::move(error));
  }

  std::string_view text_, file_;
  size_t next_ = 0;
  std::string_view line_;
  int number_ = 0;
  bool complete_ = true;  // the line has its line break
  bool ended_ = false;
  DrawingRules rules_;
};

}  // namespace

DrawingReading ReadDrawing(std::string_view text, std::string_view file) {
  return Reader(text, file).Read();
}

}  // namespace parti::input
