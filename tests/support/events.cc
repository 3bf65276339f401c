#include "tests/support/events.h"

#include <array>
#include <string>

#include "base/stroke.h"

namespace parti::tests {
namespace {

using input::Drawing;
using input::DrawingRules;

int Int(int low, int high) { return *rc::gen::inRange(low, high + 1); }
bool Coin() { return *rc::gen::arbitrary<bool>(); }
/// Numbers as devices give them: multiples of a unit, so that many are equal, and none is tame.
double Number(double low, double high) { return low + (high - low) * Int(0, 4095) / 4095.0; }
Vec2 Position() { return {Number(-10, 600), Number(-10, 340)}; }

DeviceFacts AnyFacts() {
  DeviceFacts facts;
  facts.name = *rc::gen::arbitrary<std::string>();
  facts.vendor = static_cast<uint32_t>(Int(0, 0xffff));
  facts.product = static_cast<uint32_t>(Int(0, 0xffff));
  if (Coin()) facts.size_mm = Vec2(Number(0, 600), Number(0, 340));
  facts.has_pen = Coin();
  facts.has_touch = Coin();
  facts.has_pressure = Coin();
  facts.has_tilt = Coin();
  facts.has_distance = Coin();
  facts.has_eraser = Coin();
  facts.has_pointer = Coin();
  facts.has_keys = Coin();
  facts.has_display = Coin();
  if (Coin()) facts.view_px_per_mm = Number(0.5, 40);
  return facts;
}

PenEvent AnyPenEvent(int device, double t_s) {
  PenEvent event = Pen(static_cast<PenEvent::Kind>(Int(0, 5)), t_s, Position(), device);
  event.tool = static_cast<PenTool>(Int(0, 5));
  if (Coin()) event.pressure = Number(0, 1);
  if (Coin()) event.distance = Number(0, 1);
  if (Coin()) event.tilt_deg = Vec2(Number(-90, 90), Number(-90, 90));
  if (event.kind == PenEvent::Kind::kButton) {
    event.button = static_cast<uint32_t>(Int(0x14b, 0x14c));
    event.pressed = Coin();
  }
  return event;
}

KeyEvent AnyKeyEvent(int device, double t_s) {
  KeyEvent event{device, t_s, static_cast<uint32_t>(Int(1, 0x2ff)), Coin()};
  static constexpr std::array<const char*, 6> kTexts{"", "a", "\"", "\\ ", "é漢😀", "\x1b\t"};
  event.text = kTexts[static_cast<size_t>(Int(0, kTexts.size() - 1))];
  event.repeat = Coin();
  return event;
}

InputEvent AnyEvent(int devices, double t_s) {
  const int device = Int(0, devices - 1);
  switch (Int(0, 6)) {
    case 0:
      return TouchEvent{static_cast<TouchEvent::Kind>(Int(0, 3)), device, Int(0, 9), t_s,
                        Position()};
    case 1:
      return AnyKeyEvent(device, t_s);
    case 2:
      return ScrollEvent{device, t_s, Position(), {Number(-3, 3), Number(-3, 3)}};
    default:
      return AnyPenEvent(device, t_s);
  }
}

std::string AnyCommand() {
  std::string text = *rc::gen::container<std::string>(rc::gen::inRange<char>(' ', '~'));
  return text.find_first_not_of(' ') == std::string::npos ? text + "pick 1" : text;
}

}  // namespace

DeviceEvent PenAdded(int device, double t_s) {
  DeviceFacts facts;
  facts.name = "Test Pen";
  facts.vendor = 0x56a;
  facts.product = 0x4200;
  facts.size_mm = Vec2(596, 335);
  facts.has_pen = facts.has_pressure = true;
  return {DeviceEvent::Kind::kAdded, t_s, device, facts};
}

PenEvent Pen(PenEvent::Kind kind, double t_s, Vec2 position_mm, int device) {
  PenEvent event;
  event.kind = kind;
  event.device = device;
  event.t_s = t_s;
  event.position_mm = position_mm;
  return event;
}

std::vector<InputEvent> StrokeEvents(std::string_view points_mm, double start_s) {
  using Kind = PenEvent::Kind;
  const Stroke stroke = StrokeFrom(points_mm);
  std::vector<InputEvent> events{Pen(Kind::kProximityIn, start_s, stroke.front().position)};
  for (const StrokeSample& sample : stroke) {
    const Kind kind = events.size() == 1 ? Kind::kDown : Kind::kMotion;
    events.emplace_back(Pen(kind, start_s + sample.t_s, sample.position));
    std::get<PenEvent>(events.back()).pressure = 0.5;
  }
  const double end_s = start_s + stroke.back().t_s;
  events.emplace_back(Pen(Kind::kUp, end_s + 0.01, stroke.back().position));
  events.emplace_back(Pen(Kind::kProximityOut, end_s + 0.02, stroke.back().position));
  return events;
}

rc::Gen<Drawing> ArbitraryDrawing() {
  return rc::gen::exec([] {
    Drawing drawing;
    DrawingRules rules;
    const int devices = Int(1, 3);
    double t_s = 0;
    for (int i = 0; i < devices; ++i) {
      drawing.events.emplace_back(DeviceEvent{DeviceEvent::Kind::kAdded, t_s, i, AnyFacts()});
    }
    for (const InputEvent& event : drawing.events) (void)rules.Take(event);
    const int count = Int(0, 40);
    for (int i = 0; i < count; ++i) {
      t_s += Int(0, 20000) * 1e-6;
      drawing.events.push_back(AnyEvent(devices, t_s));
      if (!rules.Take(drawing.events.back())) drawing.events.pop_back();
      if (Int(0, 5) == 0) drawing.commands.push_back({rules.strokes(), AnyCommand()});
    }
    return drawing;
  });
}

}  // namespace parti::tests
