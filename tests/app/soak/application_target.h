// The whole application as a soak's target: display in memory, palms, gestures, panels, pictures.
// Its window is small, so that hours of use take minutes.
#pragma once

#include "app/application.h"
#include "app/display/offscreen_display.h"
#include "tests/app/soak/soak_target.h"

namespace parti::tests {

/// Waits for the session where more than a few requests are ahead of it, as a hand would.
class ApplicationTarget : public SoakTarget {
 public:
  explicit ApplicationTarget(const app::SessionThreadOptions& options);

  void Feed(const InputEvent& event) override;
  void Send(const app::SessionRequest& request) override;
  void Resize(const Vec2& size_px) override;
  void TakePen() override;
  std::shared_ptr<const app::SessionSnapshot> Newest() override { return session_.Newest(); }
  std::shared_ptr<const app::SessionSnapshot> Settle() override;

 private:
  void Turn();

  std::unique_ptr<app::OffscreenDisplay> display_;
  app::SessionThread session_;
  std::unique_ptr<app::Application> application_;
};

}  // namespace parti::tests
