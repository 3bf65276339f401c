// The panels around the drawing: views on a session's state that send it commands.
// No logic of the session lives here, and no files, devices or GL: values in, values out.
#pragma once

#include <memory>

#include "app/panels/panel_input.h"
#include "app/panels/panel_output.h"
#include "app/panels/panel_view.h"

namespace parti::app {

/// All panels, with what they remember between frames: which is open, what is being typed, how far
/// a list is scrolled. Dear ImGui's core draws them and keeps one current context for a whole
/// process: all Panels objects are used by one thread.
class Panels {
 public:
  /// errors  kGraphics  no font is installed; names the package.
  static Result<std::unique_ptr<Panels>> Create();
  ~Panels();
  Panels(const Panels&) = delete;
  Panels& operator=(const Panels&) = delete;

  /// One frame: feeds the input, event by event, and draws what `view` says. Without input there
  /// are no commands.
  /// Properties: (1) no input, no command; (2) every command is one that ParseCommand reads back;
  /// (3) any input whatever, in any order, breaks nothing; (4) the same calls give the same output.
  /// cost  about 1 ms with all panels open; the letters are drawn anew when the scale changes
  /// (0.1 s).
  const PanelOutput& Frame(const PanelView& view, const PanelInput& input);

 private:
  class Parts;
  explicit Panels(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace parti::app
