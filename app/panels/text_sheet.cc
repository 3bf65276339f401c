#include "app/panels/text_sheet.h"

#include <fmt/format.h>

namespace parti::app::panels {
namespace {

constexpr const char* kWaiting = "Not in force yet: mend the lines that are marked.";
constexpr const char* kDeriving = "Not in force yet: the building can't be made by it so far.";
constexpr const char* kReadable = "Not in force yet: it can be read now.";
constexpr const char* kPut = "Put it in force";
constexpr const char* kBack = "Back to the rules in force";
constexpr const char* kNewLine = "Add a line";
constexpr const char* kTrees = "Drawn on top of them";

/// A line with the heights of its parts.
struct LineText {
  RulesLine line;
  Box words;  ///< room of the words in a row at 0, 0
  float words_height = 0, notes_height = 0, height = 0;
};

LineText Measured(Ui* ui, RulesLine line, float width) {
  LineText text{std::move(line), {}, 0, 0, 0};
  const float indent = ui->U(8) + ui->U(12) * static_cast<float>(std::min(text.line.depth, 8));
  text.words = {indent, 0, width - ui->U(8), 0};
  text.words_height = ui->Paragraph(text.line.text, text.words, {}, false);
  for (const std::string& note : text.line.notes) {
    text.notes_height += ui->Paragraph(note, text.words, {Letter::kSmall}, false) + ui->U(2);
  }
  const float least = ui->U(text.line.closes ? 22 : kMeasures.target);
  const float around = text.line.closes ? 0 : ui->U(12);
  text.height = std::max(least, text.words_height + text.notes_height + around);
  return text;
}

void DrawWords(Ui* ui, const LineText& text, const Box& row, Ground ground) {
  const float content = text.words_height + text.notes_height;
  Box rest{row.x0 + text.words.x0, row.middle_y() - content / 2, row.x0 + text.words.x1, row.y1};
  const Tone tone = text.line.closes ? Tone::kQuiet : Tone::kText;
  ui->Paragraph(text.line.text, rest.CutTop(text.words_height), {Letter::kBody, tone, ground});
  for (const std::string& note : text.line.notes) {
    const TextLook look{Letter::kSmall, Tone::kWarning, ground};
    ui->Paragraph(note, rest.CutTop(ui->Paragraph(note, rest, look, false), ui->U(2)), look);
  }
}

/// Draws all texts one under the other, or only measures where `draw` is false.
class Texts {
 public:
  Texts(Ui* ui, const Box& list, bool draw) : ui_(ui), list_(list), draw_(draw) {}

  float height() const { return height_; }

  void Heading(std::string_view text) {
    const TextLook look{Letter::kStrong};
    const Box room = list_.Inset(ui_->U(8), 0);
    const float words = ui_->Paragraph(text, room, look, false);
    const Box box = Take(words + ui_->U(10));
    if (draw_) ui_->Paragraph(text, {room.x0, box.y0 + ui_->U(4), room.x1, box.y1}, look);
  }

  /// Says why a text waits; whether it is to be taken back.
  bool Waiting(const char* words, const std::string& back) {
    const TextLook look{Letter::kSmall, Tone::kWarning};
    const Box room = list_.Inset(ui_->U(8), 0);
    const Box said = Take(ui_->Paragraph(words, room, look, false) + ui_->U(8));
    const Box button = Take(ui_->U(kMeasures.target), ui_->U(4));
    if (!draw_) return false;
    ui_->Paragraph(words, {room.x0, said.y0, room.x1, said.y1}, look);
    return ui_->Button({.name = back, .icon = Icon::kReset, .label = kBack}, button).pressed;
  }

  /// Offers what a text that waits may be put in force by; whether it is to be.
  bool Putting(const std::string& name) {
    const Box button = Take(ui_->U(kMeasures.target), ui_->U(4));
    if (!draw_) return false;
    return ui_->Button({.name = name, .icon = Icon::kCheck, .label = kPut}, button).pressed;
  }

  /// What was typed over the line.
  std::optional<std::string> Line(const std::string& name, RulesLine line) {
    const LineText text = Measured(ui_, std::move(line), list_.width());
    const Box row = Take(text.height);
    if (!draw_) return std::nullopt;
    if (text.line.closes) {
      DrawWords(ui_, text, row, Ground::kPanel);
      return std::nullopt;
    }
    Ui::Over over;
    auto typed = ui_->FieldOver(name, row, text.line.text, &over);
    if (!over.typing) DrawWords(ui_, text, row, over.hovered ? Ground::kHover : Ground::kPanel);
    return typed;
  }

  /// What was typed into an empty line at the end.
  std::optional<std::string> NewLine(const std::string& name) {
    const Box row = Take(ui_->U(kMeasures.target), ui_->U(6));
    if (!draw_) return std::nullopt;
    Ui::Over over;
    auto typed = ui_->FieldOver(name, row, "", &over);
    const Ground ground = over.hovered ? Ground::kHover : Ground::kPanel;
    const TextLook look{Letter::kBody, Tone::kQuiet, ground};
    if (!over.typing) ui_->Text(kNewLine, row.Inset(ui_->U(8), 0), look);
    return typed;
  }

 private:
  Box Take(float height, float gap = 0) {
    const Box box{list_.x0, list_.y0 + height_, list_.x1, list_.y0 + height_ + height};
    height_ += height + gap;
    return box;
  }

  Ui* ui_;
  Box list_;
  bool draw_;
  float height_ = 0;
};

void TypeInFile(Ui* ui, TypedFiles* all, const FileLines& file, size_t line,
                const std::string& typed) {
  const auto command = TypeOver(*ui->view().session, file.file, line, typed, all);
  if (command) ui->SendTyped(*command);
}

const char* WaitingWords(const FileLines& file) {
  if (!file.is_read) return kWaiting;
  return file.can_be_asked && !file.failed ? kReadable : kDeriving;
}

/// `typed_files` is changed only where something is typed: never while measuring.
void File(Ui* ui, TypedFiles* typed_files, const FileLines& file, Texts* texts) {
  texts->Heading(file.file);
  if (file.waits && texts->Waiting(WaitingWords(file), "Back " + file.file)) {
    std::erase_if(typed_files->files, [&](const auto& one) { return one.name == file.file; });
  }
  if (file.can_be_asked && texts->Putting("Put in force " + file.file)) {
    ui->SendTyped(PutInForce(*ui->view().session, file.file, typed_files));
  }
  for (size_t i = 0; i < file.lines.size(); ++i) {
    const auto typed = texts->Line(fmt::format("{} {}", file.file, i + 1), file.lines[i]);
    if (typed) TypeInFile(ui, typed_files, file, i, *typed);
  }
  const auto added = texts->NewLine(fmt::format("{} end", file.file));
  if (added) TypeInFile(ui, typed_files, file, file.lines.size(), *added);
}

void Trees(Ui* ui, TypedRules* typed_rules, const std::vector<RulesLine>& lines, Texts* texts) {
  const SessionState& state = *ui->view().session->state;
  if (typed_rules->Waits(state.model) && texts->Waiting(kWaiting, kBack)) {
    typed_rules->lines.clear();
  }
  for (size_t i = 0; i < lines.size(); ++i) {
    const auto typed = texts->Line(fmt::format("Line {}", i + 1), lines[i]);
    if (!typed) continue;
    if (const auto rewrite = TypeOver(state, i, *typed, typed_rules)) ui->SendTyped(*rewrite);
  }
}

float All(Ui* ui, Memory* memory, Texts texts) {
  if (!ui->view().session) return 0;
  const SessionSnapshot& session = *ui->view().session;
  const std::vector<FileLines>& files = memory->known_files.Of(session, memory->typed_files);
  for (const FileLines& file : files) File(ui, &memory->typed_files, file, &texts);
  const std::vector<RulesLine> trees = LinesOf(*session.state, memory->typed_rules);
  if (!files.empty() && !trees.empty()) texts.Heading(kTrees);
  Trees(ui, &memory->typed_rules, trees, &texts);
  return texts.height();
}

}  // namespace

float RulesTextHeight(Ui* ui, Memory* memory, float width) {
  return All(ui, memory, Texts(ui, {0, 0, width, 0}, false));
}

void DrawRulesText(Ui* ui, Memory* memory, const Box& list) {
  All(ui, memory, Texts(ui, list, true));
}

}  // namespace parti::app::panels
