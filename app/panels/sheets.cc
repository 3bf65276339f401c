#include "app/panels/sheets.h"

#include "app/panels/sheet_rows.h"

namespace parti::app::panels {
namespace {

/// A sheet's name in PanelOutput::targets, and what is in it.
struct Content {
  Sheet sheet;
  const char* name;
  void (*rows)(Ui*, Memory*, Form*);
};

constexpr Content kContents[] = {
    {Sheet::kDocument, "Document", DocumentRows}, {Sheet::kOpen, "Open", OpenRows},
    {Sheet::kSaveAs, "Save as", SaveAsRows},      {Sheet::kViews, "Views", ViewsRows},
    {Sheet::kExport, "Export", ExportRows},       {Sheet::kSettings, "Settings", SettingsRows},
};

void Draw(Ui* ui, Memory* memory, const Content& content) {
  const float pad = ui->U(kMeasures.gap + 2), width = ui->U(kMeasures.sheet);
  Form measured(ui, {0, 0, width - 2 * pad, 0}, false);
  content.rows(ui, memory, &measured);
  const Box& room = memory->layout.sheets;
  const Box box = SheetAt(memory->opened_at, width, measured.height() + 2 * pad, room, ui->U(8));
  ui->BeginSheet(content.name, box);
  Box list = ui->BeginList("list", box.Inset(pad), measured.height());
  Form form(ui, list, true);
  content.rows(ui, memory, &form);
  ui->EndList();
  ui->EndSheet();
}

}  // namespace

void DrawOpenSheet(Ui* ui, Memory* memory) {
  for (const Content& content : kContents) {
    if (content.sheet == memory->open) return Draw(ui, memory, content);
  }
}

std::string Joined(const std::string& folder, const std::string& name) {
  if (folder.empty() || name.starts_with('/')) return name;
  return folder.ends_with('/') ? folder + name : folder + "/" + name;
}

std::string NameIn(const std::string& path) {
  const size_t slash = path.rfind('/');
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::string FolderOf(const std::string& path) {
  const size_t slash = path.rfind('/');
  if (slash == std::string::npos) return "";
  return slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace parti::app::panels
