// The seat without a manager: devices are opened as the user may, the console is taken over, and
// the kernel's DRM master is dropped and taken again when consoles are switched.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <xf86drm.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <set>

#include "app/display/console.h"
#include "app/display/seat.h"

namespace parti::app {
namespace {

bool IsScreen(const std::string& path) { return path.starts_with("/dev/dri/"); }

class DirectSeat final : public Seat {
 public:
  explicit DirectSeat(std::unique_ptr<Console> console)
      : console_(std::move(console)), silent_(console_ ? -1 : ::eventfd(0, EFD_CLOEXEC)) {}
  ~DirectSeat() override {
    for (const int fd : screens_) {
      ::drmDropMaster(fd);  // somebody may hold a copy of the descriptor
      ::close(fd);
    }
    // Only now the console's text has the screen to itself.
    console_.reset();
    if (silent_ >= 0) ::close(silent_);
  }

  int Open(const std::string& path) override;
  void Close(int fd) override;
  bool active() const override { return active_; }
  int fd() const override { return console_ ? console_->fd() : silent_; }
  Result<SeatNews> Dispatch() override;
  void ConfirmPause() override;
  void SwitchTo(int vt) override {
    if (console_) console_->SwitchTo(vt);
  }
  std::string name() const override { return "seat0"; }
  std::string Description() const override {
    return console_ ? fmt::format("the console tty{}", console_->number()) : "no console";
  }

 private:
  std::unique_ptr<Console> console_;
  int silent_;        // never readable, for machines without consoles
  std::mutex mutex_;  // of screens_
  std::set<int> screens_;
  bool active_ = true;
};

int DirectSeat::Open(const std::string& path) {
  const int flags = O_RDWR | O_CLOEXEC | O_NOCTTY | O_NONBLOCK;
  int fd = ::open(path.c_str(), flags);
  if (fd < 0 && errno == EACCES && !IsScreen(path)) {  // no lamp of a pen needs setting
    fd = ::open(path.c_str(), (flags & ~O_ACCMODE) | O_RDONLY);
  }
  if (fd < 0) return -errno;
  if (!IsScreen(path)) return fd;
  // The first to open a screen is its master already; who comes later has to ask.
  if (::drmIsMaster(fd) == 0 && ::drmSetMaster(fd) != 0) {
    ::close(fd);
    return -EBUSY;
  }
  const std::lock_guard lock(mutex_);
  screens_.insert(fd);
  return fd;
}

void DirectSeat::Close(int fd) {
  const std::lock_guard lock(mutex_);
  if (screens_.erase(fd) > 0) ::drmDropMaster(fd);
  ::close(fd);
}

Result<SeatNews> DirectSeat::Dispatch() {
  const Console::Wish wish = console_ ? console_->Next() : Console::Wish::kNone;
  SeatNews news;
  if (wish == Console::Wish::kLeave && active_) {
    active_ = false;
    news.pause_asked = true;
  } else if (wish == Console::Wish::kReturn && !active_) {
    const std::lock_guard lock(mutex_);
    for (const int fd : screens_) {
      if (::drmSetMaster(fd) != 0) {
        return Fail(ErrorCode::kDevice, "another program has taken the screen",
                    "what was drawn is kept; end the other program and start again");
      }
    }
    active_ = true;
    news.resumed = true;
  }
  return news;
}

void DirectSeat::ConfirmPause() {
  {
    const std::lock_guard lock(mutex_);
    for (const int fd : screens_) ::drmDropMaster(fd);
  }
  if (console_) console_->Leave();
}

}  // namespace

Result<std::unique_ptr<Seat>> OpenDirectSeat() {
  auto console = Console::TakeOver();
  if (!console) return Fail(console);
  return std::make_unique<DirectSeat>(std::move(*console));
}

}  // namespace parti::app
