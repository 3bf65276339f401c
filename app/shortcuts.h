// Keys that act wherever the pointer is: everything that gestures and panels do has one. One table
// is read by the application and by docs/application.md's test.
// Not responsible for typing, and for moving between controls with Tab and arrows (panels').
#pragma once

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "app/panels/panel_output.h"
#include "base/event.h"

namespace parti::app {

/// Orbits the camera as a drag of so many pixels would.
struct TurnView {
  Vec2 delta_px{0, 0};
  bool operator==(const TurnView&) const = default;
};

using Shortcut = std::variant<PanelCommand, TurnView>;

/// What there is for keys to act on; one whose part is missing means nothing.
struct ActedOn {
  std::vector<int> node = {};  ///< path of the node in hand, where a person sees it; empty: none
  bool selection = false;      ///< shapes are selected, or a query is chosen for the sketch
  bool sketch = false;         ///< strokes wait for a pick, or a query is chosen for them
};

/// One row of the table, as people read it.
struct ShortcutRow {
  std::string_view keys;  ///< "Ctrl+Z"
  std::string_view does;  ///< "undo"
};

/// All of them, in the order of the documentation.
std::vector<ShortcutRow> ShortcutRows();

/// A value that watches ctrl and shift; feed it every key.
class Shortcuts {
 public:
  /// What a press means now; nothing for releases and for keys that mean nothing (they are the
  /// panels'). Of held keys only those repeat that undo, redo and look.
  std::optional<Shortcut> Feed(const KeyEvent& key, const ActedOn& on);

 private:
  bool ctrl_left_ = false, ctrl_right_ = false, shift_left_ = false, shift_right_ = false;
};

}  // namespace parti::app
