// Opens the display that was asked for, or the best one that is there.
// Not responsible for what a display does (display.h).
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/display/display.h"
#include "app/display/kms_display.h"
#include "app/display/offscreen_display.h"
#include "app/display/x11_display.h"

namespace parti::app {

/// kBest: a window where DISPLAY names an X server that answers, else the whole screen, but not on
/// a Wayland desktop, whose screen it is.
enum class DisplayKind { kBest, kKms, kX11, kOffscreen };

/// What `--display` may be given: "best", "kms", "x11", "offscreen".
/// errors  kUnknownName  another word;  kGraphics  "wayland", which is not built in, with the way
///         through Xwayland.
Result<DisplayKind> DisplayKindOf(const std::string& word);

/// How each kind should come up.
struct DisplaySpec {
  KmsSpec kms;
  X11Spec x11;
  OffscreenSpec offscreen;
};

/// errors  of the kind that was asked for; of kBest, why there is neither a window nor a screen.
Result<std::unique_ptr<Display>> OpenDisplay(DisplayKind kind, const DisplaySpec& spec = {});

}  // namespace parti::app
