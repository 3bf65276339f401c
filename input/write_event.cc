// The writer of one event: see event_text.h.
#include <fmt/format.h>

#include "input/event_names.h"
#include "input/event_text.h"
#include "input/line_scanner.h"

namespace parti::input {
namespace {

std::string PairText(const Vec2& v) { return fmt::format("{},{}", v.x, v.y); }

std::string Text(const DeviceEvent& e) {
  std::string line = fmt::format("device {} {} {} name={} vendor={:04x} product={:04x}", e.device,
                                 NameOf(kDeviceKinds, e.kind), e.t_s, Quoted(e.facts.name),
                                 e.facts.vendor, e.facts.product);
  if (e.facts.size_mm) line += " size_mm=" + PairText(*e.facts.size_mm);
  if (e.facts.view_px_per_mm) line += fmt::format(" view_px_per_mm={}", *e.facts.view_px_per_mm);
  for (const Feature& feature : kFeatures) {
    if (e.facts.*feature.flag) line.append(" ").append(feature.word);
  }
  return line;
}

std::string Text(const PenEvent& e) {
  std::string line = fmt::format("pen {} {} {} {}", e.device, NameOf(kPenKinds, e.kind), e.t_s,
                                 PairText(e.position_mm));
  if (e.pressure) line += fmt::format(" p={}", *e.pressure);
  if (e.distance) line += fmt::format(" d={}", *e.distance);
  if (e.tilt_deg) line += " tilt=" + PairText(*e.tilt_deg);
  if (e.tool != PenTool::kPen) line += fmt::format(" tool={}", NameOf(kPenTools, e.tool));
  if (e.button != 0) line += fmt::format(" button={}", e.button);
  if (e.pressed) line += " pressed";
  return line;
}

std::string Text(const TouchEvent& e) {
  return fmt::format("touch {} {} {} {} finger={}", e.device, NameOf(kTouchKinds, e.kind), e.t_s,
                     PairText(e.position_mm), e.finger);
}

std::string Text(const KeyEvent& e) {
  std::string line =
      fmt::format("key {} {} {} {}", e.device, NameOf(kKeyKinds, e.pressed), e.t_s, e.code);
  if (!e.text.empty()) line += " text=" + Quoted(e.text);
  if (e.repeat) line += " repeat";
  return line;
}

std::string Text(const ScrollEvent& e) {
  return fmt::format("scroll {} {} {} {} {}", e.device, kScrollKinds[0], e.t_s,
                     PairText(e.position_mm), PairText(e.steps));
}

}  // namespace

std::string EventText(const InputEvent& event) {
  return std::visit([](const auto& e) { return Text(e); }, event);
}

}  // namespace parti::input
