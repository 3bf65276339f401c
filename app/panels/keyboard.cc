#include "app/panels/keyboard.h"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <array>

#include "app/panels/ui.h"

namespace parti::app::panels {
namespace {

using Rows = std::array<std::string_view, 3>;
constexpr Rows kSmallRows = {"qwertyuiop", "asdfghjkl", "zxcvbnm"};
constexpr Rows kCapitalRows = {"QWERTYUIOP", "ASDFGHJKL", "ZXCVBNM"};
/// What numbers, names, paths and queries are made of.
constexpr Rows kSignRows = {"1234567890", "-_/#:()>~", "+*=\"'!?"};
/// What rules are made of besides; some signs again, so that few lines need both pages.
constexpr Rows kMoreSignRows = {"{}[]<>|&@;", "%$^`\\-:()", "+*=\"'!?"};

constexpr float kRow = 48;      ///< height of a row with its gap, units
constexpr float kWidest = 760;  ///< of the keyboard, units
constexpr float kColumns = 10;  ///< keys in the widest row

/// What a held key is to be followed by: its release.
std::vector<KeyEvent> Stroke(uint32_t code, const std::string& text) {
  return {KeyEvent{.code = code, .pressed = true, .text = text},
          KeyEvent{.code = code, .pressed = false}};
}

ScreenKey KeyOf(char letter, const Box& box) {
  const std::string text(1, letter);
  return {text, text, KEY_UNKNOWN, Icon::kNone, box};
}

/// What stands on keys without an icon, some of which type nothing.
std::string LabelOf(const ScreenKey& key, bool signs, bool more_signs) {
  if (key.name == "Signs") return signs ? "abc" : "123";
  if (key.name == "More signs") return more_signs ? "123" : "{ }";
  return key.text;
}

}  // namespace

void ScreenKeyboard::Reset() {
  page_ = Page::kSmall;
  held_.clear();
}

float ScreenKeyboard::Height(double scale) {
  return static_cast<float>(scale) * (4 * kRow + kMeasures.gap);
}

std::vector<ScreenKey> ScreenKeyboard::Keys(const Box& box, double scale) const {
  const auto u = [&](float units) { return static_cast<float>(units * scale); };
  const float gap = u(kMeasures.gap);
  const float width = std::min(box.width() - gap, u(kWidest));
  const float key = width / kColumns - gap, high = u(kRow) - gap;
  Box rest = BoxAt(box.middle_x() - width / 2, box.y0 + gap, width, box.height());
  const Rows& rows = page_ == Page::kSigns       ? kSignRows
                     : page_ == Page::kMoreSigns ? kMoreSignRows
                     : page_ == Page::kCapital   ? kCapitalRows
                                                 : kSmallRows;
  std::vector<ScreenKey> keys;
  for (size_t i = 0; i < rows.size(); ++i) {
    Box row = rest.CutTop(high, gap);
    const auto n = static_cast<float>(rows[i].size());
    row.CutLeft((row.width() - n * (key + gap) + gap) / 2);
    if (i == 2) {  // beside the shortest row: capitals or the other signs, and backspace
      const float side = key * 1.3f;
      keys.push_back({signs() ? "More signs" : "Capitals", "", 0,
                      signs() ? Icon::kNone : Icon::kShift,
                      BoxAt(row.x0 - side - gap, row.y0, side, high)});
      keys.push_back({"Backspace", "", KEY_BACKSPACE, Icon::kBackspace,
                      BoxAt(row.x0 + n * (key + gap), row.y0, side, high)});
    }
    for (const char letter : rows[i]) keys.push_back(KeyOf(letter, row.CutLeft(key, gap)));
  }
  Box last = rest.CutTop(high, gap);
  last.x0 += gap / 2;
  keys.push_back({"Signs", "", 0, Icon::kNone, last.CutLeft(key * 1.5f, gap)});
  keys.push_back(KeyOf(',', last.CutLeft(key, gap)));
  keys.push_back({"Enter", "", KEY_ENTER, Icon::kEnter, last.CutRight(key * 1.5f, gap)});
  keys.push_back({"Give up", "", KEY_ESC, Icon::kClose, last.CutRight(key, gap)});
  keys.push_back(KeyOf('.', last.CutRight(key, gap)));
  keys.push_back({"Space", " ", KEY_SPACE, Icon::kNone, last});
  return keys;
}

std::vector<KeyEvent> ScreenKeyboard::Press(const Vec2& at_px, const Box& box, double scale) {
  const std::vector<ScreenKey> keys = Keys(box, scale);
  const auto key = std::find_if(keys.begin(), keys.end(),
                                [&](const ScreenKey& k) { return k.box.Contains(at_px); });
  if (key == keys.end()) return {};
  held_ = key->name;
  if (Turn(key->name)) return {};
  if (page_ == Page::kCapital) page_ = Page::kSmall;  // one capital at a time
  return Stroke(key->code, key->text);
}

/// Turns to the page that a key is for; false for keys that type.
bool ScreenKeyboard::Turn(const std::string& key) {
  if (key == "Signs") {
    page_ = signs() ? Page::kSmall : Page::kSigns;
  } else if (key == "More signs") {
    page_ = page_ == Page::kSigns ? Page::kMoreSigns : Page::kSigns;
  } else if (key == "Capitals") {
    page_ = page_ == Page::kSmall ? Page::kCapital : Page::kSmall;
  } else {
    return false;
  }
  return true;
}

void ScreenKeyboard::Draw(Ui* ui, const Box& box) const {
  ui->BeginSheet("Keyboard", box);
  for (const ScreenKey& key : Keys(box, ui->scale())) {
    const bool chosen = key.name == "Capitals" && page_ == Page::kCapital;
    const Ground ground = chosen              ? Ground::kChosen
                          : key.name == held_ ? Ground::kHover
                                              : Ground::kRaised;
    ui->Fill(key.box, ground, kMeasures.small_radius);
    ui->Border(key.box, kMeasures.small_radius);
    ui->Picture(key.icon, key.box, Tone::kText, ground);
    if (key.icon == Icon::kNone) {
      ui->Text(LabelOf(key, signs(), page_ == Page::kMoreSigns), key.box,
               {Letter::kBody, Tone::kText, ground, 0.5f});
    }
    ui->NoteTarget(key.name, key.box);
  }
  ui->EndSheet();
}

}  // namespace parti::app::panels
