#include "tests/support/evdev_from_drawing.h"

#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

namespace parti::tests {
namespace {

constexpr int kUnitsPerMm = 200;
constexpr int kMaxPressure = 8191;
// libinput 1.22 takes the tip for down from 5 % of the range on and for up from 1 % downwards; it
// gives the latter as pressure 0, so that no stroke begins with less than 0.04.
constexpr int kDownPercent = 5;
constexpr int kZeroPercent = 1;
constexpr int kMaxDistance = 63;
constexpr int kTiltUnits = 100;        // per degree
constexpr int kTiltResolution = 5730;  // the same per radian
// What libinput 1.22 takes the ends of a tilt axis for that has no resolution.
constexpr double kWacomTilt_deg = 64;
// What Wacom's driver says of a common pen and its other end, where it has an axis for it, and
// whose pen it is.
constexpr int kPenId = 0x160802;
constexpr int kEraserId = 0x16080a;
constexpr int kPenSerial = 0x2a1b3c4d;
constexpr Vec2 kUsualSize_mm{344, 194};  // of a 16-inch display tablet

int ToolCode(PenTool tool) {
  switch (tool) {
    case PenTool::kPen:
      return BTN_TOOL_PEN;
    case PenTool::kEraser:
      return BTN_TOOL_RUBBER;
    case PenTool::kBrush:
      return BTN_TOOL_BRUSH;
    case PenTool::kPencil:
      return BTN_TOOL_PENCIL;
    case PenTool::kAirbrush:
      return BTN_TOOL_AIRBRUSH;
    case PenTool::kMouse:
      return BTN_TOOL_MOUSE;
  }
  return BTN_TOOL_PEN;
}

EvdevRecording Describe(const DeviceFacts& facts) {
  EvdevRecording tablet;
  tablet.name = facts.name.empty() ? "Drawn Pen" : facts.name;
  tablet.vendor = static_cast<uint16_t>(facts.vendor);
  tablet.product = static_cast<uint16_t>(facts.product);
  tablet.version = 0x110;
  tablet.properties = {1 << INPUT_PROP_DIRECT};
  tablet.codes[EV_SYN] = {};
  for (const int code : {BTN_TOOL_PEN, BTN_TOOL_RUBBER, BTN_TOOL_BRUSH, BTN_TOOL_PENCIL,
                         BTN_TOOL_AIRBRUSH, BTN_TOUCH, BTN_STYLUS, BTN_STYLUS2}) {
    tablet.SetCode(EV_KEY, code);
  }
  const Vec2 size_mm = facts.size_mm.value_or(kUsualSize_mm);
  const auto units = [](double mm) { return static_cast<int32_t>(std::lround(mm * kUnitsPerMm)); };
  tablet.axes[ABS_X] = {.maximum = units(size_mm.x), .resolution = kUnitsPerMm};
  tablet.axes[ABS_Y] = {.maximum = units(size_mm.y), .resolution = kUnitsPerMm};
  tablet.axes[ABS_PRESSURE] = {.maximum = kMaxPressure};
  if (facts.has_distance) tablet.axes[ABS_DISTANCE] = {.maximum = kMaxDistance};
  if (facts.has_tilt) {
    for (const int code : {ABS_TILT_X, ABS_TILT_Y}) {
      tablet.axes[code] = {
          .minimum = -90 * kTiltUnits, .maximum = 90 * kTiltUnits, .resolution = kTiltResolution};
    }
  }
  for (const auto& [code, axis] : tablet.axes) tablet.SetCode(EV_ABS, code);
  return tablet;
}

bool Has(const EvdevRecording& tablet, int type, int code) {
  const auto bits = tablet.codes.find(type);
  const auto byte = static_cast<size_t>(code / 8);
  return bits != tablet.codes.end() && byte < bits->second.size() &&
         (bits->second[byte] >> (code % 8) & 1) != 0;
}

/// In the axis's own units, from millimetres, from a part of its range, from degrees.
double FromMm(const EvdevAxis& axis, double mm) { return axis.minimum + mm * axis.resolution; }
double FromPart(const EvdevAxis& axis, double part) {
  return axis.minimum + part * (axis.maximum - axis.minimum);
}

double FromTilt(const EvdevAxis& axis, double tilt_deg) {
  if (axis.resolution == 0) return FromPart(axis, (tilt_deg / kWacomTilt_deg + 1) / 2);
  return tilt_deg * std::numbers::pi / 180 * axis.resolution;
}

/// Writes the events of one pen, keeping the kernel's state of every key and axis.
class Driver {
 public:
  explicit Driver(EvdevRecording* tablet) : tablet_(tablet) {}

  /// The pen comes and goes before its first report. Until libinput has seen a pen go it takes one
  /// that is silent for 50 ms for gone; real pens tremble, drawn ones may hold still.
  void Visit(PenEvent first) {
    constexpr double kBefore_s = 0.03, kLasts_s = 0.0002;
    first.kind = PenEvent::Kind::kProximityIn;
    first.t_s -= kBefore_s;
    Take(first);
    t_us_ += std::llround(kLasts_s * 1e6);
    Leave();
    tablet_->begins_with_visit = true;
  }

  void Take(const PenEvent& event) {
    t_us_ = std::llround(event.t_s * 1e6);
    if (event.kind == PenEvent::Kind::kProximityOut) return Leave();
    SetAxes(event);
    if (tool_ != event.tool) Enter(event.tool);
    if (event.kind == PenEvent::Kind::kDown) touching_ = true;
    if (event.kind == PenEvent::Kind::kUp) touching_ = false;
    if (event.kind == PenEvent::Kind::kButton) {
      Set(EV_KEY, static_cast<int>(event.button), event.pressed ? 1 : 0);
    }
    SetContact(event);
    Report();
  }

  void Leave() {
    if (!tool_) return;
    Set(EV_KEY, BTN_TOUCH, 0);
    SetAxis(ABS_PRESSURE, [](const EvdevAxis& axis) { return axis.minimum; });
    SetAxis(ABS_MISC, [](const EvdevAxis&) { return 0; });
    Set(EV_KEY, ToolCode(*tool_), 0);
    Report();
    tool_.reset();
    touching_ = false;
  }

 private:
  void Enter(PenTool tool) {
    Leave();
    tool_ = tool;
    const int id = tool == PenTool::kEraser ? kEraserId : kPenId;
    if (tablet_->axes.contains(ABS_MISC)) Set(EV_ABS, ABS_MISC, id);
    Set(EV_KEY, ToolCode(tool), 1);
  }

  void SetAxes(const PenEvent& event) {
    SetAxis(ABS_X, [&](const EvdevAxis& axis) { return FromMm(axis, event.position_mm.x); });
    SetAxis(ABS_Y, [&](const EvdevAxis& axis) { return FromMm(axis, event.position_mm.y); });
    if (!event.tilt_deg) return;
    SetAxis(ABS_TILT_X, [&](const EvdevAxis& axis) { return FromTilt(axis, event.tilt_deg->x); });
    SetAxis(ABS_TILT_Y, [&](const EvdevAxis& axis) { return FromTilt(axis, event.tilt_deg->y); });
  }

  void SetContact(const PenEvent& event) {
    Set(EV_KEY, BTN_TOUCH, touching_ ? 1 : 0);
    SetAxis(ABS_PRESSURE, [&](const EvdevAxis& axis) { return Pressure(axis, event); });
    if (!event.distance) return;
    SetAxis(ABS_DISTANCE,
            [&](const EvdevAxis& axis) { return FromPart(axis, touching_ ? 0 : *event.distance); });
  }

  double Pressure(const EvdevAxis& axis, const PenEvent& event) const {
    if (!touching_) return axis.minimum;
    const int steps = axis.maximum - axis.minimum;
    const int zero = steps * kZeroPercent / 100;
    const bool begins = event.kind == PenEvent::Kind::kDown;
    const int least = begins ? steps * kDownPercent / 100 + 1 : zero + 1;
    const double pressed = zero + event.pressure.value_or(0.5) * (steps - zero);
    return axis.minimum + std::max<double>(least, pressed);
  }

  /// `value` gives the axis's value in its own units; axes that the tablet has not are left out.
  template <typename Value>
  void SetAxis(int code, const Value& value) {
    const auto found = tablet_->axes.find(code);
    if (found == tablet_->axes.end()) return;
    const EvdevAxis& axis = found->second;
    const auto units = static_cast<int32_t>(std::lround(value(axis)));
    Set(EV_ABS, code,
        axis.minimum == axis.maximum ? units : std::clamp(units, axis.minimum, axis.maximum));
  }

  void Set(uint16_t type, int code, int32_t value) {
    if (std::exchange(state_[{type, code}], value) == value) return;
    tablet_->events.push_back({t_us_, type, static_cast<uint16_t>(code), value});
    changed_ = true;
  }

  void Report() {
    if (!std::exchange(changed_, false)) return;
    if (Has(*tablet_, EV_MSC, MSC_SERIAL)) {
      tablet_->events.push_back({t_us_, EV_MSC, MSC_SERIAL, kPenSerial});
    }
    tablet_->events.push_back({t_us_, EV_SYN, SYN_REPORT, 0});
  }

  EvdevRecording* tablet_;
  std::map<std::pair<int, int>, int32_t> state_;
  std::optional<PenTool> tool_;
  bool touching_ = false;
  bool changed_ = false;
  int64_t t_us_ = 0;
};

const PenEvent* FirstReport(const input::Drawing& drawing, int device) {
  for (const InputEvent& event : drawing.events) {
    const auto* report = std::get_if<PenEvent>(&event);
    if (report && report->device == device) return report;
  }
  return nullptr;
}

Result<DeviceEvent> FirstPen(const input::Drawing& drawing) {
  for (const InputEvent& event : drawing.events) {
    const auto* device = std::get_if<DeviceEvent>(&event);
    const bool added = device && device->kind == DeviceEvent::Kind::kAdded;
    if (added && device->facts.has_pen) return *device;
  }
  return Fail(ErrorCode::kNothingMade, "the drawing has no pen");
}

}  // namespace

Result<EvdevRecording> EvdevFromDrawing(const input::Drawing& drawing, EvdevRecording tablet) {
  const auto pen = FirstPen(drawing);
  if (!pen) return Fail(pen);
  Driver driver(&tablet);
  if (const auto* report = FirstReport(drawing, pen->device)) driver.Visit(*report);
  for (const InputEvent& event : drawing.events) {
    const auto* report = std::get_if<PenEvent>(&event);
    if (report && report->device == pen->device) driver.Take(*report);
  }
  driver.Leave();
  return tablet;
}

Result<EvdevRecording> EvdevFromDrawing(const input::Drawing& drawing) {
  const auto pen = FirstPen(drawing);
  if (!pen) return Fail(pen);
  return EvdevFromDrawing(drawing, Describe(pen->facts));
}

}  // namespace parti::tests
