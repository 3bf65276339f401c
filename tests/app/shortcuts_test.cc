#include "app/shortcuts.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "app/panels/sheet_keys.h"
#include "base/text_file.h"
#include "tests/support/data.h"

namespace parti::app {
namespace {

KeyEvent Press(uint32_t code) { return {.code = code, .pressed = true}; }
KeyEvent Release(uint32_t code) { return {.code = code}; }

TEST(ShortcutsTest, UndoAndRedoTellShiftApart) {
  Shortcuts shortcuts;
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_LEFTCTRL), {}));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_Z), {}), Shortcut(PanelCommand(Command(Undo{}))));
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_RIGHTSHIFT), {}));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_Z), {}), Shortcut(PanelCommand(Command(Redo{}))));
  EXPECT_FALSE(shortcuts.Feed(Release(KEY_LEFTCTRL), {}));
  EXPECT_FALSE(shortcuts.Feed(Release(KEY_RIGHTSHIFT), {}));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_Z), {}), Shortcut(PanelCommand(PointerMode::kZoom)));
}

TEST(ShortcutsTest, DeleteNeedsANodeInHand) {
  Shortcuts shortcuts;
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_DELETE), {}));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_DELETE), {.node = {0, 2}}),
            Shortcut(PanelCommand(Command(Delete{{0, 2}}))));
}

TEST(ShortcutsTest, EscapeAndBackspaceNeedSomethingToLetGoOfOrToClear) {
  Shortcuts shortcuts;
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_ESC), {.sketch = true}));
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_BACKSPACE), {.selection = true}));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_ESC), {.selection = true}),
            Shortcut(PanelCommand(Command(Select{}))));
  EXPECT_EQ(shortcuts.Feed(Press(KEY_BACKSPACE), {.sketch = true}),
            Shortcut(PanelCommand(Command(ClearSketch{}))));
}

TEST(ShortcutsTest, OnlyKeysThatUndoRedoAndLookRepeat) {
  Shortcuts shortcuts;
  const ActedOn all = {.node = {0, 2}, .selection = true, .sketch = true};
  for (const uint32_t code : {KEY_ESC, KEY_BACKSPACE, KEY_DELETE, KEY_ENTER, KEY_1, KEY_D}) {
    KeyEvent held = Press(code);
    EXPECT_TRUE(shortcuts.Feed(held, all)) << code;
    held.repeat = true;
    EXPECT_FALSE(shortcuts.Feed(held, all)) << code;
  }
  KeyEvent nearer = Press(KEY_PAGEUP);
  nearer.repeat = true;
  EXPECT_TRUE(shortcuts.Feed(nearer, {}));
}

TEST(ShortcutsTest, ReleasesAndUnknownKeysMeanNothing) {
  Shortcuts shortcuts;
  EXPECT_FALSE(shortcuts.Feed(Release(KEY_ENTER), {}));
  EXPECT_FALSE(shortcuts.Feed(Press(KEY_TAB), {})) << "between controls it is the panels'";
}

TEST(ShortcutsTest, TheDocumentationListsEveryRow) {
  const auto text = ReadFile(tests::SourceFile("docs/application.md"));
  ASSERT_TRUE(text);
  std::string table = "| keys | do |\n| --- | --- |\n";
  for (const ShortcutRow& row : ShortcutRows()) {
    table.append("| ").append(row.keys).append(" | ").append(row.does).append(" |\n");
  }
  for (const panels::SheetKey& row : panels::SheetKeys()) {
    table.append("| ").append(row.keys).append(" | ").append(row.does).append(" |\n");
  }
  EXPECT_NE(text->find(table), std::string::npos) << "docs/application.md should have\n" << table;
}

}  // namespace
}  // namespace parti::app
