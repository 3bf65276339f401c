#include "app/display/open_display.h"

#include <array>
#include <cstdlib>
#include <utility>

namespace parti::app {
namespace {

constexpr std::array<std::pair<const char*, DisplayKind>, 4> kKinds = {{
    {"best", DisplayKind::kBest},
    {"kms", DisplayKind::kKms},
    {"x11", DisplayKind::kX11},
    {"offscreen", DisplayKind::kOffscreen},
}};

bool IsSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

Result<std::unique_ptr<Display>> OpenOffscreen(const OffscreenSpec& spec) {
  auto opened = OffscreenDisplay::Create(spec);
  if (!opened) return Fail(opened);
  return std::move(*opened);
}

Result<std::unique_ptr<Display>> OpenBest(const DisplaySpec& spec) {
  auto window = OpenX11Display(spec.x11);
  if (window) return window;
  const bool named = IsSet("DISPLAY");
  if (IsSet("WAYLAND_DISPLAY")) {
    // Its screen is in use; and whoever sits there wants a window.
    if (named) return window;
    return Fail(ErrorCode::kGraphics, "this Wayland desktop has no X server (Xwayland)",
                "install the package xwayland and log in again, or use `--display kms` on a free "
                "console (Ctrl+Alt+F3)");
  }
  auto screen = OpenKmsDisplay(spec.kms);
  if (screen) return screen;
  return Fail(screen.error().code,
              window.error().message + "; nor is there a screen: " + screen.error().message,
              named ? window.error().hint : screen.error().hint);
}

}  // namespace

Result<DisplayKind> DisplayKindOf(const std::string& word) {
  std::vector<std::string> words;
  for (const auto& [name, kind] : kKinds) {
    if (word == name) return kind;
    words.emplace_back(name);
  }
  if (word == "wayland") {
    return Fail(ErrorCode::kGraphics, "Parti has no Wayland display of its own",
                "use `--display x11`: Wayland desktops show it through Xwayland, pens included");
  }
  const auto meant = DidYouMean(word, words);
  return Fail(ErrorCode::kUnknownName, "there is no display called \"" + word + "\"",
              meant ? "did you mean " + *meant + "?" : "use best, kms, x11 or offscreen");
}

Result<std::unique_ptr<Display>> OpenDisplay(DisplayKind kind, const DisplaySpec& spec) {
  switch (kind) {
    case DisplayKind::kKms:
      return OpenKmsDisplay(spec.kms);
    case DisplayKind::kX11:
      return OpenX11Display(spec.x11);
    case DisplayKind::kOffscreen:
      return OpenOffscreen(spec.offscreen);
    case DisplayKind::kBest:
      break;
  }
  return OpenBest(spec);
}

}  // namespace parti::app
