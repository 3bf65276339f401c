// The session thread as a soak's target: strokes from events as the application makes them, without
// display, gestures and panels.
#pragma once

#include <map>

#include "app/session_thread.h"
#include "input/strokes_from_events.h"
#include "tests/app/soak/soak_target.h"

namespace parti::tests {

/// Waits for the session where more than a few requests are ahead of it, as a hand would.
class SessionTarget : public SoakTarget {
 public:
  explicit SessionTarget(const app::SessionThreadOptions& options) : thread_(options) {}

  void Feed(const InputEvent& event) override;
  void Send(const app::SessionRequest& request) override;
  void Resize(const Vec2& size_px) override;
  void TakePen() override {}
  std::shared_ptr<const app::SessionSnapshot> Newest() override { return thread_.Newest(); }
  std::shared_ptr<const app::SessionSnapshot> Settle() override;

 private:
  std::shared_ptr<const app::SessionSnapshot> WaitFor(uint64_t number, bool written);

  app::SessionThread thread_;
  input::StrokesFromEvents machine_;
  std::map<int, DeviceFacts> devices_;
  uint64_t last_ = 0;
};

}  // namespace parti::tests
