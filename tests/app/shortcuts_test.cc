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
  EXPECT_EQ(shortcuts.Feed(Press(KEY_DELETE), {0, 2}),
            Shortcut(PanelCommand(Command(Delete{{0, 2}}))));
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
