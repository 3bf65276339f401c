#include "app/panels/tools.h"

#include <array>
#include <filesystem>

namespace parti::app::panels {
namespace {

/// One button of the column.
struct Tool {
  Icon icon;
  const char* name;
  const char* keys;
  bool chosen, enabled;
  PanelCommand command;
};

std::array<Tool, kToolCount> ToolsOf(const PanelView& view) {
  const auto mode = [&](Icon icon, const char* name, const char* keys, PointerMode m) {
    return Tool{icon, name, keys, view.mode == m, true, m};
  };
  Settings finger = view.settings;
  finger.finger_draws = !finger.finger_draws;
  const bool undo = view.session && view.session->can_undo;
  const bool redo = view.session && view.session->can_redo;
  return {mode(Icon::kDraw, "Draw", "D", PointerMode::kDraw),
          mode(Icon::kErase, "Erase", "E", PointerMode::kErase),
          mode(Icon::kSelect, "Select", "S", PointerMode::kSelect),
          Tool{Icon::kUndo, "Undo", "Ctrl+Z", false, undo, Command(Undo{})},
          Tool{Icon::kRedo, "Redo", "Ctrl+Y", false, redo, Command(Redo{})},
          mode(Icon::kOrbit, "Orbit", "O", PointerMode::kOrbit),
          mode(Icon::kPan, "Pan", "P", PointerMode::kPan),
          mode(Icon::kZoom, "Zoom", "Z", PointerMode::kZoom),
          Tool{Icon::kFit, "Show all", "Home", false, true, ViewRequest::kFit},
          Tool{Icon::kFinger, "Finger draws", "", view.settings.finger_draws, true, finger}};
}

/// "House" of "/…/House.parti".
std::string TitleOf(const PanelView& view) {
  if (!view.session || view.session->document.path.empty() || !view.session->document.named) {
    return "Untitled";
  }
  return std::filesystem::path(view.session->document.path).stem().string();
}

/// What the document is called; opens its sheet.
void DrawTitle(Ui* ui, Memory* memory) {
  const float gap = ui->U(kMeasures.gap);
  const std::string title = TitleOf(ui->view());
  Box at = memory->layout.title;
  const float width = ui->TextWidth(title, Letter::kStrong) + ui->U(40 + 44 + 16);
  const bool right = at.x0 > ui->window().middle_x();
  at = right ? at.CutRight(width) : at.CutLeft(width);
  ui->BeginSheet("Title", at);
  Box box = at.Inset(gap);
  const Press press = ui->Area("Document", box);
  if (press.hovered) ui->Fill(box, Ground::kHover, kMeasures.small_radius);
  const Ground ground = press.hovered ? Ground::kHover : Ground::kPanel;
  ui->Picture(Icon::kDocument, box.CutLeft(ui->U(40)), Tone::kQuiet, ground);
  ui->Picture(Icon::kDown, box.CutRight(ui->U(40)), Tone::kQuiet, ground);
  ui->Text(title, box, {Letter::kStrong, Tone::kText, ground});
  if (press.pressed) memory->Toggle(Sheet::kDocument, at);
  ui->EndSheet();
}

}  // namespace

void DrawTools(Ui* ui, const Memory& memory) {
  const Layout& layout = memory.layout;
  ui->BeginSheet("Tools", layout.tools);
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  int i = 0;
  for (const Tool& tool : ToolsOf(ui->view())) {
    const auto column = static_cast<float>(i % layout.tool_columns);
    const int rows_above = i / layout.tool_columns;
    const auto row = static_cast<float>(rows_above);
    const Box box = BoxAt(layout.tools.x0 + gap + column * (side + gap),
                          layout.tools.y0 + gap + row * (side + gap), side, side);
    const ButtonLook look{.name = tool.name,
                          .icon = tool.icon,
                          .keys = tool.keys,
                          .chosen = tool.chosen,
                          .enabled = tool.enabled};
    if (ui->Button(look, box).pressed) ui->Send(tool.command);
    ++i;
  }
  ui->EndSheet();
}

void DrawHead(Ui* ui, Memory* memory) {
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  DrawTitle(ui, memory);
  ui->BeginSheet("Menu", memory->layout.menu);
  Box row = memory->layout.menu.Inset(gap);
  const auto opener = [&](const char* name, Icon icon, Sheet sheet) {
    const Box box = row.CutLeft(side, gap);
    const bool open = memory->open == sheet;
    if (ui->Button({.name = name, .icon = icon, .chosen = open}, box).pressed) {
      memory->Toggle(sheet, memory->layout.menu);
    }
  };
  opener("Views", Icon::kBookmark, Sheet::kViews);
  opener("Export", Icon::kExport, Sheet::kExport);
  opener("Settings", Icon::kSettings, Sheet::kSettings);
  const ButtonLook rules{
      .name = "Rules", .icon = Icon::kRules, .keys = "R", .chosen = memory->rules_shown};
  if (ui->Button(rules, row.CutLeft(side)).pressed) memory->rules_shown = !memory->rules_shown;
  ui->EndSheet();
}

}  // namespace parti::app::panels
