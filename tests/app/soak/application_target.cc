#include "tests/app/soak/application_target.h"

#include <algorithm>

#include "app/play.h"
#include "base/check.h"

namespace parti::tests {

constexpr glm::ivec2 kSize_px{480, 360};

ApplicationTarget::ApplicationTarget(const app::SessionThreadOptions& options) : session_(options) {
  auto display = app::OffscreenDisplay::Create({kSize_px});
  CHECK(display.has_value(), "a display in memory");
  display_ = std::move(*display);
  auto application = app::Application::Create(display_.get(), &session_, {});
  CHECK(application.has_value(), "an application on it");
  application_ = std::move(*application);
}

void ApplicationTarget::Turn() {
  const auto turned = application_->Turn(0);
  CHECK(turned.has_value(), "the display stays");
}

void ApplicationTarget::Feed(const InputEvent& event) {
  display_->Inject(event);
  Turn();
}

void ApplicationTarget::Send(const app::SessionRequest& request) {
  if (const auto* command = std::get_if<app::Command>(&request)) {
    application_->Do(app::PanelCommand(*command));
  } else if (const auto* document = std::get_if<app::DocumentRequest>(&request)) {
    application_->Do(app::PanelCommand(*document));
  } else {
    session_.Post(request);
  }
  Turn();
}

void ApplicationTarget::Resize(const Vec2& size_px) {
  // Of any shape, but small: llvmpipe paints every size that the mix thinks of.
  const Vec2 small = glm::clamp(size_px / 4.0, Vec2(1), Vec2(kSize_px));
  display_->Resize(glm::ivec2(small), 1);
  Turn();
}

void ApplicationTarget::TakePen() {
  application_->Do(app::PanelCommand(app::PointerMode::kDraw));
  Turn();
}

std::shared_ptr<const app::SessionSnapshot> ApplicationTarget::Settle() {
  const auto settled = app::Settle(application_.get(), 300);
  CHECK(settled.has_value(), "the application comes to rest");
  while (true) {
    const auto newest = session_.Newest();
    if (newest->acknowledged >= newest->executed && !newest->busy) return newest;
    CHECK(application_->Turn(0.05).has_value(), "the display stays");
  }
}

}  // namespace parti::tests
