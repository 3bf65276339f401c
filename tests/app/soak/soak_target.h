// What the soak plays with: the session alone, or the whole application around it.
// What is played is soak_mix.h's.
#pragma once

#include <memory>

#include "app/session_snapshot.h"
#include "base/event.h"

namespace parti::tests {

/// Everything may be called at any time, with any values.
class SoakTarget {
 public:
  virtual ~SoakTarget() = default;

  /// What a device sends; comes and goes of devices among it.
  virtual void Feed(const InputEvent& event) = 0;
  /// What a panel sends.
  virtual void Send(const app::SessionRequest& request) = 0;
  /// The window has another size, at least 1 x 1; nothing for a target without one.
  virtual void Resize(const Vec2& size_px) = 0;
  /// The pen draws again, whatever tool was tapped; nothing for a target without tools.
  virtual void TakePen() = 0;
  /// What came of it so far; never null.
  virtual std::shared_ptr<const app::SessionSnapshot> Newest() = 0;
  /// Waits until everything is executed and written.
  virtual std::shared_ptr<const app::SessionSnapshot> Settle() = 0;
};

}  // namespace parti::tests
