#include "app/panels/text_sheet.h"

#include <fmt/format.h>

namespace parti::app::panels {
namespace {

constexpr const char* kWaiting = "Not in force yet: mend the lines that are marked.";

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

std::vector<LineText> AllLines(Ui* ui, const Memory& memory, float width) {
  std::vector<LineText> lines;
  if (!ui->view().session) return lines;
  for (RulesLine& line : LinesOf(*ui->view().session->state, memory.typed_rules)) {
    lines.push_back(Measured(ui, std::move(line), width));
  }
  return lines;
}

bool Waits(const Ui& ui, const Memory& memory) {
  return ui.view().session && memory.typed_rules.Waits(ui.view().session->state->model);
}

float WaitingHeight(Ui* ui, float width) {
  const Box room{0, 0, width - ui->U(16), 0};
  return ui->Paragraph(kWaiting, room, {Letter::kSmall}, false) + ui->U(8 + kMeasures.target + 4);
}

/// Says that the text waits, and takes it back.
void DrawWaiting(Ui* ui, Memory* memory, Box box) {
  const TextLook look{Letter::kSmall, Tone::kWarning};
  const Box room = box.Inset(ui->U(8), 0);
  box.CutTop(ui->Paragraph(kWaiting, room, look), ui->U(8));
  const ButtonLook back{.name = "Back to the rules in force",
                        .icon = Icon::kReset,
                        .label = "Back to the rules in force"};
  if (ui->Button(back, box.CutTop(ui->U(kMeasures.target))).pressed) {
    memory->typed_rules.lines.clear();
  }
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

void DrawLine(Ui* ui, Memory* memory, const LineText& text, size_t i, const Box& row) {
  if (text.line.closes) return DrawWords(ui, text, row, Ground::kPanel);
  Ui::Over over;
  const auto typed = ui->FieldOver(fmt::format("Line {}", i + 1), row, text.line.text, &over);
  if (!over.typing) DrawWords(ui, text, row, over.hovered ? Ground::kHover : Ground::kPanel);
  if (!typed) return;
  const auto rewrite = TypeOver(*ui->view().session->state, i, *typed, &memory->typed_rules);
  if (rewrite) ui->SendTyped(*rewrite);
}

}  // namespace

float RulesTextHeight(Ui* ui, const Memory& memory, float width) {
  float height = Waits(*ui, memory) ? WaitingHeight(ui, width) : 0;
  for (const LineText& line : AllLines(ui, memory, width)) height += line.height;
  return height;
}

void DrawRulesText(Ui* ui, Memory* memory, Box list) {
  const std::vector<LineText> lines = AllLines(ui, *memory, list.width());
  if (Waits(*ui, *memory)) {
    DrawWaiting(ui, memory, list.CutTop(WaitingHeight(ui, list.width())));
  }
  for (size_t i = 0; i < lines.size(); ++i) {
    DrawLine(ui, memory, lines[i], i, list.CutTop(lines[i].height));
  }
}

}  // namespace parti::app::panels
