// A whole screen without a desktop: KMS for the picture, a seat for the right to it, libinput for
// pens, fingers, mice and keys. Joins render/kms_screen.h, seat.h and input/libinput_source.h.
#pragma once

#include <memory>
#include <string>

#include "app/display/display.h"

namespace parti::app {

/// Which screen; empty texts mean the best one (render::ChooseOutput).
struct KmsSpec {
  std::string card;    ///< "/dev/dri/card1"
  std::string output;  ///< "HDMI-A-1"
};

/// Ctrl+Alt+F1 to F12 go to other consoles, Ctrl+Alt+Backspace asks to close. While another console
/// is in front the display is hidden and its devices are gone; no screen at all hides it, too.
/// errors  kDevice  no seat, no screen that may be used, another program that drives it, no right
///         to read input devices: each with its remedy;  kGraphics  no OpenGL ES 3.0 on it.
Result<std::unique_ptr<Display>> OpenKmsDisplay(const KmsSpec& spec = {});

}  // namespace parti::app
