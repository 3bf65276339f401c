#include "app/panels/status.h"

#include <fmt/format.h>

#include "app/panels/hints.h"
#include "app/panels/words.h"
#include "grammar/query_reading.h"

namespace parti::app::panels {
namespace {

/// What is to be read with a warning before it, and the button that helps.
struct Warning {
  std::string words;
  const char* button;  ///< "" for none
  bool is_error;       ///< of the last request, not of the document: it can be closed
};

/// "can't write House.parti: no space left. Free some, or save elsewhere." of an Error.
std::string Sentence(const Error& error) {
  std::string words = Capital(error.message) + ".";
  if (!error.hint.empty()) words += " " + Capital(error.hint) + ".";
  return words;
}

std::vector<Warning> WarningsOf(Ui* ui, const Memory& memory) {
  const PanelView& view = ui->view();
  std::vector<Warning> warnings;
  if (!ui->complaint().empty()) {
    warnings.push_back({Sentence({ErrorCode::kBadText, ui->complaint()}), "", true});
  }
  if (!view.session) return warnings;
  const DocumentStatus& document = view.session->document;
  if (document.trouble) warnings.push_back({Sentence(*document.trouble), "Save elsewhere", false});
  const auto& failed = view.session->last_error;
  const bool is_news = failed && !failed->mended && failed->number != memory.dismissed;
  if (ui->complaint().empty() && is_news) {
    warnings.push_back({Sentence(failed->error), failed->giving_up ? "Leave them" : "", true});
  }
  return warnings;
}

/// How the document is doing, in words.
struct Doing {
  Icon icon;
  Tone tone;
  std::string words;
};

Doing DoingOf(const PanelView& view) {
  if (!view.session) return {Icon::kCheck, Tone::kQuiet, "Ready"};
  const SessionSnapshot& session = *view.session;
  const DocumentStatus& document = session.document;
  if (document.read_only) return {Icon::kLock, Tone::kWarning, "Read-only"};
  if (document.trouble) return {Icon::kWarning, Tone::kWarning, "Not saved"};
  if (!session.doing.empty()) return {Icon::kBusy, Tone::kQuiet, session.doing};
  if (session.busy) return {Icon::kBusy, Tone::kQuiet, "Working"};
  if (session.acknowledged < session.executed) return {Icon::kBusy, Tone::kQuiet, "Saving"};
  if (document.path.empty()) return {Icon::kCheck, Tone::kQuiet, "Nothing to save yet"};
  return {Icon::kCheck, Tone::kQuiet, document.named ? "Saved" : "Saved as a draft"};
}

float ButtonWidth(Ui* ui, const Warning& warning) {
  return *warning.button ? ui->TextWidth(warning.button, Letter::kBody) + ui->U(24) : 0;
}

/// Room for the words of a warning.
float WordsWidth(Ui* ui, const Warning& warning, float width) {
  return width - ui->U(44 + 16) - ButtonWidth(ui, warning) -
         (warning.is_error ? ui->U(kMeasures.target) : 0);
}

float HeightOf(Ui* ui, const Warning& warning, float width) {
  const float words =
      ui->Paragraph(warning.words, {0, 0, WordsWidth(ui, warning, width), 0}, {}, false);
  return std::max(ui->U(kMeasures.target + 8), words + ui->U(16));
}

float DoingWidth(Ui* ui) {
  return ui->TextWidth(DoingOf(ui->view()).words, Letter::kSmall) + ui->U(36 + 14);
}

/// Room for the hint, beside its icon and what the document does.
float HintWidth(Ui* ui, float width) { return width - ui->U(44 + 8) - DoingWidth(ui); }

float HintHeight(Ui* ui, float width) {
  const Box room{0, 0, HintWidth(ui, width), 0};
  const float words = ui->Paragraph(HintOf(ui->view()), room, {}, false);
  return std::max(ui->U(kMeasures.target), words + ui->U(14));
}

float SheetWidth(Ui* ui, float room) { return std::min(room, ui->U(760)); }

/// The button that helps.
void DrawRemedy(Ui* ui, Memory* memory, const Warning& warning, Box row) {
  const Box box = row.Inset(0, (row.height() - ui->U(kMeasures.target)) / 2);
  const ButtonLook look{.name = warning.button, .label = warning.button, .ground = Ground::kAccent};
  if (!ui->Button(look, box).pressed) return;
  if (warning.is_error) {
    ui->Send(*ui->view().session->last_error->giving_up);
  } else {
    memory->Toggle(Sheet::kSaveAs, memory->layout.title);
  }
}

void DrawClose(Ui* ui, Memory* memory, Box box) {
  if (ui->Button({.name = "Close the message", .icon = Icon::kClose},
                 box.Inset(0, (box.height() - ui->U(kMeasures.target)) / 2))
          .pressed) {
    const bool failed = ui->view().session && ui->view().session->last_error;
    if (ui->complaint().empty() && failed)
      memory->dismissed = ui->view().session->last_error->number;
    ui->DropComplaint();
  }
}

void DrawWarning(Ui* ui, Memory* memory, const Warning& warning, Box row) {
  ui->Hairline(row);
  ui->Picture(Icon::kWarning, row.CutLeft(ui->U(44)), Tone::kWarning, Ground::kPanel);
  const float words_width = WordsWidth(ui, warning, row.width() + ui->U(44));
  Box words = row.CutLeft(words_width, ui->U(8));
  const float height = ui->Paragraph(warning.words, words, {}, false);
  words.y0 += (words.height() - height) / 2;
  ui->Paragraph(warning.words, words, {});
  row.x1 -= ui->U(4);
  const Box close = warning.is_error ? row.CutRight(ui->U(kMeasures.target)) : Box();
  if (*warning.button) DrawRemedy(ui, memory, warning, row);
  if (warning.is_error) DrawClose(ui, memory, close);
}

/// What the next sketch acts on, where that was chosen; else "".
std::string ChosenOf(const PanelView& view) {
  if (!view.session || !view.session->state->sketch.query) return "";
  return "What you draw acts on " + grammar::ReadingOf(*view.session->state->sketch.query) + ".";
}

Box ChosenRoom(Ui* ui, float width) {
  return {0, 0, width - ui->U(44 + 8 + 8 + kMeasures.target), 0};
}

float ChosenHeight(Ui* ui, float width) {
  const std::string words = ChosenOf(ui->view());
  if (words.empty()) return 0;
  const float height = ui->Paragraph(words, ChosenRoom(ui, width), {}, false);
  return std::max(ui->U(kMeasures.target + 8), height + ui->U(16));
}

void DrawChosen(Ui* ui, Box row) {
  const std::string words = ChosenOf(ui->view());
  if (words.empty()) return;
  const Box room = ChosenRoom(ui, row.width());
  const float height = ui->Paragraph(words, room, {}, false);
  ui->Hairline(row);
  ui->Picture(Icon::kSelect, row.CutLeft(ui->U(44)), Tone::kAccent, Ground::kPanel);
  row.x1 -= ui->U(4);
  const float side = ui->U(kMeasures.target);
  const Box box = row.CutRight(side).Inset(0, (row.height() - side) / 2);
  if (ui->Button({.name = "Act on anything again", .icon = Icon::kClose}, box).pressed) {
    ui->Send(Command(SetQuery{SetQuery::kNone}));
  }
  row.y0 += (row.height() - height) / 2;
  ui->Paragraph(words, row.CutLeft(room.x1));
}

}  // namespace

float StatusHeight(Ui* ui, const Memory& memory, float width) {
  const float sheet = SheetWidth(ui, width);
  float height = HintHeight(ui, sheet) + ChosenHeight(ui, sheet);
  for (const Warning& warning : WarningsOf(ui, memory)) {
    height += HeightOf(ui, warning, sheet);
  }
  return height;
}

void DrawStatus(Ui* ui, Memory* memory) {
  const Box room = memory->layout.bottom;
  const float width = SheetWidth(ui, room.width());
  Box rest = BoxAt(room.middle_x() - width / 2, room.y0, width, room.height());
  ui->BeginSheet("Status", rest);
  for (const Warning& warning : WarningsOf(ui, *memory)) {
    DrawWarning(ui, memory, warning, rest.CutTop(HeightOf(ui, warning, width)));
  }
  DrawChosen(ui, rest.CutTop(ChosenHeight(ui, width)));
  const Doing doing = DoingOf(ui->view());
  Box right = rest.CutRight(DoingWidth(ui));
  ui->Picture(doing.icon, right.CutLeft(ui->U(36)), doing.tone, Ground::kPanel);
  ui->Text(doing.words, right, {Letter::kSmall, doing.tone, Ground::kPanel});
  ui->Picture(Icon::kHint, rest.CutLeft(ui->U(44)), Tone::kAccent, Ground::kPanel);
  rest.x1 = rest.x0 + HintWidth(ui, width);
  const std::string hint = HintOf(ui->view());
  rest.y0 += (rest.height() - ui->Paragraph(hint, rest, {}, false)) / 2;
  ui->Paragraph(hint, rest);
  ui->EndSheet();
}

}  // namespace parti::app::panels
