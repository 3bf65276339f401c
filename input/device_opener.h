// Who opens the nodes of input devices: the program itself, or a seat manager in its place.
// Not responsible for which devices there are (libinput_source.h).
#pragma once

#include <functional>

namespace parti::input {

/// How to open and close a node. A seat manager (libseat) puts its own calls here.
struct DeviceOpener {
  /// The descriptor of a node ("/dev/input/event5") opened with flags of open(2), or -errno.
  std::function<int(const char* node, int flags)> open;
  /// Gives back a descriptor that `open` gave.
  std::function<void(int fd)> close;
};

/// open(2) and close(2). Read only where writing is not permitted: no lamp needs setting.
DeviceOpener OwnOpener();

}  // namespace parti::input
