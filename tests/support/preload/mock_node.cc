// Preloaded before umockdev's own library into programs that read a mocked tablet: mends what
// umockdev 0.17 leaves real, so that libinput takes the tablet without root. Two things:
//  - A node /dev/input/eventN (umockdev answers its ioctls) for which there is a named pipe
//    eventN.pipe in the folder MOCK_FOLDER gives its events from there, and tells the number
//    13:64+N in fstat, which libinput compares with udev's. umockdev's own player goes through a
//    pseudo terminal: it loses what it plays before the program is ready, splits events, and tells
//    the terminal's number.
//  - libudev looks in /run/udev/data whether udev is done with the device, or libinput waits for
//    ever. Files of that folder are looked for in MOCK_FOLDER/udev instead.
// Built without sanitizers: it is loaded before their runtime.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
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

constexpr int kNodes = 32;  // that evdev has
constexpr unsigned kMajor = 13, kFirstMinor = 64;

std::string PipeOf(int number) {
  const char* folder = std::getenv("MOCK_FOLDER");
  return std::string(folder ? folder : "") + "/event" + std::to_string(number) + ".pipe";
}

/// Of whose events this is the pipe; -1: it is none.
template <typename Stat>
int MockedNumber(const Stat& facts) {
  if (!S_ISFIFO(facts.st_mode)) return -1;
  for (int number = 0; number < kNodes; ++number) {
    struct stat pipe {};
    if (::stat(PipeOf(number).c_str(), &pipe) != 0) continue;
    if (pipe.st_dev == facts.st_dev && pipe.st_ino == facts.st_ino) return number;
  }
  return -1;
}

template <typename Stat>
void TellMockedNumber(Stat* facts) {
  const int number = MockedNumber(*facts);
  if (number < 0) return;
  facts->st_mode = (facts->st_mode & ~static_cast<mode_t>(S_IFMT)) | S_IFCHR;
  facts->st_rdev = makedev(kMajor, kFirstMinor + static_cast<unsigned>(number));
}

/// Puts the pipe in the place of the mocked node, under the descriptor that umockdev knows. Done by
/// system calls, since umockdev watches the functions.
int WithEvents(int fd, const char* path) {
  int number = 0;
  if (fd < 0 || std::sscanf(path, "/dev/input/event%d", &number) != 1) return fd;
  const auto pipe =
      ::syscall(SYS_openat, AT_FDCWD, PipeOf(number).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (pipe < 0) return fd;
  ::syscall(SYS_dup3, pipe, fd, O_CLOEXEC);
  ::syscall(SYS_close, pipe);
  return fd;
}

std::string Moved(const char* path) {
  constexpr std::string_view kUdevData = "/run/udev/data/";
  const char* folder = std::getenv("MOCK_FOLDER");
  const std::string_view asked = path ? path : "";
  if (!folder || !asked.starts_with(kUdevData)) return std::string(asked);
  return std::string(folder) + "/udev/" + std::string(asked.substr(kUdevData.size()));
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
  return WithEvents(Next<int(const char*, int, ...)>("open")(Moved(path).c_str(), flags, mode),
                    path);
}

int open64(const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return WithEvents(Next<int(const char*, int, ...)>("open64")(Moved(path).c_str(), flags, mode),
                    path);
}

int openat(int folder, const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return WithEvents(
      Next<int(int, const char*, int, ...)>("openat")(folder, Moved(path).c_str(), flags, mode),
      path);
}

int openat64(int folder, const char* path, int flags, ...) {
  MODE_ARGUMENT(flags)
  return WithEvents(
      Next<int(int, const char*, int, ...)>("openat64")(folder, Moved(path).c_str(), flags, mode),
      path);
}

// What programs built with _FORTIFY_SOURCE call in the place of the two open functions.
int __open_2(const char* path, int flags) {  // NOLINT(readability-identifier-naming)
  return open(path, flags);
}
int __open64_2(const char* path, int flags) {  // NOLINT(readability-identifier-naming)
  return open64(path, flags);
}

}  // extern "C"
