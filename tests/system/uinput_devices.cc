// Tablets and touch screens that are not there, for a whole kernel: makes them with uinput from
// descriptions, and plays drawings on them in time. It takes lines from a FIFO that it makes:
//   plug FILE           a device as FILE describes it (tests/system/devices)
//   unplug              all devices go
//   play FILE SPEED     the drawing's pen on the plugged pen tablet, its fingers on the touch
//   screen
// and answers each on standard output: "plugged FILE NODE", "unplugged", "played FILE" or "error:
// …".
#include <fcntl.h>
#include <fmt/format.h>
#include <libevdev/libevdev-uinput.h>
#include <libevdev/libevdev.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <thread>

#include "base/text_file.h"
#include "tests/support/evdev_from_drawing.h"
#include "tests/support/evdev_from_touches.h"

namespace parti::tests {
namespace {

struct FreeUinput {
  void operator()(libevdev_uinput* device) const { libevdev_uinput_destroy(device); }
};
struct FreeEvdev {
  void operator()(libevdev* device) const { libevdev_free(device); }
};

/// A device that the kernel now has; gone with the value.
struct Plugged {
  EvdevRecording description;
  std::unique_ptr<libevdev_uinput, FreeUinput> uinput;

  bool is_touch_screen() const { return description.axes.contains(ABS_MT_SLOT); }
};

struct Step {
  int64_t t_us = 0;
  const libevdev_uinput* device = nullptr;
  EvdevEvent event;
};

void EnableCodes(const EvdevRecording& description, libevdev* device) {
  for (const auto& [type, bytes] : description.codes) {
    for (size_t bit = 0; bit < bytes.size() * 8; ++bit) {
      const auto code = static_cast<unsigned>(bit);
      const bool has = (bytes[bit / 8] >> (bit % 8) & 1) != 0;
      if (!has || type == EV_ABS) continue;
      libevdev_enable_event_code(device, static_cast<unsigned>(type), code, nullptr);
    }
  }
  for (const auto& [code, axis] : description.axes) {
    const input_absinfo info{.value = 0,
                             .minimum = axis.minimum,
                             .maximum = axis.maximum,
                             .fuzz = axis.fuzz,
                             .flat = axis.flat,
                             .resolution = axis.resolution};
    libevdev_enable_event_code(device, EV_ABS, static_cast<unsigned>(code), &info);
  }
}

Result<Plugged> Plug(const std::string& path) {
  const auto text = ReadFile(path);
  if (!text) return Fail(text);
  auto description = ReadEvemuDevice(*text, path);
  if (!description) return Fail(description);
  const std::unique_ptr<libevdev, FreeEvdev> device(libevdev_new());
  libevdev_set_name(device.get(), description->name.c_str());
  libevdev_set_id_bustype(device.get(), description->bus);
  libevdev_set_id_vendor(device.get(), description->vendor);
  libevdev_set_id_product(device.get(), description->product);
  libevdev_set_id_version(device.get(), description->version);
  for (size_t bit = 0; bit < description->properties.size() * 8; ++bit) {
    if ((description->properties[bit / 8] >> (bit % 8) & 1) == 0) continue;
    libevdev_enable_property(device.get(), static_cast<unsigned>(bit));
  }
  EnableCodes(*description, device.get());
  libevdev_uinput* made = nullptr;
  const int status =
      libevdev_uinput_create_from_device(device.get(), LIBEVDEV_UINPUT_OPEN_MANAGED, &made);
  if (status != 0) {
    return Fail(ErrorCode::kDevice, fmt::format("no uinput device: {}", std::strerror(-status)));
  }
  return Plugged{std::move(*description), std::unique_ptr<libevdev_uinput, FreeUinput>(made)};
}

/// What one device has to send for the drawing; nothing where the drawing has nothing for it.
std::vector<Step> StepsFor(const Plugged& device, const input::Drawing& drawing) {
  const auto recording = device.is_touch_screen() ? EvdevFromTouches(drawing, device.description)
                                                  : EvdevFromDrawing(drawing, device.description);
  std::vector<Step> steps;
  if (!recording) return steps;
  for (const EvdevEvent& event : recording->events) {
    steps.push_back({event.t_us, device.uinput.get(), event});
  }
  return steps;
}

/// Sends each event at its time, the drawing's time running `speed` times as fast as the clock.
Result<void> Send(const std::vector<Step>& steps, double speed) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  for (const Step& step : steps) {
    const double due_us = static_cast<double>(step.t_us - steps.front().t_us) / speed;
    std::this_thread::sleep_until(start + std::chrono::microseconds(static_cast<int64_t>(due_us)));
    const int status = libevdev_uinput_write_event(step.device, step.event.type, step.event.code,
                                                   step.event.value);
    if (status != 0) {
      return Fail(ErrorCode::kDevice, fmt::format("uinput: {}", std::strerror(-status)));
    }
  }
  return {};
}

Result<void> Play(const std::vector<Plugged>& devices, const std::string& path, double speed) {
  const auto text = ReadFile(path);
  if (!text) return Fail(text);
  const auto reading = input::ReadDrawing(*text, path);
  if (reading.damage) return tl::unexpected(*reading.damage);
  std::vector<Step> steps;
  for (const Plugged& device : devices) {
    const auto more = StepsFor(device, reading.drawing);
    steps.insert(steps.end(), more.begin(), more.end());
  }
  if (steps.empty()) return Fail(ErrorCode::kNothingMade, path + ": no device for any of it");
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& a, const Step& b) { return a.t_us < b.t_us; });
  return Send(steps, speed);
}

/// One line's answer.
Result<std::string> Obey(const std::string& line, std::vector<Plugged>* devices) {
  std::istringstream words(line);
  std::string order, path;
  double speed = 1;
  words >> order >> path >> speed;
  if (order == "plug") {
    auto device = Plug(path);
    if (!device) return Fail(device);
    devices->push_back(std::move(*device));
    return fmt::format("plugged {} {}", path,
                       libevdev_uinput_get_devnode(devices->back().uinput.get()));
  }
  if (order == "unplug") {
    devices->clear();
    return "unplugged";
  }
  if (order == "play" && speed > 0) {
    const auto played = Play(*devices, path, speed);
    if (!played) return Fail(played);
    return "played " + path;
  }
  return Fail(ErrorCode::kBadText, "no such order: " + line);
}

int Main(const std::string& fifo) {
  if (::mkfifo(fifo.c_str(), 0600) != 0) {
    fmt::print("error: {}: {}\n", fifo, std::strerror(errno));
    return 1;
  }
  std::vector<Plugged> devices;
  std::fstream orders(fifo);  // also open for writing, so that it never ends
  for (std::string line; std::getline(orders, line);) {
    const auto answer = Obey(line, &devices);
    fmt::print("{}\n", answer ? *answer : "error: " + answer.error().message);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace
}  // namespace parti::tests

int main(int argc, char** argv) {
  if (argc == 2) return parti::tests::Main(argv[1]);
  fmt::print(stderr, "usage: parti_uinput_devices FIFO\n");
  return 2;
}
