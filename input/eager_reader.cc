#include "input/eager_reader.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

#include "base/check.h"

namespace parti::input {
namespace {

int NewEventFd() {
  const int fd = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  CHECK(fd >= 0, "the process has no file descriptors left");
  return fd;
}

void Signal(int fd) {
  const uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(fd, &one, sizeof one);
}

}  // namespace

EagerReader::EagerReader(int fd, Read read)
    : fd_(fd), read_(std::move(read)), came_(NewEventFd()), stop_(NewEventFd()), thread_([this] {
        Run();
      }) {}

EagerReader::~EagerReader() {
  Signal(stop_);
  thread_.join();
  ::close(came_);
  ::close(stop_);
}

Result<std::vector<InputEvent>> EagerReader::Take() {
  const std::lock_guard lock(mutex_);
  uint64_t count = 0;
  [[maybe_unused]] const ssize_t cleared = ::read(came_, &count, sizeof count);
  ReadOnce();
  if (failed_ && events_.empty()) return tl::unexpected(*failed_);
  if (failed_) Signal(came_);  // the failure is still to be taken
  return std::exchange(events_, {});
}

void EagerReader::ReadOnce() {
  if (failed_) return;
  auto events = read_();
  if (!events) {
    failed_ = events.error();
    return;
  }
  events_.insert(events_.end(), std::make_move_iterator(events->begin()),
                 std::make_move_iterator(events->end()));
}

void EagerReader::Run() {
  std::array<pollfd, 2> waiting = {pollfd{fd_, POLLIN, 0}, pollfd{stop_, POLLIN, 0}};
  while (true) {
    ::poll(waiting.data(), waiting.size(), -1);
    if (waiting[1].revents != 0) return;
    if (waiting[0].revents == 0) continue;  // a signal
    const std::lock_guard lock(mutex_);
    ReadOnce();
    if (failed_ || !events_.empty()) Signal(came_);
    if (failed_) return;
  }
}

}  // namespace parti::input
