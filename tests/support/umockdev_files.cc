#include "tests/support/umockdev_files.h"

#include <fmt/format.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>

#include "base/math.h"

namespace parti::tests {
namespace {

using Bytes = std::vector<uint8_t>;

constexpr int kIdentityLength = 255;  // libevdev's buffer for names
constexpr int kFirstMinor = 64;       // of event0
constexpr int kKeyBytes = 96;         // KEY_CNT / 8

/// Lengths of libevdev's buffers for the codes of each type of event.
struct CodeBuffer {
  int type;
  size_t bytes;
};
constexpr CodeBuffer kCodeBuffers[] = {{EV_KEY, kKeyBytes}, {EV_REL, 8}, {EV_ABS, 8},
                                       {EV_MSC, 8},         {EV_SW, 8},  {EV_LED, 8},
                                       {EV_SND, 8},         {EV_REP, 8}, {EV_FF, 16}};

Bytes Padded(Bytes bytes, size_t size) {
  bytes.resize(size);
  return bytes;
}

Bytes CodesOf(const EvdevRecording& recording, int type, size_t size) {
  const auto found = recording.codes.find(type);
  return Padded(found == recording.codes.end() ? Bytes() : found->second, size);
}

Bytes TypesOf(const EvdevRecording& recording) {
  Bytes types(8);
  for (const auto& [type, codes] : recording.codes) {
    const bool any = std::any_of(codes.begin(), codes.end(), [](uint8_t b) { return b != 0; });
    if (type == EV_SYN || any) {
      auto& byte = types[static_cast<size_t>(type / 8)];
      byte = static_cast<uint8_t>(byte | 1u << (type % 8));
    }
  }
  return types;
}

std::string Hex(const Bytes& bytes) {
  std::string text;
  for (const uint8_t byte : bytes) text += fmt::format("{:02X}", byte);
  return text;
}

/// As sysfs writes masks: words of 64 bits, the highest first, no leading zero words.
std::string Mask(const Bytes& bytes) {
  std::string text;
  for (size_t word = (bytes.size() + 7) / 8; word-- > 0;) {
    uint64_t bits = 0;
    for (size_t i = 8; i-- > 0;) {
      bits = bits << 8 | (word * 8 + i < bytes.size() ? bytes[word * 8 + i] : 0);
    }
    if (bits == 0 && text.empty() && word > 0) continue;
    text += fmt::format("{}{:x}", text.empty() ? "" : " ", bits);
  }
  return text;
}

/// The bytes of integers as they lie in the memory of the kernel's structures.
template <typename Integer>
Bytes Raw(std::initializer_list<Integer> values) {
  Bytes bytes(values.size() * sizeof(Integer));
  std::memcpy(bytes.data(), values.begin(), bytes.size());
  return bytes;
}

std::string Answer(const std::string& request, size_t result, const Bytes& bytes) {
  return fmt::format("{} {} {}\n", request, result, Hex(bytes));
}

std::string TextAnswer(const std::string& request, std::string text) {
  text += '\0';
  return Answer(request, text.size(), Padded(Bytes(text.begin(), text.end()), kIdentityLength));
}

Vec2 SizeMm(const EvdevRecording& recording) {
  const auto size = [&](int code) {
    const auto axis = recording.axes.find(code);
    if (axis == recording.axes.end() || axis->second.resolution == 0) return 0;
    return (axis->second.maximum - axis->second.minimum) / axis->second.resolution;
  };
  return {size(ABS_X), size(ABS_Y)};
}

std::string PropertyLines(const MockPlace& place, const char* mark = "E: ") {
  std::string lines;
  for (const std::string& property : place.properties) lines += mark + property + "\n";
  return lines;
}

}  // namespace

std::string SysfsPath(const MockPlace& place) {
  return fmt::format("/devices/pci0000:00/0000:00:14.0/usb1/1-1/1-1:1.0/input/input{}",
                     place.number);
}

std::string SysfsNodePath(const MockPlace& place) {
  return fmt::format("{}/event{}", SysfsPath(place), place.number);
}

std::string UmockdevDevice(const EvdevRecording& recording, const MockPlace& place) {
  const Vec2 size_mm = SizeMm(recording);
  const std::string device_properties = Mask(Padded(recording.properties, 8));
  const std::string abs = Mask(CodesOf(recording, EV_ABS, 8));
  const std::string key = Mask(CodesOf(recording, EV_KEY, kKeyBytes));
  const std::string ev = Mask(TypesOf(recording));
  const int n = place.number, minor = kFirstMinor + n;
  std::string text = fmt::format(
      "P: {}\nN: input/event{}\nE: DEVNAME=/dev/input/event{}\nE: MAJOR=13\nE: MINOR={}\n"
      "E: SUBSYSTEM=input\nE: ID_BUS=usb\nE: ID_INPUT=1\nE: ID_SEAT=seat0\n"
      "E: ID_INPUT_WIDTH_MM={}\nE: ID_INPUT_HEIGHT_MM={}\nE: ID_VENDOR_ID={:04x}\n"
      "E: ID_MODEL_ID={:04x}\nE: LIBINPUT_DEVICE_GROUP=3/{:x}/{:x}:usb-mock-{}\n{}"
      "A: dev=13:{}\nL: device=../../input{}\n\n",
      SysfsNodePath(place), n, n, minor, size_mm.x, size_mm.y, recording.vendor, recording.product,
      recording.vendor, recording.product, n, PropertyLines(place), minor, n);
  text += fmt::format(
      "P: {}\nE: SUBSYSTEM=input\nE: ID_INPUT=1\n{}E: NAME=\"{}\"\n"
      "E: PHYS=\"usb-mock/{}\"\nE: PRODUCT={:x}/{:x}/{:x}/{:x}\nE: PROP={}\nE: EV={}\nE: KEY={}\n"
      "E: ABS={}\n",
      SysfsPath(place), PropertyLines(place), recording.name, n, recording.bus, recording.vendor,
      recording.product, recording.version, device_properties, ev, key, abs);
  text += fmt::format(
      "A: name={}\nA: phys=usb-mock/{}\nA: uniq=\nA: properties={}\nA: id/bustype={:04x}\n"
      "A: id/vendor={:04x}\nA: id/product={:04x}\nA: id/version={:04x}\nA: capabilities/ev={}\n"
      "A: capabilities/key={}\nA: capabilities/abs={}\n\n",
      recording.name, n, device_properties, recording.bus, recording.vendor, recording.product,
      recording.version, ev, key, abs);
  return text;
}

std::string UmockdevIoctls(const EvdevRecording& recording, const MockPlace& place) {
  std::string text = fmt::format("@DEV /dev/input/event{}\n", place.number);
  text += Answer("EVIOCGBIT(0)", 8, TypesOf(recording));
  text += TextAnswer("EVIOCGNAME(0)", recording.name);
  text += TextAnswer("EVIOCGPHYS(0)", fmt::format("usb-mock/{}", place.number));
  text += TextAnswer("EVIOCGUNIQ(0)", "");
  text += Answer(
      "EVIOCGID", 0,
      Raw<uint16_t>({recording.bus, recording.vendor, recording.product, recording.version}));
  text += Answer("EVIOCGVERSION", 0, Raw<uint32_t>({0x10001}));
  text += Answer("EVIOCGPROP(0)", 8, Padded(recording.properties, 8));
  for (const CodeBuffer& buffer : kCodeBuffers) {
    text += Answer(fmt::format("EVIOCGBIT({})", buffer.type), buffer.bytes,
                   CodesOf(recording, buffer.type, buffer.bytes));
  }
  text += Answer("EVIOCGKEY(0)", kKeyBytes, Bytes(kKeyBytes));  // nothing is pressed at the start
  text += Answer("EVIOCGLED(0)", 8, Bytes(8));
  text += Answer("EVIOCGSW(0)", 8, Bytes(8));
  for (const auto& [code, axis] : recording.axes) {
    text += Answer(
        code == 0 ? "EVIOCGABS" : fmt::format("EVIOCGABS({})", code), 0,
        Raw<int32_t>({0, axis.minimum, axis.maximum, axis.fuzz, axis.flat, axis.resolution}));
  }
  return text;
}

std::string UdevDataName(const MockPlace& place) {
  return fmt::format("c13:{}", kFirstMinor + place.number);
}

std::string UdevData(const MockPlace& place) {
  return "I:1234567\nE:ID_INPUT=1\n" + PropertyLines(place, "E:") + "G:seat\nQ:seat\nV:1\n";
}

}  // namespace parti::tests
