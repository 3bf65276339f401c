#include "app/panels/status.h"

#include <fmt/format.h>

#include <functional>

#include "app/panels/hints.h"
#include "app/panels/words.h"
#include "grammar/query_reading.h"

namespace parti::app::panels {
namespace {

/// A button of a notice; one without a name is none.
struct Way {
  const char* name = "";
  std::function<void(Ui*, Memory*)> go = {};
};

/// What is to be read above the hint: a warning, or what a person should not forget.
struct Notice {
  std::string words;
  Way help;   ///< with its name on it
  Way close;  ///< a cross
  Icon icon = Icon::kWarning;
  Tone tone = Tone::kWarning;
};

/// "can't write House.parti: no space left. Free some, or save elsewhere." of an Error.
std::string Sentence(const Error& error) {
  std::string words = Capital(error.message) + ".";
  if (!error.hint.empty()) words += " " + Capital(error.hint) + ".";
  return words;
}

void CloseMessage(Ui* ui, Memory* memory) {
  const bool failed = ui->view().session && ui->view().session->last_error;
  if (ui->complaint().empty() && failed) memory->dismissed = ui->view().session->last_error->number;
  ui->DropComplaint();
}

void SaveElsewhere(Ui*, Memory* memory) { memory->Toggle(Sheet::kSaveAs, memory->layout.title); }

void LeaveThem(Ui* ui, Memory*) { ui->Send(*ui->view().session->last_error->giving_up); }

void ActOnAnything(Ui* ui, Memory*) { ui->Send(Command(SetQuery{SetQuery::kNone})); }

std::vector<Notice> NoticesOf(Ui* ui, const Memory& memory) {
  const PanelView& view = ui->view();
  const Way close{"Close the message", CloseMessage};
  std::vector<Notice> notices;
  if (!ui->complaint().empty()) {
    notices.push_back({Sentence({ErrorCode::kBadText, ui->complaint()}), {}, close});
  }
  if (!view.session) return notices;
  const DocumentStatus& document = view.session->document;
  if (document.trouble) {
    notices.push_back({Sentence(*document.trouble), {"Save elsewhere", SaveElsewhere}, {}});
  }
  const auto& failed = view.session->last_error;
  const bool is_news = failed && !failed->mended && failed->number != memory.dismissed;
  if (ui->complaint().empty() && is_news) {
    const Way leave = failed->giving_up ? Way{"Leave them", LeaveThem} : Way{};
    notices.push_back({Sentence(failed->error), leave, close});
  }
  if (const auto& query = view.session->state->sketch.query) {
    notices.push_back({"What you draw acts on " + grammar::ReadingOf(*query) + ".",
                       {},
                       {"Act on anything again", ActOnAnything},
                       Icon::kSelect,
                       Tone::kAccent});
  }
  return notices;
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

/// Room for the words of a notice.
float WordsWidth(Ui* ui, const Notice& notice, float width) {
  const float help =
      *notice.help.name ? ui->TextWidth(notice.help.name, Letter::kBody) + ui->U(24) : 0;
  const float close = *notice.close.name ? ui->U(kMeasures.target) : 0;
  return width - ui->U(44 + 16) - help - close;
}

float HeightOf(Ui* ui, const Notice& notice, float width) {
  const float words =
      ui->Paragraph(notice.words, {0, 0, WordsWidth(ui, notice, width), 0}, {}, false);
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

void DrawNotice(Ui* ui, Memory* memory, const Notice& notice, Box row) {
  ui->Hairline(row);
  const float words_width = WordsWidth(ui, notice, row.width());
  ui->Picture(notice.icon, row.CutLeft(ui->U(44)), notice.tone, Ground::kPanel);
  Box words = row.CutLeft(words_width, ui->U(8));
  const float height = ui->Paragraph(notice.words, words, {}, false);
  words.y0 += (words.height() - height) / 2;
  ui->Paragraph(notice.words, words, {});
  row.x1 -= ui->U(4);
  row = row.Inset(0, (row.height() - ui->U(kMeasures.target)) / 2);
  const Way &help = notice.help, &close = notice.close;
  const Box cross = *close.name ? row.CutRight(ui->U(kMeasures.target)) : Box();
  const ButtonLook look{.name = help.name, .label = help.name, .ground = Ground::kAccent};
  if (*help.name && ui->Button(look, row).pressed) help.go(ui, memory);
  if (!*close.name) return;
  if (ui->Button({.name = close.name, .icon = Icon::kClose}, cross).pressed) close.go(ui, memory);
}

}  // namespace

float StatusHeight(Ui* ui, const Memory& memory, float width) {
  const float sheet = SheetWidth(ui, width);
  float height = HintHeight(ui, sheet);
  for (const Notice& notice : NoticesOf(ui, memory)) height += HeightOf(ui, notice, sheet);
  return height;
}

void DrawStatus(Ui* ui, Memory* memory) {
  const Box room = memory->layout.bottom;
  const float width = SheetWidth(ui, room.width());
  Box rest = BoxAt(room.middle_x() - width / 2, room.y0, width, room.height());
  ui->BeginSheet("Status", rest);
  for (const Notice& notice : NoticesOf(ui, *memory)) {
    DrawNotice(ui, memory, notice, rest.CutTop(HeightOf(ui, notice, width)));
  }
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
