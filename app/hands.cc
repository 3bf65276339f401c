#include "app/hands.h"

#include <algorithm>
#include <cmath>

namespace parti::app {
namespace {

using input::DragPhase;
using input::PenAct;

bool IsFinite(const Vec2& v) { return std::isfinite(v.x) && std::isfinite(v.y); }

template <typename T>
void Erase(std::vector<T>* from, const T& value) {
  from->erase(std::remove(from->begin(), from->end(), value), from->end());
}

}  // namespace

void Hands::SetView(const Camera& camera, Desk desk) {
  camera_ = camera;
  desk_ = std::move(desk);
  for (auto& [number, device] : devices_) device.mapping = MappingOf(device.facts);
}

TabletMapping Hands::MappingOf(const DeviceFacts& facts) const {
  return {facts, camera_, {desk_.left_handed, OwnOutput(facts, desk_.outputs)}};
}

bool Hands::pen_present() const {
  return std::any_of(devices_.begin(), devices_.end(),
                     [](const auto& d) { return d.second.facts.has_pen; });
}

bool Hands::has_keys() const {
  return std::any_of(devices_.begin(), devices_.end(),
                     [](const auto& d) { return d.second.facts.has_keys; });
}

std::vector<Act> Hands::Feed(const InputEvent& event, const OverPanel& over_panel) {
  std::vector<Act> acts;
  const input::Passage passage = palms_.Feed(event);
  for (const TouchEvent& cancelled : passage.cancelled) FeedTouch(cancelled, over_panel, &acts);
  if (!passage.passes) return acts;
  if (const auto* device = std::get_if<DeviceEvent>(&event)) Meet(*device, &acts);
  for (const input::PenDrag& drag : bindings_.Feed(event)) FeedDrag(drag, over_panel, &acts);
  if (const auto* device = std::get_if<DeviceEvent>(&event)) {
    if (device->kind == DeviceEvent::Kind::kRemoved) Forget(device->device);
  } else if (const auto* pen = std::get_if<PenEvent>(&event)) {
    FeedPen(*pen, over_panel, &acts);
  } else if (const auto* touch = std::get_if<TouchEvent>(&event)) {
    FeedTouch(*touch, over_panel, &acts);
  } else if (const auto* scroll = std::get_if<ScrollEvent>(&event)) {
    const Vec2 px = PixelOf(scroll->device, scroll->position_mm);
    if (over_panel(px)) {
      acts.emplace_back(PanelAct{PanelScroll{scroll->steps}});
    } else {
      acts.emplace_back(WheelAct{bindings_.WheelDoes(), px, scroll->steps});
    }
  } else if (const auto* key = std::get_if<KeyEvent>(&event)) {
    acts.emplace_back(PanelAct{*key});
  }
  return acts;
}

std::vector<Act> Hands::LiftAll() {
  std::vector<Act> acts;
  EndDrag(&acts);
  if (on_panel_) {
    dropped_.emplace_back(*on_panel_);
    on_panel_.reset();
    acts.emplace_back(PanelAct{PanelPointerGone{}});
  }
  EndHover(&acts);
  return acts;
}

Hands::Device& Hands::DeviceOf(int number) {
  const auto found = devices_.find(number);
  if (found != devices_.end()) return found->second;
  return devices_.emplace(number, Device{{}, MappingOf({})}).first->second;
}

Vec2 Hands::PixelOf(int device, const Vec2& position_mm) {
  Device& d = DeviceOf(device);
  const Vec2 px = d.mapping.ToView_px(position_mm);
  if (IsFinite(px)) d.last_px = px;
  return d.last_px;
}

void Hands::Meet(const DeviceEvent& event, std::vector<Act>* acts) {
  if (event.kind == DeviceEvent::Kind::kAdded) {
    devices_.insert_or_assign(event.device, Device{event.facts, MappingOf(event.facts)});
    return;
  }
  if (on_panel_ && on_panel_->device == event.device) {
    dropped_.emplace_back(*on_panel_);  // the end of its drag is still to come, and is no press
    on_panel_.reset();
    pointing_ = true;
  }
  EndHover(acts);
}

void Hands::Forget(int device) {
  devices_.erase(device);
  const auto is_of_device = [&](const Contact& c) { return c.device == device; };
  dropped_.erase(std::remove_if(dropped_.begin(), dropped_.end(), is_of_device), dropped_.end());
}

void Hands::FeedPen(const PenEvent& event, const OverPanel& over_panel, std::vector<Act>* acts) {
  if (event.kind == PenEvent::Kind::kProximityOut) {
    EndHover(acts);
    return;
  }
  const Contact contact{event.device, -1};
  if (OnPanel(contact) || Drags(event.device) || bindings_.Doing(event.device)) return;
  Hover(event, over_panel, acts);
}

void Hands::Hover(const PenEvent& event, const OverPanel& over_panel, std::vector<Act>* acts) {
  const Vec2 px = PixelOf(event.device, event.position_mm);
  if (on_panel_) return;
  acts->emplace_back(PanelAct{PanelPointer{px, false}});
  pointing_ = true;
  const bool over = over_panel(px);
  if (!over) {
    hovering_ = true;
    const PenAct would = bindings_.WouldDo(event.device);
    acts->emplace_back(HoverAct{px, would == PenAct::kDraw ? mode_ : would});
  } else if (hovering_) {
    hovering_ = false;
    acts->emplace_back(HoverEndAct{});
  }
}

void Hands::EndHover(std::vector<Act>* acts) {
  if (hovering_) acts->emplace_back(HoverEndAct{});
  if (pointing_ && !on_panel_) acts->emplace_back(PanelAct{PanelPointerGone{}});
  hovering_ = pointing_ = false;
}

void Hands::FeedDrag(const input::PenDrag& drag, const OverPanel& over_panel,
                     std::vector<Act>* acts) {
  const Contact contact{drag.event.device, -1};
  const Vec2 px = PixelOf(drag.event.device, drag.event.position_mm);
  if (drag.phase == DragPhase::kBegin && over_panel(px)) {
    if (on_panel_) {
      dropped_.emplace_back(contact);
      return;
    }
    on_panel_ = contact;
    pointing_ = true;
  }
  if (std::find(dropped_.begin(), dropped_.end(), contact) != dropped_.end()) {
    if (drag.phase == DragPhase::kEnd || drag.phase == DragPhase::kCancel) {
      Erase(&dropped_, contact);
    }
    return;
  }
  if (OnPanel(contact)) {
    const bool over = drag.phase == DragPhase::kEnd || drag.phase == DragPhase::kCancel;
    acts->emplace_back(PanelAct{PanelPointer{px, !over}});
    if (over) on_panel_.reset();
    return;
  }
  const PenAct act = drag.act == PenAct::kDraw ? mode_ : drag.act;
  Drag({drag.phase, act, drag.event.device, px, drag.event.t_s, drag.event.pressure}, acts);
}

void Hands::Drag(const DragAct& act, std::vector<Act>* acts) {
  DragAct sent = act;
  sent.px_per_mm = DeviceOf(act.device).mapping.px_per_mm();
  if (act.phase == DragPhase::kBegin) return BeginDrag(sent, acts);
  if (!Drags(act.device)) return;
  sent.act = drag_->act;  // a tool chosen in mid-drag holds from the next one on
  drag_ = sent;
  if (act.phase != DragPhase::kMove) drag_.reset();
  acts->emplace_back(sent);
}

void Hands::BeginDrag(const DragAct& act, std::vector<Act>* acts) {
  const auto has_pen = [this](int device) { return DeviceOf(device).facts.has_pen; };
  if (drag_ && has_pen(act.device) && !has_pen(drag_->device)) EndDrag(acts);
  if (drag_) return;
  if (hovering_) acts->emplace_back(HoverEndAct{});
  hovering_ = false;
  drag_ = act;
  acts->emplace_back(act);
}

void Hands::EndDrag(std::vector<Act>* acts) {
  if (!drag_) return;
  DragAct lifted = *drag_;
  lifted.phase = DragPhase::kEnd;
  Drag(lifted, acts);
}

void Hands::FeedTouch(const TouchEvent& event, const OverPanel& over_panel,
                      std::vector<Act>* acts) {
  const Contact contact{event.device, event.finger};
  const Vec2 px = PixelOf(event.device, event.position_mm);
  const bool lifts = event.kind == TouchEvent::Kind::kUp || event.kind == TouchEvent::Kind::kCancel;
  if (event.kind == TouchEvent::Kind::kDown && over_panel(px)) {
    if (on_panel_) {
      dropped_.emplace_back(contact);
    } else {
      on_panel_ = contact;
    }
  }
  if (OnPanel(contact)) {
    if (event.kind != TouchEvent::Kind::kCancel) {
      acts->emplace_back(PanelAct{PanelPointer{px, !lifts}});
    }
    if (lifts) {
      acts->emplace_back(PanelAct{PanelPointerGone{}});
      on_panel_.reset();
      pointing_ = false;
    }
    return;
  }
  if (std::find(dropped_.begin(), dropped_.end(), contact) != dropped_.end()) {
    if (lifts) Erase(&dropped_, contact);
    return;
  }
  const double px_per_mm = DeviceOf(event.device).mapping.px_per_mm();
  for (const input::Gesture& gesture : gestures_.Feed({event, px, px_per_mm})) {
    TakeGesture(gesture, acts);
  }
}

void Hands::TakeGesture(const input::Gesture& gesture, std::vector<Act>* acts) {
  if (const auto* draw = std::get_if<input::FingerDraw>(&gesture)) {
    const PenEvent& pen = draw->event;
    Drag({draw->phase, mode_, pen.device, PixelOf(pen.device, pen.position_mm), pen.t_s,
          pen.pressure},
         acts);
  } else if (const auto* orbit = std::get_if<input::OrbitGesture>(&gesture)) {
    acts->emplace_back(*orbit);
  } else if (const auto* pan = std::get_if<input::PanZoomGesture>(&gesture)) {
    acts->emplace_back(*pan);
  } else if (const auto* tap = std::get_if<input::TapGesture>(&gesture)) {
    acts->emplace_back(*tap);
  }
}

}  // namespace parti::app
