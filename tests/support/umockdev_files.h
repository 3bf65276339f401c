// The texts from which umockdev mocks a device: its place in sysfs and its answers to ioctl; see
// umockdev-record(1) for the formats. Its events come another way (preload/mock_node.cc).
#pragma once

#include <string>

#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// The device of the recording as /dev/input/event5, number 13:69.
std::string UmockdevDevice(const EvdevRecording& recording);

/// Its answers. umockdev tells requests apart by the length of the caller's buffer, so these are
/// answers to libevdev's requests and no one else's.
std::string UmockdevIoctls(const EvdevRecording& recording);

/// What udev stores of a device that it is done with.
std::string UdevData();

}  // namespace parti::tests
