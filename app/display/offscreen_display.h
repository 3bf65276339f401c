// A display in memory, for tests, screenshots and machines without a screen: what is drawn can be
// read, and events, sizes and closing come from whoever holds it.
// Pictures of scenes without an application are render/offscreen.h's.
#pragma once

#include <memory>

#include "app/display/display.h"
#include "render/image.h"
#include "render/offscreen.h"

namespace parti::app {

/// As the view of a display should be.
struct OffscreenSpec {
  glm::ivec2 size_px{1600, 1000};  ///< at least 1 x 1
  double scale = 1;
  render::OffscreenTarget target = render::OffscreenTarget::kBest;
};

/// The framebuffer keeps its content: its age is 1 but for the first frame and after a resize.
class OffscreenDisplay : public Display {
 public:
  /// errors  kGraphics  as CreateOffscreenContext, or too large;  kBadNumber  a size below 1 px.
  static Result<std::unique_ptr<OffscreenDisplay>> Create(const OffscreenSpec& spec = {});

  /// What the next Dispatch gives; all of these may be called from any thread.
  virtual void Inject(const InputEvent& event) = 0;
  virtual void Resize(const glm::ivec2& size_px, double scale) = 0;
  virtual void PlugOutputs(std::vector<OutputPlace> outputs) = 0;
  virtual void AskToClose() = 0;
  virtual void LoseFocus() = 0;
  virtual void SetVisible(bool visible) = 0;
  /// The next Dispatch fails with it, as when a screen is gone.
  virtual void Break(const Error& error) = 0;

  /// The framebuffer as drawn so far. errors  kGraphics.
  virtual Result<render::Image> ReadPixels() = 0;
  /// What the last Present was told.
  virtual const std::vector<render::PixelRect>& presented() const = 0;
  virtual int frames() const = 0;        ///< presented so far
  virtual bool left_handed() const = 0;  ///< as it was told last
};

}  // namespace parti::app
