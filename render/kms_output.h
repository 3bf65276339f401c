// The screens that are plugged into a graphics card, as values, and which of them to draw on.
// Not responsible for showing anything (kms_screen.h).
#pragma once

#include <xf86drmMode.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/math.h"

namespace parti::render {

/// A socket of the card, with what is plugged into it.
struct KmsOutput {
  uint32_t connector = 0;
  std::string name;  ///< as the kernel has it: "eDP-1", "HDMI-A-1", "Virtual-1"
  bool connected = false;
  bool built_in = false;        ///< a laptop's or tablet's own panel
  std::optional<Vec2> size_mm;  ///< of the picture, where the screen says it
  std::vector<drmModeModeInfo> modes;
  std::vector<uint32_t> crtcs;  ///< which may drive it, the one that does so now first
};

/// Reads them anew, which may take the tenths of a second that a screen needs to answer.
/// errors  kDevice  the card has no screens: it only computes.
Result<std::vector<KmsOutput>> ReadKmsOutputs(int card_fd);

/// The size of a picture, from what the kernel makes of a screen's EDID. Nothing for none, and for
/// what is no size but a shape: 16:9 and 16:10, which televisions and projectors put in its place,
/// as millimetres or as centimetres.
std::optional<Vec2> SizeOf_mm(uint32_t width_mm, uint32_t height_mm);

/// Which output to draw on, as an index; nothing where none is connected and has a mode.
///
/// wanted      the name of one; "" for any. Nothing else will do while it is named.
/// pens_mm     areas of the display tablets that are there; opaque ones have no screen. One of the
///             same size (to kSamePart) is the tablet's own, and comes before a built-in one, which
///             comes before others.
std::optional<size_t> ChooseOutput(std::span<const KmsOutput> outputs, const std::string& wanted,
                                   std::span<const Vec2> pens_mm);

/// The mode that the screen prefers, else its largest, fastest; nothing where it has none.
std::optional<drmModeModeInfo> ChooseMode(const KmsOutput& output);

/// How much larger than at 96 px an inch things should be drawn, in quarters, from 1 to 3; 1 where
/// the screen does not say its size, or says nonsense (no finer than 400, no coarser than 50 px an
/// inch).
double ScaleOf(const Vec2& size_px, const std::optional<Vec2>& size_mm);

/// By how much screen and pen may differ and still be one device: EDIDs count centimetres.
inline constexpr double kSamePart = 0.06;

}  // namespace parti::render
