// A screen without a desktop: modes are set and pages flipped through the kernel's mode setting,
// and OpenGL draws into the pages through GBM. Legacy calls, which every driver has. Not
// responsible for opening the card (a seat's) or for choosing the output (kms_output.h).
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "render/egl_window.h"
#include "render/kms_output.h"

namespace parti::render {

/// Used by one thread. The card's descriptor outlives it, and is the seat's.
class KmsScreen {
 public:
  /// errors  kGraphics  the driver has no GBM, or no OpenGL ES 3.0.
  static Result<std::unique_ptr<KmsScreen>> Create(int card_fd);
  virtual ~KmsScreen() = default;
  KmsScreen() = default;
  KmsScreen(const KmsScreen&) = delete;
  KmsScreen& operator=(const KmsScreen&) = delete;

  /// What frames are drawn with.
  virtual EglWindow& context() = 0;

  /// Draws on this output from now on: the next frame sets the mode. The context is current then.
  /// errors  kGraphics  no pages of that size.
  virtual Result<void> Use(const KmsOutput& output, const drmModeModeInfo& mode) = 0;
  /// Draws on none: it was unplugged.
  virtual void Leave() = 0;
  /// The next frame sets the mode anew: after another console's time, or sleep.
  virtual void SetModeAgain() = 0;

  virtual glm::ivec2 size_px() const = 0;  ///< 0 x 0 while there is no output
  virtual bool flip_pending() const = 0;
  /// errors  kDevice  the kernel refuses: another program drives the screen now.
  virtual Result<void> Present(std::span<const PixelRect> damage) = 0;
  /// The card's descriptor was readable: a flip may be done.
  virtual void HandleEvents() = 0;
  /// Waits for a flip on its way, a tenth of a second at most; before another console comes.
  virtual void Settle() = 0;
};

}  // namespace parti::render
