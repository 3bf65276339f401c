#include "input/libinput_source.h"

#include <fmt/format.h>
#include <libinput.h>
#include <libudev.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/timerfd.h>
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
#include "input/libinput_devices.h"
#include "input/libinput_values.h"
#include "input/unsmoothed.h"

namespace parti::input {
namespace {

/// Opens nodes for libinput, and keeps which could not be opened, and why.
struct Opening {
  DeviceOpener opener;
  std::vector<std::pair<std::string, int>> denied;

  void Deny(const char* node, int reason) {
    const auto same = [&](const auto& denial) { return denial.first == node; };
    if (std::none_of(denied.begin(), denied.end(), same)) denied.emplace_back(node, reason);
  }
};

int OpenNode(const char* node, int flags, void* opening) {
  const int fd = static_cast<Opening*>(opening)->opener.open(node, flags);
  if (fd < 0) static_cast<Opening*>(opening)->Deny(node, -fd);
  return fd;
}

void CloseNode(int fd, void* opening) { static_cast<Opening*>(opening)->opener.close(fd); }

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

/// A descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {
    CHECK(fd >= 0, "the kernel gives descriptors for timers and polls");
  }
  ~Descriptor() { ::close(fd_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return fd_; }

 private:
  int fd_;
};

}  // namespace

struct LibinputSource::State {
  explicit State(LibinputOptions options)
      : opening{std::move(options.opener), {}}, devices(options.mice_and_keys) {}

  Opening opening;
  std::unique_ptr<udev, UnrefUdev> udev_library;
  std::unique_ptr<libinput, UnrefContext> context;
  LibinputDevices devices;
  bool suspended = false;
  Descriptor timer{::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)};
  Descriptor both{::epoll_create1(EPOLL_CLOEXEC)};  // libinput's descriptor and the timer's

  Result<void> Begin() const;
  void SetTimer() const;
};

/// Makes one descriptor of libinput's and the timer's.
Result<void> LibinputSource::State::Begin() const {
  if (!context) return Fail(ErrorCode::kDevice, "libinput can't be started");
  libinput_log_set_handler(context.get(), DropMessage);
  for (const int fd : {libinput_get_fd(context.get()), timer.get()}) {
    epoll_event waiting{};
    waiting.events = EPOLLIN;
    CHECK(::epoll_ctl(both.get(), EPOLL_CTL_ADD, fd, &waiting) == 0, "descriptors can be polled");
  }
  return {};
}

/// To the time when a held key types again; off while none is held.
void LibinputSource::State::SetTimer() const {
  const double due_s = devices.Due_s().value_or(0);
  itimerspec time{};
  time.it_value.tv_sec = static_cast<time_t>(due_s);
  time.it_value.tv_nsec = static_cast<int32_t>((due_s - std::floor(due_s)) * 1e9);
  ::timerfd_settime(timer.get(), TFD_TIMER_ABSTIME, &time, nullptr);
}

Result<LibinputSource> LibinputSource::OpenSeat(const std::string& seat, LibinputOptions options) {
  const auto unsmoothed = Unsmoothed::Make();
  if (!unsmoothed) return Fail(unsmoothed);
  auto state = std::make_unique<State>(std::move(options));
  state->udev_library.reset(udev_new());
  if (state->udev_library) {
    state->context.reset(
        libinput_udev_create_context(&kInterface, &state->opening, state->udev_library.get()));
  }
  if (auto fine = state->Begin(); !fine) return Fail(fine);
  if (libinput_udev_assign_seat(state->context.get(), seat.c_str()) != 0) {
    return Fail(ErrorCode::kDevice, fmt::format("libinput can't watch seat {}", seat),
                "name a device node instead, as `--device /dev/input/event5`");
  }
  return LibinputSource(std::move(state));
}

Result<LibinputSource> LibinputSource::OpenDevices(const std::vector<std::string>& nodes,
                                                   LibinputOptions options) {
  const auto unsmoothed = Unsmoothed::Make();
  if (!unsmoothed) return Fail(unsmoothed);
  const bool all = options.mice_and_keys;
  auto state = std::make_unique<State>(std::move(options));
  state->context.reset(libinput_path_create_context(&kInterface, &state->opening));
  if (auto fine = state->Begin(); !fine) return Fail(fine);
  for (const std::string& node : nodes) {
    if (::access(node.c_str(), F_OK) != 0) return tl::unexpected(CannotOpen(node, errno));
    libinput_device* device = libinput_path_add_device(state->context.get(), node.c_str());
    if (!state->opening.denied.empty()) {
      return tl::unexpected(CannotOpen(node, state->opening.denied.front().second));
    }
    if (!device || !(IsPenOrTouch(device) || (all && IsMouseOrKeys(device)))) {
      return Fail(ErrorCode::kDevice,
                  fmt::format("{} is not a {}pen tablet or touch screen that libinput takes", node,
                              all ? "mouse, keyboard, " : ""),
                  "`parti devices` lists those that are there");
    }
  }
  return LibinputSource(std::move(state));
}

LibinputSource::LibinputSource(std::unique_ptr<State> state) : state_(std::move(state)) {}
LibinputSource::LibinputSource(LibinputSource&&) noexcept = default;
LibinputSource& LibinputSource::operator=(LibinputSource&&) noexcept = default;
LibinputSource::~LibinputSource() = default;

int LibinputSource::fd() const { return state_->both.get(); }

Result<std::vector<InputEvent>> LibinputSource::Dispatch() {
  const int failed = libinput_dispatch(state_->context.get());
  if (failed != 0) {
    return Fail(ErrorCode::kDevice, fmt::format("libinput failed: {}", std::strerror(-failed)));
  }
  std::vector<InputEvent> events;
  while (libinput_event* event = libinput_get_event(state_->context.get())) {
    const std::unique_ptr<libinput_event, DestroyEvent> owned(event);
    state_->devices.Take(event, Now(), &events);
  }
  state_->devices.Tick(Now(), &events);
  state_->SetTimer();
  return events;
}

bool LibinputSource::Wait(double timeout_s) const {
  // Opening a device queues its arrival without making the descriptor readable.
  if (libinput_next_event_type(state_->context.get()) != LIBINPUT_EVENT_NONE) return true;
  pollfd waiting{fd(), POLLIN, 0};
  return ::poll(&waiting, 1, static_cast<int>(std::ceil(timeout_s * 1000))) > 0;
}

void LibinputSource::Suspend() {
  if (std::exchange(state_->suspended, true)) return;
  libinput_suspend(state_->context.get());
}

Result<void> LibinputSource::Resume() {
  if (!state_->suspended) return {};
  if (libinput_resume(state_->context.get()) != 0) {
    return Fail(ErrorCode::kDevice, "libinput can't take the input devices again",
                "switch to another terminal and back");
  }
  state_->suspended = false;
  return {};
}

void LibinputSource::SetView(const Vec2& size_px, double scale) {
  state_->devices.SetView(size_px, scale);
}

void LibinputSource::SetLeftHanded(bool left_handed) { state_->devices.SetLeftHanded(left_handed); }

const std::string& LibinputSource::node(int device) const { return state_->devices.node(device); }

int LibinputSource::present() const { return state_->devices.present(); }

Error LibinputSource::WhyNothing() const {
  for (const auto& [node, reason] : state_->opening.denied) {
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
