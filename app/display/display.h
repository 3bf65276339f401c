// Where Parti is seen and what it is steered with: a screen of one's own (KMS), a window (X11), or
// a picture in memory (offscreen). The application's loop knows this and nothing of the kinds.
// Not responsible for what is drawn (render/canvas.h) or for what events mean.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/tablet_mapping.h"
#include "base/error.h"
#include "base/event.h"
#include "render/gl_context.h"
#include "render/pixel_rect.h"

namespace parti::app {

/// What happened since the last Dispatch.
struct DisplayNews {
  std::vector<InputEvent> input;  ///< in order, times never decreasing
  bool resized = false;           ///< size_px(), scale() or outputs() are others than before
  bool exposed = false;           ///< what was shown is lost: draw the whole picture
  bool close_asked = false;       ///< the user wants the program to end
  bool hidden = false;            ///< nobody sees it any more: another console, an icon
  bool shown = false;             ///< it is seen again, or for the first time
  bool focus_lost = false;        ///< keys go elsewhere from now on: none is held any more
};

/// Used by one thread, the one that created it. A display's context is made current by BeginFrame
/// and stays so until another is; for uploads in between, call context().MakeCurrent().
class Display {
 public:
  /// What to draw a frame into.
  struct Target {
    /// GL_RGBA8 or a window's like of it, without multisampling and depth, rows from the bottom: as
    /// render::Canvas wants it. Bytes are shown as sRGB; GL converts nothing.
    GLuint framebuffer = 0;
    /// What it holds already: the frame presented `age` frames ago (1: the last one), 0: nothing
    /// that can be relied on.
    int age = 0;
  };

  virtual ~Display() = default;
  Display() = default;
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

  /// What frames are drawn with, and its functions; valid as long as the display.
  virtual render::GlContext& context() = 0;
  virtual const render::Gl& gl() const = 0;
  /// A context for another thread that shares context()'s textures. errors  kGraphics.
  Result<std::unique_ptr<render::GlContext>> CreateSharedContext() {
    return context().CreateShared();
  }

  /// Of the view, at least 1 x 1.
  virtual glm::ivec2 size_px() const = 0;
  /// How much larger than at 96 px an inch things should be drawn: 1, 1.5, 2 …
  virtual double scale() const = 0;
  /// Of the view as it is seen, where the screen says it.
  virtual std::optional<Vec2> size_mm() const = 0;
  /// The screens that are plugged in, and where they show the view; empty where a desktop keeps
  /// them to itself. News::resized says that they are others.
  virtual std::vector<OutputPlace> outputs() const { return {}; }
  /// Swaps the buttons of mice and touchpads, where the display reads them itself; a desktop does
  /// it by its own settings.
  virtual void SetLeftHanded(bool left_handed) = 0;
  /// Whether the system shows a pointer of its own over the view.
  virtual bool shows_pointer() const = 0;
  /// "kms", "x11" or "offscreen".
  virtual std::string_view name() const = 0;
  /// What it runs on, for a line in a terminal: "X11 window on :0, llvmpipe".
  virtual std::string Description() const = 0;
  /// What stands above a window, in UTF-8; nothing where there is none.
  virtual void SetTitle(const std::string& title) = 0;

  /// Whether a frame would be seen now and can be begun without waiting: no flip is pending, the
  /// view is visible. It changes only within Dispatch and Present.
  virtual bool CanDraw() const = 0;
  /// Makes the context current. Only while CanDraw. errors  kGraphics  the screen is lost.
  virtual Result<Target> BeginFrame() = 0;
  /// Shows what has been drawn since BeginFrame, without waiting for the screen; `damage` is what
  /// differs from the last frame presented. errors  kGraphics, kDevice  the screen is lost.
  virtual Result<void> Present(std::span<const render::PixelRect> damage) = 0;

  /// Readable when Dispatch has something to do; they may be others after a Dispatch.
  virtual std::vector<int> fds() const = 0;
  /// Whether Dispatch has something to do although no fd is readable: ask before waiting.
  virtual bool HasNews() const = 0;
  /// Never waits. errors  kDevice  the screen or the seat is gone for good: save and end.
  virtual Result<DisplayNews> Dispatch() = 0;
};

}  // namespace parti::app
