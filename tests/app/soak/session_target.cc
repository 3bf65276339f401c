#include "tests/app/soak/session_target.h"

#include <poll.h>

#include "app/tablet_mapping.h"

namespace parti::tests {

void SessionTarget::Feed(const InputEvent& event) {
  const auto* device = std::get_if<DeviceEvent>(&event);
  if (device != nullptr && device->kind == DeviceEvent::Kind::kAdded) {
    devices_[device->device] = device->facts;
  }
  const auto stroke = machine_.Feed(event);
  if (!stroke || stroke->tool == PenTool::kEraser) return;
  const app::TabletMapping mapping(devices_[stroke->device], Newest()->state->camera);
  Send(mapping.ToView(*stroke));
}

void SessionTarget::Send(const app::SessionRequest& request) {
  constexpr uint64_t kAhead = 20;
  last_ = thread_.Post(request);
  if (last_ > kAhead) WaitFor(last_ - kAhead, false);
}

void SessionTarget::Resize(const Vec2& size_px) {
  app::SetView view{Newest()->state->camera};
  view.camera.width_px = size_px.x;
  view.camera.height_px = size_px.y;
  Send(app::Command(view));
}

std::shared_ptr<const app::SessionSnapshot> SessionTarget::Settle() { return WaitFor(last_, true); }

std::shared_ptr<const app::SessionSnapshot> SessionTarget::WaitFor(uint64_t number, bool written) {
  while (true) {
    auto newest = thread_.Newest();
    if (newest->executed >= number && (!written || newest->acknowledged >= number)) return newest;
    pollfd news{thread_.ready().fd(), POLLIN, 0};
    ::poll(&news, 1, 1000);
    thread_.ready().Clear();
  }
}

}  // namespace parti::tests
