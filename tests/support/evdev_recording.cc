#include "tests/support/evdev_recording.h"

#include <fmt/format.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace parti::tests {
namespace {

void AppendHex(std::istringstream& words, std::vector<uint8_t>* bytes) {
  for (unsigned byte = 0; words >> std::hex >> byte;) bytes->push_back(static_cast<uint8_t>(byte));
}

bool ReadLine(const std::string& line, EvdevRecording* recording) {
  std::istringstream words(line.substr(3, line.find('#') - 3));
  switch (line[0]) {
    case 'N':
      recording->name = line.substr(3);
      return true;
    case 'I':
      words >> std::hex >> recording->bus >> recording->vendor >> recording->product >>
          recording->version;
      return !words.fail();
    case 'P':
      AppendHex(words, &recording->properties);
      return true;
    case 'B': {
      int type = 0;
      words >> std::hex >> type;
      AppendHex(words, &recording->codes[type]);
      return true;
    }
    case 'A': {
      int code = 0;
      words >> std::hex >> code >> std::dec;
      EvdevAxis& axis = recording->axes[code];
      words >> axis.minimum >> axis.maximum >> axis.fuzz >> axis.flat;
      if (words.fail()) return false;
      words >> axis.resolution;  // not in version 1.1
      return true;
    }
    case 'E': {
      double t_s = 0;
      EvdevEvent event;
      words >> t_s >> std::hex >> event.type >> event.code >> std::dec >> event.value;
      event.t_us = std::llround(t_s * 1e6);
      recording->events.push_back(event);
      return !words.fail();
    }
    default:
      return true;
  }
}

}  // namespace

void EvdevRecording::SetCode(int type, int code) {
  auto& bits = codes[type];
  const auto byte = static_cast<size_t>(code / 8);
  if (bits.size() <= byte) bits.resize(byte + 1);
  bits[byte] = static_cast<uint8_t>(bits[byte] | 1u << (code % 8));
}

Result<EvdevRecording> ReadEvemuDevice(std::string_view text, std::string_view file) {
  EvdevRecording recording;
  std::istringstream lines{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.size() < 3 || line[1] != ':') continue;
    if (!ReadLine(line, &recording)) {
      return Fail(ErrorCode::kBadText, fmt::format("{}:{}: not evemu's: {}", file, number, line));
    }
  }
  if (recording.name.empty()) return Fail(ErrorCode::kBadText, fmt::format("{}: no name", file));
  return recording;
}

Result<EvdevRecording> ReadEvemu(std::string_view text, std::string_view file) {
  auto recording = ReadEvemuDevice(text, file);
  if (!recording) return recording;
  if (recording->events.empty()) {
    return Fail(ErrorCode::kBadText, fmt::format("{}: no events", file));
  }
  const int64_t start = recording->events.front().t_us;
  for (EvdevEvent& event : recording->events) event.t_us -= start;
  return recording;
}

void AssumeResolution(int32_t units_per_mm, EvdevRecording* recording) {
  for (const int code : {ABS_X, ABS_Y}) {
    const auto axis = recording->axes.find(code);
    if (axis == recording->axes.end() || axis->second.resolution != 0) continue;
    axis->second.resolution = units_per_mm;
  }
}

}  // namespace parti::tests
