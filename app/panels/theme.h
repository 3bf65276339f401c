// Colours and sizes of the panels: an architect's desk, by day and by lamp light.
// One accent, the blue of the ink; warnings have a colour of their own. Drawing is ui.h's.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "app/settings.h"
#include "base/math.h"

namespace parti::app::panels {

/// As UiVertex::rgba.
using Color = uint32_t;

/// What things lie on.
enum class Ground : uint8_t {
  kPanel,   ///< a sheet on the drawing
  kRaised,  ///< a button, a field, a card
  kHover,   ///< what the pointer is over
  kChosen,  ///< switched on, taken in hand
  kAccent,  ///< the one thing to do next
  kNote,    ///< a tooltip
};

/// What is written or drawn on them.
enum class Tone : uint8_t { kText, kQuiet, kAccent, kWarning, kOff };

/// The colours of a theme.
struct Palette {
  Color panel, raised, hover, chosen, accent, note;  ///< grounds
  Color text, quiet, accent_text, warning, off;      ///< on all grounds but kAccent, kNote
  Color on_accent, on_note;                          ///< on those two, whatever the tone
  Color hairline;                                    ///< borders and rules
  Color shadow;                                      ///< under sheets
};

/// One of the two.
const Palette& PaletteOf(Theme theme);

/// Never fails: every ground has a colour, every tone one that can be read on it.
Color ColorOf(const Palette& palette, Ground ground);
Color ColorOf(const Palette& palette, Tone tone, Ground ground);

/// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, in [1, 21]; alpha is not looked at (WCAG
/// 2.1, 1.4.3).
double Contrast(Color a, Color b);

/// The least contrast of text with what it lies on: WCAG's AA for small text.
inline constexpr double kLeastContrast = 4.5;

/// Sizes in units that a scale multiplies: pixels at 1x. Chosen by looking, but for `target`.
struct Measures {
  float target = 44;       ///< least side of what can be tapped: 9 mm at 1x on usual screens
  float gap = 4;           ///< between neighbours
  float pad = 12;          ///< inside sheets, and from the window's edge
  float radius = 8;        ///< of sheets' corners
  float small_radius = 6;  ///< of buttons' corners
  float icon = 22;         ///< side of an icon
  float stroke = 1.6f;     ///< of an icon's lines
  float body = 15;         ///< size of letters [em]
  float small = 13;        ///< of what is said beside
  float column = 332;      ///< width of the rules' sheet
  float sheet = 380;       ///< width of sheets that open under a button
  float card = 264;        ///< width of a suggestion
  float reach = 120;       ///< from the drawing pen: what is nearer steps aside
};
inline constexpr Measures kMeasures;

/// The scale that is used: what is set, less in windows too small for it: both sides have at least
/// kLeastSide units, a little more than what the narrowest panels need.
double UsedScale(double wanted, const Vec2& size_px);
inline constexpr double kLeastSide = 490;

}  // namespace parti::app::panels
