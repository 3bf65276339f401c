// The three texts from which umockdev mocks a device: its place in sysfs, its answers to ioctl, and
// its events. See umockdev-record(1) for the formats.
#pragma once

#include <string>

#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// The device of the recording as /dev/input/event5, number 13:69.
std::string UmockdevDevice(const EvdevRecording& recording);

/// Its answers. umockdev tells requests apart by the length of the caller's buffer, so these are
/// answers to libevdev's requests and no one else's.
std::string UmockdevIoctls(const EvdevRecording& recording);

/// Its events, `start_us` being the clock at the first, as a script of reads: each line a pause in
/// milliseconds and the bytes of one report, up to and with its SYN_REPORT.
std::string UmockdevScript(const EvdevRecording& recording, int64_t start_us, double speed);

/// What udev stores of a device that it is done with.
std::string UdevData();

}  // namespace parti::tests
