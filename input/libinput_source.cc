#include "input/libinput_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <libinput.h>
#include <libudev.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <utility>

#include "base/check.h"
#include "input/libinput_values.h"
#include "input/unsmoothed.h"

namespace parti::input {
namespace {

/// Nodes that could not be opened, and why; filled by libinput's call back.
struct Denials {
  std::vector<std::pair<std::string, int>> nodes;

  void Add(const char* node, int reason) {
    const auto same = [&](const auto& denial) { return denial.first == node; };
    if (std::none_of(nodes.begin(), nodes.end(), same)) nodes.emplace_back(node, reason);
  }
};

int OpenNode(const char* node, int flags, void* denials) {
  int fd = ::open(node, flags | O_CLOEXEC);
  if (fd < 0 && errno == EACCES) {  // reading is enough: no lamp of a pen needs setting
    fd = ::open(node, (flags & ~O_ACCMODE) | O_RDONLY | O_CLOEXEC);
  }
  if (fd >= 0) return fd;
  const int reason = errno;
  static_cast<Denials*>(denials)->Add(node, reason);
  return -reason;
}

void CloseNode(int fd, void*) { ::close(fd); }

constexpr libinput_interface kInterface{OpenNode, CloseNode};

/// What goes wrong is told through Results; libinput's notes on the devices would only be noise.
void DropMessage(libinput*, libinput_log_priority, const char*, va_list) {}

struct UnrefContext {
  void operator()(libinput* context) const { libinput_unref(context); }
};
struct UnrefUdev {
  void operator()(udev* library) const { udev_unref(library); }
};
struct DestroyEvent {
  void operator()(libinput_event* event) const { libinput_event_destroy(event); }
};

double Now() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  const auto microseconds = static_cast<int64_t>(now.tv_sec) * 1'000'000 + now.tv_nsec / 1000;
  return static_cast<double>(microseconds) / 1e6;
}

/// A device's number goes with libinput's device as its user data; 0 there means none.
void SetNumber(libinput_device* device, size_t number) {
  libinput_device_set_user_data(device, reinterpret_cast<void*>(number + 1));
}
std::optional<int> NumberOf(libinput_device* device) {
  const auto data = reinterpret_cast<size_t>(libinput_device_get_user_data(device));
  if (data == 0) return std::nullopt;
  return static_cast<int>(data) - 1;
}

}  // namespace

struct LibinputSource::State {
  struct Device {
    DeviceFacts facts;
    std::string node;
    bool present = true;
    std::vector<Vec2> fingers_mm;  // by finger: the last position, for ups, which have none
  };

  Denials denials;
  std::unique_ptr<udev, UnrefUdev> udev_library;
  std::unique_ptr<libinput, UnrefContext> context;
  std::vector<Device> devices;
  double last_t_s = 0;

  void Take(libinput_event* event, std::vector<InputEvent>* out);
  void Add(libinput_device* device, std::vector<InputEvent>* out);
  void Remove(libinput_device* device, std::vector<InputEvent>* out);
  void CompletePosition(TouchEvent* touch);
  double NeverBefore(double t_s) { return last_t_s = std::max(last_t_s, t_s); }
};

void LibinputSource::State::Add(libinput_device* device, std::vector<InputEvent>* out) {
  if (!IsPenOrTouch(device)) {
    libinput_device_config_send_events_set_mode(device, LIBINPUT_CONFIG_SEND_EVENTS_DISABLED);
    return;
  }
  const int number = static_cast<int>(devices.size());
  SetNumber(device, devices.size());
  devices.push_back({FactsOf(device),
                     fmt::format("/dev/input/{}", libinput_device_get_sysname(device)),
                     true,
                     {}});
  out->emplace_back(
      DeviceEvent{DeviceEvent::Kind::kAdded, NeverBefore(Now()), number, devices.back().facts});
}

void LibinputSource::State::Remove(libinput_device* device, std::vector<InputEvent>* out) {
  const auto number = NumberOf(device);
  if (!number) return;
  Device& gone = devices[static_cast<size_t>(*number)];
  gone.present = false;
  out->emplace_back(
      DeviceEvent{DeviceEvent::Kind::kRemoved, NeverBefore(Now()), *number, gone.facts});
}

void LibinputSource::State::CompletePosition(TouchEvent* touch) {
  auto& fingers = devices[static_cast<size_t>(touch->device)].fingers_mm;
  const auto finger = static_cast<size_t>(touch->finger);
  if (fingers.size() <= finger) fingers.resize(finger + 1, Vec2(0, 0));
  const bool placed =
      touch->kind == TouchEvent::Kind::kDown || touch->kind == TouchEvent::Kind::kMotion;
  if (placed) {
    fingers[finger] = touch->position_mm;
  } else {
    touch->position_mm = fingers[finger];
  }
}

void LibinputSource::State::Take(libinput_event* event, std::vector<InputEvent>* out) {
  libinput_device* device = libinput_event_get_device(event);
  const libinput_event_type type = libinput_event_get_type(event);
  if (type == LIBINPUT_EVENT_DEVICE_ADDED) return Add(device, out);
  if (type == LIBINPUT_EVENT_DEVICE_REMOVED) return Remove(device, out);
  const auto number = NumberOf(device);
  if (!number) return;
  if (auto pen = PenEventOf(event, *number)) {
    pen->t_s = NeverBefore(pen->t_s);
    out->emplace_back(*pen);
  } else if (auto touch = TouchEventOf(event, *number)) {
    touch->t_s = NeverBefore(touch->t_s);
    CompletePosition(&*touch);
    out->emplace_back(*touch);
  }
}

Result<LibinputSource> LibinputSource::OpenSeat(const std::string& seat) {
  const auto unsmoothed = Unsmoothed::Make();
  if (!unsmoothed) return Fail(unsmoothed);
  auto state = std::make_unique<State>();
  state->udev_library.reset(udev_new());
  if (state->udev_library) {
    state->context.reset(
        libinput_udev_create_context(&kInterface, &state->denials, state->udev_library.get()));
  }
  if (!state->context) return Fail(ErrorCode::kDevice, "libinput can't be started");
  libinput_log_set_handler(state->context.get(), DropMessage);
  if (libinput_udev_assign_seat(state->context.get(), seat.c_str()) != 0) {
    return Fail(ErrorCode::kDevice, fmt::format("libinput can't watch seat {}", seat),
                "name a device node instead, as `--device /dev/input/event5`");
  }
  return LibinputSource(std::move(state));
}

Result<LibinputSource> LibinputSource::OpenDevices(const std::vector<std::string>& nodes) {
  const auto unsmoothed = Unsmoothed::Make();
  if (!unsmoothed) return Fail(unsmoothed);
  auto state = std::make_unique<State>();
  state->context.reset(libinput_path_create_context(&kInterface, &state->denials));
  if (!state->context) return Fail(ErrorCode::kDevice, "libinput can't be started");
  libinput_log_set_handler(state->context.get(), DropMessage);
  for (const std::string& node : nodes) {
    if (::access(node.c_str(), F_OK) != 0) return tl::unexpected(CannotOpen(node, errno));
    libinput_device* device = libinput_path_add_device(state->context.get(), node.c_str());
    if (!state->denials.nodes.empty()) {
      return tl::unexpected(CannotOpen(node, state->denials.nodes.front().second));
    }
    if (!device || !IsPenOrTouch(device)) {
      return Fail(ErrorCode::kDevice,
                  fmt::format("{} is not a pen tablet or touch screen that libinput takes", node),
                  "`parti devices` lists those that are there");
    }
  }
  return LibinputSource(std::move(state));
}

LibinputSource::LibinputSource(std::unique_ptr<State> state) : state_(std::move(state)) {}
LibinputSource::LibinputSource(LibinputSource&&) noexcept = default;
LibinputSource& LibinputSource::operator=(LibinputSource&&) noexcept = default;
LibinputSource::~LibinputSource() = default;

int LibinputSource::fd() const { return libinput_get_fd(state_->context.get()); }

Result<std::vector<InputEvent>> LibinputSource::Dispatch() {
  const int failed = libinput_dispatch(state_->context.get());
  if (failed != 0) {
    return Fail(ErrorCode::kDevice, fmt::format("libinput failed: {}", std::strerror(-failed)));
  }
  std::vector<InputEvent> events;
  while (libinput_event* event = libinput_get_event(state_->context.get())) {
    const std::unique_ptr<libinput_event, DestroyEvent> owned(event);
    state_->Take(event, &events);
  }
  return events;
}

bool LibinputSource::Wait(double timeout_s) const {
  // Opening a device queues its arrival without making the descriptor readable.
  if (libinput_next_event_type(state_->context.get()) != LIBINPUT_EVENT_NONE) return true;
  pollfd waiting{fd(), POLLIN, 0};
  return ::poll(&waiting, 1, static_cast<int>(std::ceil(timeout_s * 1000))) > 0;
}

const std::string& LibinputSource::node(int device) const {
  const auto number = static_cast<size_t>(device);
  CHECK(device >= 0 && number < state_->devices.size(), "a device number that was given out");
  return state_->devices[number].node;
}

int LibinputSource::present() const {
  return static_cast<int>(std::count_if(state_->devices.begin(), state_->devices.end(),
                                        [](const auto& device) { return device.present; }));
}

Error LibinputSource::WhyNothing() const {
  for (const auto& [node, reason] : state_->denials.nodes) {
    if (reason == EACCES || reason == EPERM) return CannotOpen(node, reason);
  }
  return {ErrorCode::kDevice, "no pen tablet and no touch screen is there",
          "plug one in; `sudo libinput list-devices` shows what the system sees", std::nullopt};
}

Error CannotOpen(const std::string& node, int reason) {
  Error error{ErrorCode::kDevice,
              fmt::format("can't open {}: {}", node, std::strerror(reason)),
              {},
              std::nullopt};
  if (reason == EACCES || reason == EPERM) {
    error.hint =
        "you may not read input devices: `sudo usermod -aG input $USER`, then log out and in again";
  } else if (reason == ENOENT || reason == ENODEV || reason == ENXIO) {
    error.hint = "`parti devices` lists those that are there";
  }
  return error;
}

}  // namespace parti::input
