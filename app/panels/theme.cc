#include "app/panels/theme.h"

#include <algorithm>
#include <cmath>

namespace parti::app::panels {
namespace {

/// 0xrrggbb as people write it.
constexpr Color Rgb(uint32_t rgb, uint32_t alpha = 255) {
  return ((rgb >> 16) & 255) | (rgb & 0xff00) | ((rgb & 255) << 16) | (alpha << 24);
}

/// The paper of render::Look, and ink on it.
constexpr Palette kLight{
    .panel = Rgb(0xfbf9f4),
    .raised = Rgb(0xf2eee5),
    .hover = Rgb(0xe8e3d7),
    .chosen = Rgb(0xdde3f2),
    .accent = Rgb(0x2b4a9b),
    .note = Rgb(0x2a2823),
    .text = Rgb(0x23211c),
    .quiet = Rgb(0x5c564a),
    .accent_text = Rgb(0x2b4a9b),
    .warning = Rgb(0x9a3412),
    .off = Rgb(0x676153),
    .on_accent = Rgb(0xffffff),
    .on_note = Rgb(0xf6f3ec),
    .hairline = Rgb(0xd8d1c2),
    .shadow = Rgb(0x3a3326, 4),
};

constexpr Palette kDark{
    .panel = Rgb(0x24221f),
    .raised = Rgb(0x312e2a),
    .hover = Rgb(0x3d3934),
    .chosen = Rgb(0x2f3a55),
    .accent = Rgb(0xa9c0fb),
    .note = Rgb(0xece7dc),
    .text = Rgb(0xf0ece3),
    .quiet = Rgb(0xc3bcae),
    .accent_text = Rgb(0xb4c8fc),
    .warning = Rgb(0xf5b08c),
    .off = Rgb(0xb0a99b),
    .on_accent = Rgb(0x17203a),
    .on_note = Rgb(0x23211c),
    .hairline = Rgb(0x4b463f),
    .shadow = Rgb(0x000000, 7),
};

double Luminance(Color color) {
  const auto linear = [&](int shift) {
    const double c = ((color >> shift) & 255) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(0) + 0.7152 * linear(8) + 0.0722 * linear(16);
}

}  // namespace

const Palette& PaletteOf(Theme theme) { return theme == Theme::kDark ? kDark : kLight; }

Color ColorOf(const Palette& palette, Ground ground) {
  switch (ground) {
    case Ground::kPanel:
      return palette.panel;
    case Ground::kRaised:
      return palette.raised;
    case Ground::kHover:
      return palette.hover;
    case Ground::kChosen:
      return palette.chosen;
    case Ground::kAccent:
      return palette.accent;
    case Ground::kNote:
      return palette.note;
  }
  return palette.panel;
}

Color ColorOf(const Palette& palette, Tone tone, Ground ground) {
  if (ground == Ground::kAccent) return palette.on_accent;
  if (ground == Ground::kNote) return palette.on_note;
  switch (tone) {
    case Tone::kText:
      return palette.text;
    case Tone::kQuiet:
      return palette.quiet;
    case Tone::kAccent:
      return palette.accent_text;
    case Tone::kWarning:
      return palette.warning;
    case Tone::kOff:
      return palette.off;
  }
  return palette.text;
}

double Contrast(Color a, Color b) {
  const double x = Luminance(a), y = Luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

double UsedScale(double wanted, const Vec2& size_px) {
  const double room = std::min(size_px.x, size_px.y) / kLeastSide;
  return std::clamp(wanted, 0.25, std::clamp(room, 0.25, 3.0));
}

}  // namespace parti::app::panels
