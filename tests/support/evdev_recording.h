// What a tablet's kernel driver said: its description and its raw events, as evemu records them.
// Not responsible for playing it (mock_tablet.h).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"

namespace parti::tests {

/// One axis as EVIOCGABS describes it; resolution in units per mm (per radian for tilt), 0:
/// unknown.
struct EvdevAxis {
  int32_t minimum = 0;
  int32_t maximum = 0;
  int32_t fuzz = 0;
  int32_t flat = 0;
  int32_t resolution = 0;
};

struct EvdevEvent {
  int64_t t_us = 0;  ///< since the first event
  uint16_t type = 0;
  uint16_t code = 0;
  int32_t value = 0;
};

struct EvdevRecording {
  std::string name;
  uint16_t bus = 3;  ///< USB
  uint16_t vendor = 0;
  uint16_t product = 0;
  uint16_t version = 0;
  std::vector<uint8_t> properties;            ///< INPUT_PROP_* bits
  std::map<int, std::vector<uint8_t>> codes;  ///< by event type: the codes' bits
  std::map<int, EvdevAxis> axes;              ///< by ABS_* code
  std::vector<EvdevEvent> events;
  bool begins_with_visit = false;  ///< a pen comes and goes before what was recorded begins

  void SetCode(int type, int code);
};

/// Reads evemu's text, versions 1.1 to 1.3. errors  kBadText  no name, no events, a bad number.
Result<EvdevRecording> ReadEvemu(std::string_view text, std::string_view file);

/// The same where only the description counts and events may be missing.
Result<EvdevRecording> ReadEvemuDevice(std::string_view text, std::string_view file);

/// Gives ABS_X and ABS_Y a resolution where the recording has none: evemu 1.1 did not store it.
void AssumeResolution(int32_t units_per_mm, EvdevRecording* recording);

}  // namespace parti::tests
