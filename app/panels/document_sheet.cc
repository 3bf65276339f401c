// The document's sheets: new, open, save as, recent, with a list of files of our own. Names come
// in PanelView::files; nothing is read or written here.
#include <utility>

#include "app/panels/sheet_rows.h"
#include "app/panels/words.h"
#include "app/panels/writing.h"

namespace parti::app::panels {
namespace {

std::string WithEnding(const std::string& name) {
  return name.ends_with(kDocumentEnding) ? name : name + std::string(kDocumentEnding);
}

void Ask(Ui* ui, Memory* memory, DocumentRequest request) {
  ui->Send(std::move(request));
  memory->open = Sheet::kNone;
}

void RecordRow(Ui* ui, Memory* memory, Form* form) {
  const PanelFiles& files = ui->view().files;
  const std::string name = FreeName(files, "parti-report", ".pen") + ".pen";
  const ButtonLook record{.name = "Record for a bug report", .icon = Icon::kRecord};
  if (form->Choice(record, name + " in " + files.folder)) {
    Ask(ui, memory, {DocumentRequest::Kind::kRecordForReport, Joined(files.folder, name)});
  }
}

/// The folder, the way up, and what lies in it; a document that was tapped.
std::optional<std::string> FileRows(Ui* ui, Form* form) {
  const PanelFiles& files = ui->view().files;
  form->Label(files.folder);
  const ButtonLook up{
      .name = "The folder above", .icon = Icon::kUp, .enabled = files.folder.size() > 1};
  if (form->Choice(up)) ui->Send(ListFolder{FolderOf(files.folder)});
  std::optional<std::string> tapped;
  for (const PanelFile& file : files.here) {
    const Icon icon = file.is_folder ? Icon::kFolder : Icon::kDocument;
    if (!form->Choice({.name = file.name, .icon = icon})) continue;
    if (file.is_folder) {
      ui->Send(ListFolder{Joined(files.folder, file.name)});
    } else {
      tapped = file.name;
    }
  }
  if (files.here.empty()) form->Words("There are no documents in this folder.");
  return tapped;
}

}  // namespace

void DocumentRows(Ui* ui, Memory* memory, Form* form) {
  using Kind = DocumentRequest::Kind;
  const PanelFiles& files = ui->view().files;
  if (form->Heading("Document")) memory->open = Sheet::kNone;
  if (form->Choice({.name = "New", .icon = Icon::kNew})) Ask(ui, memory, {Kind::kNew});
  if (form->Choice({.name = "Open…", .icon = Icon::kOpen})) memory->Show(Sheet::kOpen);
  if (form->Choice({.name = "Save as…", .icon = Icon::kSave})) memory->Show(Sheet::kSaveAs);
  RecordRow(ui, memory, form);
  if (!files.trouble.empty()) form->Words(Capital(files.trouble) + ".");
  if (!files.drafts.empty()) form->Label("Drafts that were left");
  DraftRows(ui, memory, form, files.drafts.size());
  if (files.recent.empty()) return;
  form->Label("Recent");
  for (const std::string& path : files.recent) {
    const ButtonLook look{.name = "Recent " + path, .icon = Icon::kDocument, .label = NameIn(path)};
    if (form->Choice(look, FolderOf(path))) Ask(ui, memory, {Kind::kOpen, path});
  }
}

void OpenRows(Ui* ui, Memory* memory, Form* form) {
  if (form->Heading("Open a document")) memory->open = Sheet::kNone;
  if (const auto name = FileRows(ui, form)) {
    const std::string path = Joined(ui->view().files.folder, *name);
    Ask(ui, memory, {DocumentRequest::Kind::kOpen, path});
  }
}

void SaveAsRows(Ui* ui, Memory* memory, Form* form) {
  if (form->Heading("Save as")) memory->open = Sheet::kNone;
  if (form->draw() && std::exchange(memory->name_asked, false)) {
    memory->file_name = NameNow(ui->view(), kDocumentEnding);
    if (ui->view().has_keys) ui->StartTyping("Name", memory->file_name);
  }
  if (const auto typed = form->Field("Name", memory->file_name)) memory->file_name = *typed;
  const std::string path = Joined(ui->view().files.folder, WithEnding(memory->file_name));
  const bool named = !memory->file_name.empty();
  const DocumentRequest wish{DocumentRequest::Kind::kSaveAs, path};
  if (auto save = WriteButton(ui, memory, form, "Save here", wish, named)) {
    return Ask(ui, memory, std::move(*save));
  }
  if (const auto name = FileRows(ui, form)) memory->file_name = *name;
}

}  // namespace parti::app::panels
