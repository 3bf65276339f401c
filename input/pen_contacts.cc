#include "input/pen_contacts.h"

#include <algorithm>

namespace parti::input {

ContactChange PenContacts::Feed(const InputEvent& event) {
  if (const auto* pen = std::get_if<PenEvent>(&event)) return Feed(*pen);
  if (const auto* device = std::get_if<DeviceEvent>(&event)) {
    if (Lift(device->device)) return {.ended = StrokeEnd::kDeviceRemoved};
  }
  return {};
}

ContactChange PenContacts::Feed(const PenEvent& event) {
  ContactChange change;
  switch (event.kind) {
    case PenEvent::Kind::kDown:
      if (Lift(event.device)) change.ended = StrokeEnd::kPenUp;
      down_.push_back(event.device);
      change.began = true;
      break;
    case PenEvent::Kind::kUp:
      if (Lift(event.device)) change.ended = StrokeEnd::kPenUp;
      break;
    case PenEvent::Kind::kProximityIn:
    case PenEvent::Kind::kProximityOut:
      if (Lift(event.device)) change.ended = StrokeEnd::kProximityOut;
      break;
    case PenEvent::Kind::kMotion:
      change.moved = IsDown(event.device);
      break;
    case PenEvent::Kind::kButton:
      break;
  }
  return change;
}

bool PenContacts::IsDown(int device) const {
  return std::find(down_.begin(), down_.end(), device) != down_.end();
}

bool PenContacts::Lift(int device) { return std::erase(down_, device) > 0; }

}  // namespace parti::input
