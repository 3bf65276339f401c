#include "app/panels/sheet_keys.h"

#include <linux/input-event-codes.h>

namespace parti::app::panels {

bool PressSheetKey(const KeyEvent& key, bool control, Memory* memory) {
  if (!key.pressed || key.repeat) return false;
  const auto toggle = [&](Sheet sheet, const Box& button) {
    memory->Toggle(sheet, button);
    return true;
  };
  const Layout& layout = memory->layout;
  if (control && key.code == KEY_O) return toggle(Sheet::kOpen, layout.title);
  if (control && key.code == KEY_S) return toggle(Sheet::kSaveAs, layout.title);
  if (control && key.code == KEY_E) return toggle(Sheet::kExport, layout.menu);
  if (!control && key.code == KEY_R) {
    memory->rules_shown = !memory->rules_shown;
    return true;
  }
  if (key.code != KEY_ESC || memory->open == Sheet::kNone) return false;
  memory->open = Sheet::kNone;
  return true;
}

}  // namespace parti::app::panels
