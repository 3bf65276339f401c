// The letters of the panels: Inter, or what fontconfig has instead, drawn into one picture for a
// scale. Where they stand on a panel is ui.h's.
#pragma once

#include <imgui.h>

#include <memory>
#include <string>

#include "base/error.h"
#include "render/image.h"

namespace parti::app::panels {

/// Files of one family, read into memory.
struct FontFiles {
  std::string family;   ///< that was found
  std::string regular;  ///< bytes
  std::string strong;   ///< of its semi-bold, or of the regular one where there is none
};

/// Asks fontconfig for `family`; any other sans with Latin letters where it isn't installed.
/// errors  kGraphics  no font that can be used; the hint names the package.
Result<FontFiles> FindFont(const std::string& family = "Inter");

/// One picture of letters with the fonts that lie in it.
struct Letters {
  std::unique_ptr<ImFontAtlas> atlas;
  ImFont* body = nullptr;    ///< all Latin letters, punctuation, arrows, signs
  ImFont* small = nullptr;   ///< the same, smaller
  ImFont* strong = nullptr;  ///< headings
  std::shared_ptr<const render::Image> picture;
};

/// errors  kGraphics  the files can't be drawn.
Result<Letters> DrawLetters(const FontFiles& files, double scale);

}  // namespace parti::app::panels
