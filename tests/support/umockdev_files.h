// The texts from which umockdev mocks a device: its place in sysfs and its answers to ioctl; see
// umockdev-record(1) for the formats. Its events come another way (preload/mock_node.cc).
#pragma once

#include <string>
#include <vector>

#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// Where a mocked device sits, and what udev says of it.
struct MockPlace {
  int number = 5;  ///< of /dev/input/eventN, [0, 31]
  std::vector<std::string> properties = {"ID_INPUT_TABLET=1"};
};

/// The device of the recording.
std::string UmockdevDevice(const EvdevRecording& recording, const MockPlace& place = {});

/// Its path in sysfs, and that of its node.
std::string SysfsPath(const MockPlace& place);
std::string SysfsNodePath(const MockPlace& place);

/// Its answers. umockdev tells requests apart by the length of the caller's buffer, so these are
/// answers to libevdev's requests and no one else's.
std::string UmockdevIoctls(const EvdevRecording& recording, const MockPlace& place = {});

/// The name of the file in which udev stores what it knows of the device, and its text.
std::string UdevDataName(const MockPlace& place = {});
std::string UdevData(const MockPlace& place = {});

}  // namespace parti::tests
