#include "app/shortcuts.h"

#include <linux/input-event-codes.h>

#include <array>

namespace parti::app {
namespace {

constexpr int kCtrl = 1, kShift = 2;
constexpr double kTurn_px = 40;  ///< of a press of an arrow; held keys repeat

enum class Meaning : uint8_t {
  kUndo,
  kRedo,
  kClear,
  kPick,
  kDelete,
  kUnselect,
  kNew,
  kView,
  kMode,
  kTurn,
};

struct Row {
  std::string_view keys, does;  // empty `does`: belongs to the row before
  uint32_t code;
  int held;
  Meaning meaning;
  int which = 0;  // of the meaning
  Vec2 turn{0, 0};
};

int Of(ViewRequest view) { return static_cast<int>(view); }
int Of(PointerMode mode) { return static_cast<int>(mode); }

const std::vector<Row>& Rows() {
  static const std::vector<Row> rows = {
      {"Ctrl+Z", "undo", KEY_Z, kCtrl, Meaning::kUndo},
      {"Ctrl+Shift+Z, Ctrl+Y", "redo", KEY_Z, kCtrl | kShift, Meaning::kRedo},
      {"", "", KEY_Y, kCtrl, Meaning::kRedo},
      {"Enter", "accept the first suggestion", KEY_ENTER, 0, Meaning::kPick, 1},
      {"1 to 9", "accept the suggestion of that number", KEY_1, 0, Meaning::kPick, 1},
      {"", "", KEY_2, 0, Meaning::kPick, 2},
      {"", "", KEY_3, 0, Meaning::kPick, 3},
      {"", "", KEY_4, 0, Meaning::kPick, 4},
      {"", "", KEY_5, 0, Meaning::kPick, 5},
      {"", "", KEY_6, 0, Meaning::kPick, 6},
      {"", "", KEY_7, 0, Meaning::kPick, 7},
      {"", "", KEY_8, 0, Meaning::kPick, 8},
      {"", "", KEY_9, 0, Meaning::kPick, 9},
      {"Backspace", "clear the sketch", KEY_BACKSPACE, 0, Meaning::kClear},
      {"Escape", "let go of selected shapes", KEY_ESC, 0, Meaning::kUnselect},
      {"Delete", "delete the node in hand", KEY_DELETE, 0, Meaning::kDelete},
      {"Ctrl+N", "a new drawing", KEY_N, kCtrl, Meaning::kNew},
      {"D", "the pen draws", KEY_D, 0, Meaning::kMode, Of(PointerMode::kDraw)},
      {"E", "the pen erases", KEY_E, 0, Meaning::kMode, Of(PointerMode::kErase)},
      {"S", "the pen selects", KEY_S, 0, Meaning::kMode, Of(PointerMode::kSelect)},
      {"O", "the pen orbits", KEY_O, 0, Meaning::kMode, Of(PointerMode::kOrbit)},
      {"P", "the pen pans", KEY_P, 0, Meaning::kMode, Of(PointerMode::kPan)},
      {"Z", "the pen zooms", KEY_Z, 0, Meaning::kMode, Of(PointerMode::kZoom)},
      {"Shift+arrows", "orbit", KEY_LEFT, kShift, Meaning::kTurn, 0, {-kTurn_px, 0}},
      {"", "", KEY_RIGHT, kShift, Meaning::kTurn, 0, {kTurn_px, 0}},
      {"", "", KEY_UP, kShift, Meaning::kTurn, 0, {0, -kTurn_px}},
      {"", "", KEY_DOWN, kShift, Meaning::kTurn, 0, {0, kTurn_px}},
      {"Page up", "nearer", KEY_PAGEUP, 0, Meaning::kView, Of(ViewRequest::kNearer)},
      {"Page down", "farther", KEY_PAGEDOWN, 0, Meaning::kView, Of(ViewRequest::kFarther)},
      {"Home", "see all of it", KEY_HOME, 0, Meaning::kView, Of(ViewRequest::kFit)},
  };
  return rows;
}

Shortcut ShortcutOf(const Row& row, const std::vector<int>& in_hand) {
  switch (row.meaning) {
    case Meaning::kUndo:
      return Command(Undo{});
    case Meaning::kRedo:
      return Command(Redo{});
    case Meaning::kClear:
      return Command(ClearSketch{});
    case Meaning::kPick:
      return Command(Pick{row.which, {}});
    case Meaning::kDelete:
      return Command(Delete{in_hand});
    case Meaning::kUnselect:
      return Command(Select{});
    case Meaning::kNew:
      return DocumentRequest{DocumentRequest::Kind::kNew};
    case Meaning::kView:
      return static_cast<ViewRequest>(row.which);
    case Meaning::kMode:
      return static_cast<PointerMode>(row.which);
    case Meaning::kTurn:
      return TurnView{row.turn};
  }
  return TurnView{};
}

/// Whether there is what it acts on, and a key that is still held means it once more.
bool Acts(Meaning meaning, bool repeat, const ActedOn& on) {
  switch (meaning) {
    case Meaning::kDelete:
      return !repeat && !on.node.empty();
    case Meaning::kUnselect:
      return !repeat && on.selection;
    case Meaning::kClear:
      return !repeat && on.sketch;
    case Meaning::kPick:
    case Meaning::kNew:
    case Meaning::kMode:
      return !repeat;
    case Meaning::kUndo:
    case Meaning::kRedo:
    case Meaning::kView:
    case Meaning::kTurn:
      return true;
  }
  return true;
}

}  // namespace

std::vector<ShortcutRow> ShortcutRows() {
  std::vector<ShortcutRow> shown;
  for (const Row& row : Rows()) {
    if (!row.does.empty()) shown.push_back({row.keys, row.does});
  }
  return shown;
}

std::optional<Shortcut> Shortcuts::Feed(const KeyEvent& key, const ActedOn& on) {
  if (key.code == KEY_LEFTCTRL) ctrl_left_ = key.pressed;
  if (key.code == KEY_RIGHTCTRL) ctrl_right_ = key.pressed;
  if (key.code == KEY_LEFTSHIFT) shift_left_ = key.pressed;
  if (key.code == KEY_RIGHTSHIFT) shift_right_ = key.pressed;
  if (!key.pressed) return std::nullopt;
  const int held =
      (ctrl_left_ || ctrl_right_ ? kCtrl : 0) | (shift_left_ || shift_right_ ? kShift : 0);
  for (const Row& row : Rows()) {
    if (row.code != key.code || row.held != held) continue;
    if (!Acts(row.meaning, key.repeat, on)) return std::nullopt;
    return ShortcutOf(row, on.node);
  }
  return std::nullopt;
}

}  // namespace parti::app
