#include "input/device_opener.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace parti::input {
namespace {

int OpenNode(const char* node, int flags) {
  int fd = ::open(node, flags | O_CLOEXEC);
  if (fd < 0 && errno == EACCES) {
    fd = ::open(node, (flags & ~O_ACCMODE) | O_RDONLY | O_CLOEXEC);
  }
  return fd >= 0 ? fd : -errno;
}

}  // namespace

DeviceOpener OwnOpener() {
  return {OpenNode, [](int fd) { ::close(fd); }};
}

}  // namespace parti::input
