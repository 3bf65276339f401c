#include "input/libinput_values.h"

#include <libudev.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>

#include "input/key_codes.h"

extern "C" {  // which the header leaves out
#include <libwacom/libwacom.h>
}

namespace parti::input {
namespace {

struct Unref {
  void operator()(udev_device* device) const { udev_device_unref(device); }
};

double Seconds(uint64_t microseconds) { return static_cast<double>(microseconds) / 1e6; }

/// Bit `code` of a sysfs capability mask: hexadecimal words of a long each, the highest first.
bool HasBit(std::string_view mask, unsigned code) {
  constexpr unsigned kWordBits = 8 * sizeof(long);  // NOLINT(google-runtime-int): the kernel's word
  for (unsigned word = code / kWordBits; word > 0; --word) {
    const size_t blank = mask.rfind(' ');
    if (blank == std::string_view::npos) return false;
    mask = mask.substr(0, blank);
  }
  const size_t blank = mask.rfind(' ');
  if (blank != std::string_view::npos) mask = mask.substr(blank + 1);
  return (std::strtoull(std::string(mask).c_str(), nullptr, 16) >> (code % kWordBits)) & 1u;
}

std::string SysfsMask(udev_device* node, const char* attribute) {
  udev_device* parent = node ? udev_device_get_parent(node) : nullptr;  // borrowed from the node
  const char* mask = parent ? udev_device_get_sysattr_value(parent, attribute) : nullptr;
  return mask ? mask : "";
}

std::optional<PenTool> ToolOf(libinput_tablet_tool* tool) {
  switch (libinput_tablet_tool_get_type(tool)) {
    case LIBINPUT_TABLET_TOOL_TYPE_PEN:
      return PenTool::kPen;
    case LIBINPUT_TABLET_TOOL_TYPE_ERASER:
      return PenTool::kEraser;
    case LIBINPUT_TABLET_TOOL_TYPE_BRUSH:
      return PenTool::kBrush;
    case LIBINPUT_TABLET_TOOL_TYPE_PENCIL:
      return PenTool::kPencil;
    case LIBINPUT_TABLET_TOOL_TYPE_AIRBRUSH:
      return PenTool::kAirbrush;
    case LIBINPUT_TABLET_TOOL_TYPE_MOUSE:
    case LIBINPUT_TABLET_TOOL_TYPE_LENS:
      return PenTool::kMouse;
    default:
      return std::nullopt;
  }
}

std::optional<PenEvent::Kind> KindOf(libinput_event* event, libinput_event_tablet_tool* pen) {
  switch (libinput_event_get_type(event)) {
    case LIBINPUT_EVENT_TABLET_TOOL_PROXIMITY:
      return libinput_event_tablet_tool_get_proximity_state(pen) ==
                     LIBINPUT_TABLET_TOOL_PROXIMITY_STATE_IN
                 ? PenEvent::Kind::kProximityIn
                 : PenEvent::Kind::kProximityOut;
    case LIBINPUT_EVENT_TABLET_TOOL_TIP:
      return libinput_event_tablet_tool_get_tip_state(pen) == LIBINPUT_TABLET_TOOL_TIP_DOWN
                 ? PenEvent::Kind::kDown
                 : PenEvent::Kind::kUp;
    case LIBINPUT_EVENT_TABLET_TOOL_AXIS:
      return PenEvent::Kind::kMotion;
    case LIBINPUT_EVENT_TABLET_TOOL_BUTTON:
      return PenEvent::Kind::kButton;
    default:
      return std::nullopt;
  }
}

bool IsPenEvent(libinput_event_type type) {
  return type >= LIBINPUT_EVENT_TABLET_TOOL_AXIS && type <= LIBINPUT_EVENT_TABLET_TOOL_BUTTON;
}

struct DestroyTablets {
  void operator()(WacomDeviceDatabase* tablets) const { libwacom_database_destroy(tablets); }
};
struct DestroyTablet {
  void operator()(WacomDevice* tablet) const { libwacom_destroy(tablet); }
};

/// Whether a tablet is a screen, if libwacom knows it. The kernel's own mark (INPUT_PROP_DIRECT) is
/// right for Wacom's, but set for some opaque tablets of other makes.
std::optional<bool> IsKnownDisplay(uint32_t vendor, uint32_t product) {
  const std::unique_ptr<WacomDeviceDatabase, DestroyTablets> tablets(libwacom_database_new());
  if (!tablets) return std::nullopt;
  const std::unique_ptr<WacomDevice, DestroyTablet> tablet(libwacom_new_from_usbid(
      tablets.get(), static_cast<int>(vendor), static_cast<int>(product), nullptr));
  if (!tablet) return std::nullopt;
  return libwacom_get_integration_flags(tablet.get()) != WACOM_DEVICE_INTEGRATED_NONE;
}

/// In the millimetres of a screen that does not say its size, libinput gives meaningless numbers.
Vec2 PositionOf(libinput_event_touch* touch, libinput_device* device) {
  Vec2 size_mm(0, 0);
  if (libinput_device_get_size(device, &size_mm.x, &size_mm.y) == 0) {
    return {libinput_event_touch_get_x(touch), libinput_event_touch_get_y(touch)};
  }
  return kUsualSize_mm * Vec2(libinput_event_touch_get_x_transformed(touch, 1),
                              libinput_event_touch_get_y_transformed(touch, 1));
}

}  // namespace

bool IsPenOrTouch(libinput_device* device) {
  return libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_TABLET_TOOL) != 0 ||
         libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_TOUCH) != 0;
}

bool IsMouseOrKeys(libinput_device* device) {
  return libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_POINTER) != 0 ||
         SendsKeys(device);
}

bool SendsKeys(libinput_device* device) {
  return libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_KEYBOARD) != 0;
}

bool IsSwitch(libinput_device* device) {
  return libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_SWITCH) != 0;
}

DeviceFacts FactsOf(libinput_device* device) {
  DeviceFacts facts;
  facts.name = libinput_device_get_name(device);
  facts.vendor = libinput_device_get_id_vendor(device);
  facts.product = libinput_device_get_id_product(device);
  Vec2 size_mm(0, 0);
  if (libinput_device_get_size(device, &size_mm.x, &size_mm.y) == 0) facts.size_mm = size_mm;
  facts.has_pen = libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_TABLET_TOOL) != 0;
  facts.has_touch = libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_TOUCH) != 0;
  facts.has_keys = IsKeyboard([&](uint32_t code) {
    return libinput_device_keyboard_has_key(device, code) == 1;  // -1: it sends no keys at all
  });
  facts.has_pointer = !facts.has_pen && !facts.has_touch &&
                      libinput_device_has_capability(device, LIBINPUT_DEVICE_CAP_POINTER) != 0;
  if (facts.has_pointer) facts.view_px_per_mm = PointerPosition::kViewPxPerMm;
  facts.has_display = facts.has_touch && !facts.has_pen;
  if (!facts.has_pen) return facts;
  const std::unique_ptr<udev_device, Unref> node(libinput_device_get_udev_device(device));
  const std::string axes = SysfsMask(node.get(), "capabilities/abs");
  facts.has_pressure = HasBit(axes, ABS_PRESSURE);
  facts.has_tilt = HasBit(axes, ABS_TILT_X) && HasBit(axes, ABS_TILT_Y);
  facts.has_distance = HasBit(axes, ABS_DISTANCE);
  const bool direct = HasBit(SysfsMask(node.get(), "properties"), INPUT_PROP_DIRECT);
  facts.has_display = IsKnownDisplay(facts.vendor, facts.product).value_or(direct);
  facts.has_eraser = HasBit(SysfsMask(node.get(), "capabilities/key"), BTN_TOOL_RUBBER);
  return facts;
}

std::optional<PenEvent> PenEventOf(libinput_event* event, int device) {
  if (!IsPenEvent(libinput_event_get_type(event))) return std::nullopt;
  libinput_event_tablet_tool* pen = libinput_event_get_tablet_tool_event(event);
  libinput_tablet_tool* tool = libinput_event_tablet_tool_get_tool(pen);
  const auto kind = KindOf(event, pen);
  const auto which = ToolOf(tool);
  if (!kind || !which) return std::nullopt;
  PenEvent value;
  value.kind = *kind;
  value.tool = *which;
  value.device = device;
  value.t_s = Seconds(libinput_event_tablet_tool_get_time_usec(pen));
  value.position_mm = {libinput_event_tablet_tool_get_x(pen),
                       libinput_event_tablet_tool_get_y(pen)};
  if (libinput_tablet_tool_has_pressure(tool) != 0) {
    value.pressure = std::clamp(libinput_event_tablet_tool_get_pressure(pen), 0.0, 1.0);
  }
  if (libinput_tablet_tool_has_distance(tool) != 0) {
    value.distance = std::clamp(libinput_event_tablet_tool_get_distance(pen), 0.0, 1.0);
  }
  if (libinput_tablet_tool_has_tilt(tool) != 0) {
    value.tilt_deg = {std::clamp(libinput_event_tablet_tool_get_tilt_x(pen), -90.0, 90.0),
                      std::clamp(libinput_event_tablet_tool_get_tilt_y(pen), -90.0, 90.0)};
  }
  if (value.kind == PenEvent::Kind::kButton) {
    value.button = libinput_event_tablet_tool_get_button(pen);
    value.pressed =
        libinput_event_tablet_tool_get_button_state(pen) == LIBINPUT_BUTTON_STATE_PRESSED;
  }
  return value;
}

std::optional<TouchEvent> TouchEventOf(libinput_event* event, int device) {
  TouchEvent value;
  switch (libinput_event_get_type(event)) {
    case LIBINPUT_EVENT_TOUCH_DOWN:
      value.kind = TouchEvent::Kind::kDown;
      break;
    case LIBINPUT_EVENT_TOUCH_MOTION:
      value.kind = TouchEvent::Kind::kMotion;
      break;
    case LIBINPUT_EVENT_TOUCH_UP:
      value.kind = TouchEvent::Kind::kUp;
      break;
    case LIBINPUT_EVENT_TOUCH_CANCEL:
      value.kind = TouchEvent::Kind::kCancel;
      break;
    default:
      return std::nullopt;
  }
  libinput_event_touch* touch = libinput_event_get_touch_event(event);
  value.device = device;
  value.finger = std::max(0, libinput_event_touch_get_slot(touch));  // -1 on single-touch screens
  value.t_s = Seconds(libinput_event_touch_get_time_usec(touch));
  if (value.kind == TouchEvent::Kind::kDown || value.kind == TouchEvent::Kind::kMotion) {
    value.position_mm = PositionOf(touch, libinput_event_get_device(event));
  }
  return value;
}

}  // namespace parti::input
