#include "app/panels/drafts.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>

#include "app/panels/sheet_rows.h"

namespace parti::app::panels {
namespace {

constexpr std::array<const char*, 12> kMonths = {"January",   "February", "March",    "April",
                                                 "May",       "June",     "July",     "August",
                                                 "September", "October",  "November", "December"};
constexpr size_t kMostOnCard = 3;

/// The row of a draft that was asked about, in its place.
void DoomedRow(Ui* ui, Memory* memory, Form* form, const std::string& path) {
  const auto goes = form->AskOnceMore(
      fmt::format("Throw away the draft of {}? It can't be had again.", WordsOfDraft(path)),
      "Throw away");
  if (goes && *goes) ui->Send(ThrowAway{path});
  if (goes) memory->doomed_draft.clear();
}

void Row(Ui* ui, Memory* memory, Form* form, const std::string& path) {
  Box row = form->Row(ui->U(kMeasures.target), 2);
  if (!form->draw()) return;
  const Box away = row.CutRight(ui->U(kMeasures.target), ui->U(kMeasures.gap));
  const std::string words = WordsOfDraft(path);
  const ButtonLook open{.name = "Draft " + path, .icon = Icon::kDocument, .label = words};
  if (ui->Button(open, row).pressed) {
    ui->Send(DocumentRequest{DocumentRequest::Kind::kOpen, path});
    memory->open = Sheet::kNone;
  }
  const ButtonLook remove{.name = "Throw away " + path, .icon = Icon::kDelete};
  if (ui->Button(remove, away).pressed) memory->doomed_draft = path;
}

void CardRows(Ui* ui, Memory* memory, Form* form) {
  const size_t left = ui->view().files.drafts.size();
  if (form->Heading("Left from before")) memory->drafts_seen = true;
  form->Words("Drawn and never saved under a name.");
  DraftRows(ui, memory, form, kMostOnCard);
  if (left > kMostOnCard) {
    form->Words(fmt::format("The document's sheet lists {} more.", left - kMostOnCard));
  }
}

bool NothingDoneYet(const PanelView& view) {
  if (!view.session || !view.session->document.path.empty()) return false;
  const SessionState& state = *view.session->state;
  return state.model.lots().empty() && state.sketch.strokes.empty() && state.sketch.unread.empty();
}

}  // namespace

std::string WordsOfDraft(const std::string& path) {
  const std::string name = NameIn(path);
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  const int read =
      std::sscanf(name.c_str(), "%4d-%2d-%2d %2d.%2d", &year, &month, &day, &hour, &minute);
  if (read != 5 || month < 1 || month > 12) return name;
  return fmt::format("{} {} {}, {:02}:{:02}", day, kMonths[static_cast<size_t>(month - 1)], year,
                     hour, minute);
}

void DraftRows(Ui* ui, Memory* memory, Form* form, size_t most) {
  const auto& drafts = ui->view().files.drafts;
  for (size_t i = 0; i < std::min(most, drafts.size()); ++i) {
    if (drafts[i] == memory->doomed_draft) {
      DoomedRow(ui, memory, form, drafts[i]);
    } else {
      Row(ui, memory, form, drafts[i]);
    }
  }
}

void DrawLeftDrafts(Ui* ui, Memory* memory) {
  const bool offered = !ui->view().files.drafts.empty() && NothingDoneYet(ui->view());
  if (!offered || memory->drafts_seen || memory->open != Sheet::kNone) return;
  const float pad = ui->U(kMeasures.gap + 2);
  const Box free = memory->layout.free;
  const float width = std::min(ui->U(kMeasures.sheet), free.width());
  Form measured(ui, {0, 0, width - 2 * pad, 0}, false);
  CardRows(ui, memory, &measured);
  const float height = std::min(measured.height() + 2 * pad, free.height());
  // Low, so that the ground is clear for the first outline.
  const Box box = BoxAt(free.middle_x() - width / 2, free.y1 - height, width, height);
  ui->BeginSheet("Drafts", box);
  const Box list = ui->BeginList("list", box.Inset(pad), measured.height());
  Form form(ui, list, true);
  CardRows(ui, memory, &form);
  ui->EndList();
  ui->EndSheet();
}

}  // namespace parti::app::panels
