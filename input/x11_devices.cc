#include "input/x11_devices.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>
#include <string_view>

namespace parti::input {
namespace {

struct FreeX {
  void operator()(void* data) const { XFree(data); }
};

/// What a property of a device holds, or nothing of that format: 8, 32.
std::vector<uint32_t> PropertyOf(Display* display, int device, const char* name, int format) {
  const Atom property = XInternAtom(display, name, True);
  if (property == None) return {};
  Atom type = None;
  int found = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  if (XIGetProperty(display, device, property, 0, 64, False, AnyPropertyType, &type, &found, &count,
                    &left, &data) != Success) {
    return {};
  }
  const std::unique_ptr<unsigned char, FreeX> owned(data);
  if (found != format || !data) return {};
  std::vector<uint32_t> values;
  for (unsigned long i = 0; i < count; ++i) {
    values.push_back(format == 8 ? data[i] : reinterpret_cast<const uint32_t*>(data)[i]);
  }
  return values;
}

std::string NameOf(Display* display, Atom atom) {
  if (atom == None) return "";
  const std::unique_ptr<char, FreeX> name(XGetAtomName(display, atom));
  return name ? name.get() : "";
}

std::string WacomType(Display* display, int device) {
  const auto atoms = PropertyOf(display, device, "Wacom Tool Type", 32);
  return atoms.empty() ? "" : NameOf(display, atoms.front());
}

/// Whether the wacom driver tells a pen's buttons with its tip ("TPCButton"): it says the opposite.
bool ButtonsWithTip(Display* display, int device) {
  const auto hover = PropertyOf(display, device, "Wacom Hover Click", 8);
  return !hover.empty() && hover.front() == 0;
}

std::optional<X11Role> RoleOf(const std::string& label) {
  if (label == "Abs Pressure") return X11Role::kPressure;
  if (label == "Abs Distance") return X11Role::kDistance;
  if (label == "Abs Tilt X") return X11Role::kTiltX;
  if (label == "Abs Tilt Y") return X11Role::kTiltY;
  return std::nullopt;
}

bool Holds(std::string_view text, std::string_view word) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// "... Pad" of xf86-input-libinput, "xwayland-tablet-pad:19"; but no touch pad.
bool IsPad(std::string_view name) {
  return (Holds(name, " pad") || Holds(name, "-pad")) && !Holds(name, "touch");
}

/// A mouse on a tablet, which gets a valuator of pressure from drivers that describe all tools of a
/// tablet alike: "xwayland-tablet cursor:18", "... Mouse (0x805)" of xf86-input-libinput.
bool IsPuck(std::string_view name) {
  return Holds(name, "tablet cursor") || Holds(name, " mouse (0") || Holds(name, " lens (0");
}

bool HasRole(const X11Device& device, X11Role role) {
  return std::any_of(device.axes.begin(), device.axes.end(),
                     [&](const X11Axis& axis) { return axis.role == role; });
}

void AddAxis(Display* display, const XIValuatorClassInfo& info, X11Device* device) {
  const auto role = RoleOf(NameOf(display, info.label));
  if (!role || !(info.max > info.min)) return;
  device->axes.push_back({info.number, *role, info.min, info.max, 1, info.value});
}

void AddScroll(const XIScrollClassInfo& info, X11Device* device) {
  const bool upright = info.scroll_type == XIScrollTypeVertical;
  if (info.increment == 0) return;
  device->axes.push_back({info.number, upright ? X11Role::kScrollY : X11Role::kScrollX, 0, 0,
                          info.increment, std::nullopt});
}

/// The server describes a scrolling valuator twice: how it scrolls and where it stands.
void SetScrollValues(const XIDeviceInfo& info, X11Device* device) {
  for (int i = 0; i < info.num_classes; ++i) {
    if (info.classes[i]->type != XIValuatorClass) continue;
    const auto* valuator = reinterpret_cast<const XIValuatorClassInfo*>(info.classes[i]);
    for (X11Axis& axis : device->axes) {
      if (axis.number == valuator->number) axis.value = valuator->value;
    }
  }
}

void ReadClasses(Display* display, const XIDeviceInfo& info, X11Device* device) {
  for (int i = 0; i < info.num_classes; ++i) {
    const XIAnyClassInfo* any = info.classes[i];
    if (any->type == XIValuatorClass) {
      AddAxis(display, *reinterpret_cast<const XIValuatorClassInfo*>(any), device);
    } else if (any->type == XIScrollClass) {
      AddScroll(*reinterpret_cast<const XIScrollClassInfo*>(any), device);
    } else if (any->type == XITouchClass) {
      const auto* touch = reinterpret_cast<const XITouchClassInfo*>(any);
      device->facts.has_touch |= touch->mode == XIDirectTouch;
    }
  }
  SetScrollValues(info, device);
}

bool SetPointerFacts(Display* display, double px_per_mm, X11Device* device) {
  DeviceFacts& facts = device->facts;
  facts.view_px_per_mm = px_per_mm;
  facts.has_pressure = HasRole(*device, X11Role::kPressure);
  facts.has_distance = HasRole(*device, X11Role::kDistance);
  facts.has_tilt = HasRole(*device, X11Role::kTiltX) && HasRole(*device, X11Role::kTiltY);
  if (facts.has_touch) return true;
  const auto tool = X11ToolOf(facts.name, WacomType(display, device->id), facts.has_pressure);
  if (!tool) return false;
  device->tool = *tool;
  facts.has_pointer = *tool == PenTool::kMouse;
  facts.has_pen = !facts.has_pointer;
  facts.has_eraser = *tool == PenTool::kEraser;
  device->buttons_with_tip = *tool == PenTool::kPen && ButtonsWithTip(display, device->id);
  return true;
}

std::optional<X11Device> Describe(Display* display, const XIDeviceInfo& info, double px_per_mm) {
  const bool pointer = info.use == XISlavePointer, keys = info.use == XISlaveKeyboard;
  if (!info.enabled || (!pointer && !keys)) return std::nullopt;
  X11Device device;
  device.id = info.deviceid;
  device.facts.name = info.name;
  const auto product = PropertyOf(display, info.deviceid, "Device Product ID", 32);
  if (product.size() == 2) {
    device.facts.vendor = product[0];
    device.facts.product = product[1];
  }
  if (keys) {
    device.facts.has_keys = !IsButtonOnly(device.facts.name);
    return device;
  }
  ReadClasses(display, info, &device);
  if (!SetPointerFacts(display, px_per_mm, &device)) return std::nullopt;
  return device;
}

}  // namespace

std::optional<PenTool> X11ToolOf(const std::string& name, const std::string& wacom_type,
                                 bool has_pressure) {
  if (wacom_type == "STYLUS") return PenTool::kPen;
  if (wacom_type == "ERASER") return PenTool::kEraser;
  if (wacom_type == "PAD" || (wacom_type.empty() && IsPad(name))) return std::nullopt;
  if (wacom_type == "CURSOR" || wacom_type == "TOUCH") return PenTool::kMouse;
  if (Holds(name, "eraser")) return PenTool::kEraser;
  if (IsPuck(name)) return PenTool::kMouse;
  if (has_pressure) return PenTool::kPen;
  return PenTool::kMouse;
}

bool IsButtonOnly(const std::string& name) {
  static constexpr std::array<std::string_view, 10> kButtons = {
      "XTEST",      "button",           "Video Bus",      "hotkeys",    "WMI",
      "Lid Switch", "Consumer Control", "System Control", "HID events", "gpio-keys"};
  return std::any_of(kButtons.begin(), kButtons.end(),
                     [&](std::string_view word) { return Holds(name, word); });
}

std::vector<X11Device> ReadX11Devices(_XDisplay* display, double px_per_mm,
                                      std::optional<int> only) {
  int count = 0;
  XIDeviceInfo* infos = XIQueryDevice(display, only.value_or(XIAllDevices), &count);
  std::vector<X11Device> devices;
  for (int i = 0; infos && i < count; ++i) {
    if (auto device = Describe(display, infos[i], px_per_mm)) {
      devices.push_back(std::move(*device));
    }
  }
  if (infos) XIFreeDeviceInfo(infos);
  return devices;
}

}  // namespace parti::input
