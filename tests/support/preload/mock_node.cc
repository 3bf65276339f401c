// Preloaded before umockdev's own library into programs that read a mocked tablet: mends what
// umockdev 0.17 leaves real, so that libinput takes the tablet without root. Three things:
//  - fstat of the node tells the pseudo terminal behind it (major 136 to 143); libinput compares it
//    with udev's number and refuses. MOCK_NODE=13:69 is told instead.
//  - libudev looks in /run/udev/data whether udev is done with the device, or libinput waits for
//    ever. Files of that folder are looked for in the folder MOCK_UDEV_DATA instead.
//  - a pseudo terminal that has fallen behind splits an event in two, a kernel's node never does;
//    libevdev gives the device up then. Reads are completed to whole events here.
// Built without sanitizers: it is loaded before their runtime.
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/input.h>
#include <poll.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

template <typename Function>
Function* Next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool IsPseudoTerminal(mode_t mode, dev_t device) {
  constexpr unsigned kFirst = 136, kLast = 143;
  return S_ISCHR(mode) && major(device) >= kFirst && major(device) <= kLast;
}

template <typename Stat>
void TellMockedNumber(Stat* facts) {
  unsigned major_number = 0, minor_number = 0;
  const char* number = std::getenv("MOCK_NODE");
  if (!number || !IsPseudoTerminal(facts->st_mode, facts->st_rdev)) return;
  if (std::sscanf(number, "%u:%u", &major_number, &minor_number) != 2) return;
  facts->st_rdev = makedev(major_number, minor_number);
}

std::string Moved(const char* path) {
  constexpr std::string_view kUdevData = "/run/udev/data/";
  const char* folder = std::getenv("MOCK_UDEV_DATA");
  const std::string_view asked = path ? path : "";
  if (!folder || !asked.starts_with(kUdevData)) return std::string(asked);
  return std::string(folder) + "/" + std::string(asked.substr(kUdevData.size()));
}

/// The permissions of a call that may create a file, from behind its named arguments.
#define MODE_ARGUMENT(flags)                    \
  mode_t mode = 0;                              \
  if (((flags) & (O_CREAT | O_TMPFILE)) != 0) { \
    va_list rest;                               \
    va_start(rest, flags);                      \
    mode = va_arg(rest, mode_t);                \
    va_end(rest);                               \
  }

}  // namespace

extern "C" {

int fstat(int fd, struct stat* facts) noexcept {
  const int result = Next<int(int, struct stat*)>("fstat")(fd, facts);
  if (result == 0) TellMockedNumber(facts);
  return result;
}

int fstat64(int fd, struct stat64* facts) noexcept {
  const int result = Next<int(int, struct stat64*)>("fstat64")(fd, facts);
  if (result == 0) TellMockedNumber(facts);
  return result;
}

FILE* fopen(const char* path, const char* mode) {
  return Next<FILE*(const char*, const char*)>("fopen")(Moved(path).c_str(), mode);
}

FILE* fopen64(const char* path, const char* mode) {
  return Next<FILE*(const char*, const char*)>("fopen64")(Moved(path).c_str(), mode);
}

int open(const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return Next<int(const char*, int, ...)>("open")(Moved(path).c_str(), flags, mode);
}

int open64(const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return Next<int(const char*, int, ...)>("open64")(Moved(path).c_str(), flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return Next<int(int, const char*, int, ...)>("openat")(folder, Moved(path).c_str(), flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return Next<int(int, const char*, int, ...)>("openat64")(folder, Moved(path).c_str(), flags,
                                                           mode);
}

ssize_t read(int fd, void* buffer, size_t size) {
  static auto* const next = Next<ssize_t(int, void*, size_t)>("read");
  static auto* const next_fstat = Next<int(int, struct stat*)>("fstat");
  constexpr ssize_t kEvent = sizeof(input_event);
  ssize_t got = next(fd, buffer, size);
  struct stat facts {};
  if (got <= 0 || got % kEvent == 0 || size % kEvent != 0) return got;
  if (next_fstat(fd, &facts) != 0 || !IsPseudoTerminal(facts.st_mode, facts.st_rdev)) return got;
  while (got % kEvent != 0) {
    pollfd waiting{fd, POLLIN, 0};
    if (::poll(&waiting, 1, -1) < 0) return got;
    const auto missing = static_cast<size_t>(kEvent - got % kEvent);
    const ssize_t more = next(fd, static_cast<char*>(buffer) + got, missing);
    if (more <= 0) return got;
    got += more;
  }
  return got;
}

}  // extern "C"
