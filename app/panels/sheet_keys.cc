#include "app/panels/sheet_keys.h"

#include <linux/input-event-codes.h>

#include <array>
#include <optional>

namespace parti::app::panels {
namespace {

void ShowRules(Memory* memory) { memory->rules_shown = !memory->rules_shown; }
void Open(Memory* memory) { memory->Toggle(Sheet::kOpen, memory->layout.title); }
void SaveAs(Memory* memory) { memory->Toggle(Sheet::kSaveAs, memory->layout.title); }
void Export(Memory* memory) { memory->Toggle(Sheet::kExport, memory->layout.menu); }
void Close(Memory* memory) { memory->open = Sheet::kNone; }

struct Row {
  SheetKey shown;
  uint32_t code;
  std::optional<bool> control;  // none: with and without
  void (*press)(Memory*);
};

constexpr std::array<Row, 5> kRows = {{
    {{"R", "show the rules, or hide them"}, KEY_R, false, ShowRules},
    {{"Ctrl+O", "open a drawing"}, KEY_O, true, Open},
    {{"Ctrl+S", "save the drawing under a name"}, KEY_S, true, SaveAs},
    {{"Ctrl+E", "export the building"}, KEY_E, true, Export},
    {{"Escape", "close the sheet that is open"}, KEY_ESC, std::nullopt, Close},
}};

}  // namespace

std::vector<SheetKey> SheetKeys() {
  std::vector<SheetKey> keys;
  for (const Row& row : kRows) keys.push_back(row.shown);
  return keys;
}

bool PressSheetKey(const KeyEvent& key, bool control, Memory* memory) {
  if (!key.pressed || key.repeat) return false;
  for (const Row& row : kRows) {
    if (row.code != key.code || row.control.value_or(control) != control) continue;
    if (row.press == Close && memory->open == Sheet::kNone) return false;
    row.press(memory);
    return true;
  }
  return false;
}

}  // namespace parti::app::panels
