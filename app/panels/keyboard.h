// A keyboard on the screen, for tablets without another: it types into the field that is active.
// Which field that is, and what becomes of the text, is ui.h's.
#pragma once

#include <string>
#include <vector>

#include "app/panels/box.h"
#include "app/panels/icons.h"
#include "base/event.h"

namespace parti::app::panels {

class Ui;

/// A key in its place. `text` is what it types; keys without text have a code, or turn a page.
struct ScreenKey {
  std::string name;  ///< of its target
  std::string text;
  uint32_t code = 0;
  Icon icon = Icon::kNone;
  Box box;
};

/// State and look of the keyboard: pages of small letters, of capitals, and two of signs, which
/// have every character of ASCII that can be printed. Presses are told to it by its owner, so that
/// the field keeps the focus.
class ScreenKeyboard {
 public:
  /// Back to small letters.
  void Reset();

  /// How high it is, px, for a scale.
  static float Height(double scale);
  /// Where its keys are in `box`.
  std::vector<ScreenKey> Keys(const Box& box, double scale) const;
  /// A finger or pen came down: what was typed; empty where there is no key, or only its page
  /// turned.
  std::vector<KeyEvent> Press(const Vec2& at_px, const Box& box, double scale);
  void Release() { held_.clear(); }

  /// Draws it as a sheet.
  void Draw(Ui* ui, const Box& box) const;

 private:
  enum class Page : uint8_t { kSmall, kCapital, kSigns, kMoreSigns };
  bool signs() const { return page_ == Page::kSigns || page_ == Page::kMoreSigns; }
  bool Turn(const std::string& key);

  Page page_ = Page::kSmall;
  std::string held_;  ///< name of the key that is down
};

}  // namespace parti::app::panels
