// The seat that logind or seatd gives, or that root may take, through libseat. It is their part to
// restore the console when the process ends.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <utility>

#include "app/display/seat.h"

extern "C" {  // which the header forgets
#include <libseat.h>
}

namespace parti::app {
namespace {

constexpr int kPatience_ms = 3000;  ///< for the manager's first word; it takes a few ms
constexpr int kStep_ms = 100;

class LibseatSeat final : public Seat {
 public:
  ~LibseatSeat() override {
    if (!seat_) return;
    for (const auto& [fd, device] : devices_) libseat_close_device(seat_, device);
    libseat_close_seat(seat_);
  }

  Result<void> Start();
  int Open(const std::string& path) override;
  void Close(int fd) override;
  bool active() const override { return active_; }
  int fd() const override { return libseat_get_fd(seat_); }
  Result<SeatNews> Dispatch() override;
  void ConfirmPause() override {
    const std::lock_guard lock(mutex_);
    libseat_disable_seat(seat_);
  }
  void SwitchTo(int vt) override {
    const std::lock_guard lock(mutex_);
    libseat_switch_session(seat_, vt);
  }
  std::string name() const override { return libseat_seat_name(seat_); }
  std::string Description() const override { return "libseat"; }

 private:
  static void Enable(libseat*, void* self) {
    auto* seat = static_cast<LibseatSeat*>(self);
    seat->active_ = true;
    seat->news_.resumed = true;
  }
  static void Disable(libseat*, void* self) {
    auto* seat = static_cast<LibseatSeat*>(self);
    seat->active_ = false;
    seat->news_ = {true, false};
  }

  std::mutex mutex_;  // libseat knows no threads
  libseat* seat_ = nullptr;
  std::atomic<bool> active_ = false;
  SeatNews news_;
  std::map<int, int> devices_;  // by descriptor: libseat's number
};

/// libseat knows no "why" beyond errno.
constexpr const char* kRemedy =
    "log in on a console of this machine (not over ssh), or install and start seatd";

Result<void> LibseatSeat::Start() {
  static constexpr libseat_seat_listener kListener{Enable, Disable};
  libseat_set_log_level(LIBSEAT_LOG_LEVEL_SILENT);
  seat_ = libseat_open_seat(&kListener, this);
  if (!seat_) {
    return Fail(
        ErrorCode::kDevice,
        fmt::format("no seat: neither logind nor seatd gives one ({})", std::strerror(errno)),
        kRemedy);
  }
  for (int waited = 0; !active_ && waited < kPatience_ms; waited += kStep_ms) {
    if (libseat_dispatch(seat_, kStep_ms) < 0) break;
  }
  if (!active_) {
    return Fail(ErrorCode::kDevice,
                "no seat: its manager does not give it (another console may be in front)", kRemedy);
  }
  news_ = {};
  return {};
}

int LibseatSeat::Open(const std::string& path) {
  const std::lock_guard lock(mutex_);
  int fd = -1;
  const int device = libseat_open_device(seat_, path.c_str(), &fd);
  if (device < 0) return errno > 0 ? -errno : -EIO;
  devices_[fd] = device;
  return fd;
}

void LibseatSeat::Close(int fd) {
  const std::lock_guard lock(mutex_);
  const auto found = devices_.find(fd);
  if (found == devices_.end()) return;
  libseat_close_device(seat_, found->second);
  devices_.erase(found);
}

Result<SeatNews> LibseatSeat::Dispatch() {
  const std::lock_guard lock(mutex_);
  if (libseat_dispatch(seat_, 0) < 0 && errno != EAGAIN && errno != EINTR) {
    return Fail(ErrorCode::kDevice, fmt::format("the seat is gone ({})", std::strerror(errno)),
                "what was drawn is kept; log in again");
  }
  return std::exchange(news_, {});
}

}  // namespace

Result<std::unique_ptr<Seat>> OpenLibseatSeat() {
  auto seat = std::make_unique<LibseatSeat>();
  if (const auto started = seat->Start(); !started) return Fail(started);
  return seat;
}

}  // namespace parti::app
