#include "app/display/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/kd.h>
#include <linux/major.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace parti::app {
namespace {

/// As the console was before.
struct Before {
  int tty = -1;
  int keys = K_UNICODE;
  vt_mode switching{};
};

/// Only calls that are safe in a child forked from a program with threads.
void Restore(const Before& before) {
  ::ioctl(before.tty, VT_SETMODE, &before.switching);
  ::ioctl(before.tty, KDSKBMODE, before.keys);
  ::ioctl(before.tty, KDSETMODE, KD_TEXT);
}

/// The child: lives until the other end of `alive` is closed, which the kernel does at our end.
[[noreturn]] void Watch(const Before& before, int alive) {
  // Out of the way of what ends its parent's group, but in its session: without privileges the
  // kernel lets only those restore a console whose terminal it is.
  ::setpgid(0, 0);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGTTIN, SIGTTOU}) {
    ::signal(signal, SIG_IGN);
  }
  // Whatever else is open would be held beyond our end: screens, files, pipes.
  const auto lower = static_cast<unsigned>(std::min(before.tty, alive));
  const auto upper = static_cast<unsigned>(std::max(before.tty, alive));
  if (lower > 0) ::close_range(0, lower - 1, 0);
  if (upper > lower + 1) ::close_range(lower + 1, upper - 1, 0);
  ::close_range(upper + 1, ~0U, 0);
  char told = 0;
  ssize_t count = 0;
  while ((count = ::read(alive, &told, 1)) < 0 && errno == EINTR) {
  }
  if (count == 0) Restore(before);
  ::_exit(0);
}

/// Where the handlers of the two signals leave word; one console a process.
std::atomic<int> wish_pipe{-1};

void TellLeave(int) {
  const int saved = errno;
  [[maybe_unused]] const ssize_t written = ::write(wish_pipe, "-", 1);
  errno = saved;
}
void TellReturn(int) {
  const int saved = errno;
  [[maybe_unused]] const ssize_t written = ::write(wish_pipe, "+", 1);
  errno = saved;
}

class TakenConsole final : public Console {
 public:
  TakenConsole(const Before& before, int number) : before_(before), number_(number) {}
  ~TakenConsole() override;

  Result<void> Take();
  int fd() const override { return wishes_[0]; }
  Wish Next() override;
  void Leave() override { ::ioctl(before_.tty, VT_RELDISP, 1); }
  void SwitchTo(int number) override { ::ioctl(before_.tty, VT_ACTIVATE, number); }
  int number() const override { return number_; }

 private:
  Result<void> StartWatch();

  Before before_;
  int number_;
  std::array<int, 2> wishes_{-1, -1};
  int alive_ = -1;
  pid_t watch_ = -1;
  struct sigaction old_leave_ {};
  struct sigaction old_return_ {};
};

Result<void> TakenConsole::StartWatch() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return Fail(ErrorCode::kDevice, "can't watch over the console: no pipe");
  }
  watch_ = ::fork();
  if (watch_ == 0) {
    ::close(ends[1]);
    Watch(before_, ends[0]);
  }
  ::close(ends[0]);
  alive_ = ends[1];
  if (watch_ < 0) return Fail(ErrorCode::kDevice, "can't watch over the console: no process");
  return {};
}

Result<void> TakenConsole::Take() {
  if (const auto watched = StartWatch(); !watched) return watched;
  if (::pipe2(wishes_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    return Fail(ErrorCode::kDevice, "can't listen to the console: no pipe");
  }
  wish_pipe = wishes_[1];
  struct sigaction leave {};
  leave.sa_handler = TellLeave;
  leave.sa_flags = SA_RESTART;
  struct sigaction back = leave;
  back.sa_handler = TellReturn;
  ::sigaction(SIGRTMIN, &leave, &old_leave_);
  ::sigaction(SIGRTMIN + 1, &back, &old_return_);
  vt_mode ask{};
  ask.mode = VT_PROCESS;
  ask.relsig = static_cast<short>(SIGRTMIN);
  ask.acqsig = static_cast<short>(SIGRTMIN + 1);
  if (::ioctl(before_.tty, VT_SETMODE, &ask) != 0 || ::ioctl(before_.tty, KDSKBMODE, K_OFF) != 0 ||
      ::ioctl(before_.tty, KDSETMODE, KD_GRAPHICS) != 0) {
    return Fail(ErrorCode::kDevice,
                fmt::format("can't use the console tty{}: {}", number_, std::strerror(errno)),
                "log in on that console, or run as root");
  }
  return {};
}

TakenConsole::~TakenConsole() {
  Restore(before_);
  if (wishes_[1] >= 0) {
    ::sigaction(SIGRTMIN, &old_leave_, nullptr);
    ::sigaction(SIGRTMIN + 1, &old_return_, nullptr);
    wish_pipe = -1;
    ::close(wishes_[0]);
    ::close(wishes_[1]);
  }
  if (watch_ > 0) {
    // It is over in good order: the child has nothing to do.
    [[maybe_unused]] const ssize_t written = ::write(alive_, "!", 1);
    ::close(alive_);
    ::waitpid(watch_, nullptr, 0);
  }
  ::close(before_.tty);
}

Console::Wish TakenConsole::Next() {
  Wish wish = Wish::kNone;
  char told = 0;
  while (::read(wishes_[0], &told, 1) == 1) {
    wish = told == '-' ? Wish::kLeave : Wish::kReturn;
  }
  if (wish == Wish::kReturn) ::ioctl(before_.tty, VT_RELDISP, VT_ACKACQ);
  return wish;
}

/// The number of the console behind a descriptor, 0 where it is none.
int NumberOf(int fd) {
  struct stat file {};
  if (::fstat(fd, &file) != 0 || !S_ISCHR(file.st_mode) || major(file.st_rdev) != TTY_MAJOR) {
    return 0;
  }
  const auto number = static_cast<int>(minor(file.st_rdev));
  return number <= MAX_NR_CONSOLES ? number : 0;
}

/// The console that this runs on, or else the one in front; 0 where there is none.
int OurNumber() {
  if (const int number = NumberOf(STDIN_FILENO)) return number;
  const int any = ::open("/dev/tty0", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (any < 0) return 0;
  vt_stat state{};
  const bool known = ::ioctl(any, VT_GETSTATE, &state) == 0;
  ::close(any);
  return known ? state.v_active : 0;
}

/// Brings the console to the front. Whoever has the front is asked first, and may take its time.
void BringToFront(int tty, int number) {
  constexpr int kTries = 40, kStep_us = 50'000;
  ::ioctl(tty, VT_ACTIVATE, number);
  for (int tries = 0; tries < kTries; ++tries) {
    vt_stat state{};
    if (::ioctl(tty, VT_GETSTATE, &state) != 0 || state.v_active == number) return;
    ::usleep(kStep_us);
  }
}

}  // namespace

Result<std::unique_ptr<Console>> Console::TakeOver() {
  const int number = OurNumber();
  if (number == 0) return nullptr;
  const std::string path = fmt::format("/dev/tty{}", number);
  Before before;
  before.tty = ::open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  int shows = KD_TEXT;
  if (before.tty < 0 || ::ioctl(before.tty, KDGETMODE, &shows) != 0) {
    const int reason = errno;
    if (before.tty >= 0) ::close(before.tty);
    return Fail(ErrorCode::kDevice,
                fmt::format("can't use the console {}: {}", path, std::strerror(reason)),
                "log in on that console, or run as root");
  }
  if (shows != KD_TEXT) {
    ::close(before.tty);
    return Fail(ErrorCode::kDevice, fmt::format("the console {} shows a desktop already", path),
                "start Parti within it with `--display x11`, or on a free console (Ctrl+Alt+F3)");
  }
  ::ioctl(before.tty, KDGKBMODE, &before.keys);
  ::ioctl(before.tty, VT_GETMODE, &before.switching);
  BringToFront(before.tty, number);
  auto console = std::make_unique<TakenConsole>(before, number);
  if (const auto taken = console->Take(); !taken) return Fail(taken);
  return console;
}

}  // namespace parti::app
