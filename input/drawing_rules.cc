#include "input/drawing_rules.h"

#include <fmt/format.h>

#include <cmath>

#include "base/utf8.h"

namespace parti::input {
namespace {

using Limits = DrawingLimits;

Result<void> CheckRange(std::string_view what, double value, double low, double high) {
  if (value >= low && value <= high) return {};  // false for NaN
  return Fail(ErrorCode::kBadNumber,
              fmt::format("{} is {}, not in [{}, {}]", what, value, low, high));
}

Result<void> CheckPosition(const Vec2& position_mm) {
  for (const double value : {position_mm.x, position_mm.y}) {
    if (auto fine =
            CheckRange("a position [mm]", value, -Limits::kMillimetres, Limits::kMillimetres);
        !fine) {
      return fine;
    }
  }
  return {};
}

Result<void> CheckNumbers(const DeviceEvent& event) {
  if (event.facts.name.size() > Limits::kNameBytes) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("a device's name is longer than {} bytes", Limits::kNameBytes));
  }
  if (const auto scale = event.facts.view_px_per_mm) {
    constexpr double kLeast = 1 / Limits::kPixelsPerMm;
    auto fine = CheckRange("a view's pixels per mm", *scale, kLeast, Limits::kPixelsPerMm);
    if (!fine) return fine;
  }
  if (!event.facts.size_mm) return {};
  for (const double value : {event.facts.size_mm->x, event.facts.size_mm->y}) {
    if (auto fine = CheckRange("a device's size [mm]", value, 0, Limits::kMillimetres); !fine) {
      return fine;
    }
  }
  return {};
}

Result<void> CheckNumbers(const PenEvent& event) {
  auto fine = CheckPosition(event.position_mm);
  if (fine) fine = CheckRange("a button's code", event.button, 0, Limits::kEvdevCode);
  if (fine && event.pressure) fine = CheckRange("the pressure", *event.pressure, 0, 1);
  if (fine && event.distance) fine = CheckRange("the distance", *event.distance, 0, 1);
  if (!event.tilt_deg) return fine;
  for (const double tilt : {event.tilt_deg->x, event.tilt_deg->y}) {
    if (fine) fine = CheckRange("a tilt [deg]", tilt, -Limits::kTiltDegrees, Limits::kTiltDegrees);
  }
  return fine;
}

Result<void> CheckNumbers(const TouchEvent& event) {
  if (event.finger < 0) return Fail(ErrorCode::kBadNumber, "a finger's number is negative");
  return CheckPosition(event.position_mm);
}

Result<void> CheckNumbers(const KeyEvent& event) {
  if (event.text.size() > Limits::kTextBytes || !IsUtf8(event.text)) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("a key's text is not UTF-8 of at most {} bytes", Limits::kTextBytes));
  }
  return CheckRange("a key's code", event.code, 0, Limits::kEvdevCode);
}

Result<void> CheckNumbers(const ScrollEvent& event) {
  for (const double steps : {event.steps.x, event.steps.y}) {
    if (auto fine = CheckRange("a wheel's steps", steps, -Limits::kSteps, Limits::kSteps); !fine) {
      return fine;
    }
  }
  return CheckPosition(event.position_mm);
}

Result<void> CheckTime(double t_s, double previous_s) {
  if (auto fine = CheckRange("the time [s]", t_s, 0, Limits::kSeconds); !fine) return fine;
  if (t_s >= previous_s) return {};
  return Fail(ErrorCode::kBadNumber,
              fmt::format("time runs backwards, from {} s to {} s", previous_s, t_s));
}

}  // namespace

Result<void> DrawingRules::CheckDevice(const InputEvent& event) const {
  const int device = std::visit([](const auto& e) { return e.device; }, event);
  const auto known = static_cast<int>(present_.size());
  const auto* coming = std::get_if<DeviceEvent>(&event);
  if (coming && coming->kind == DeviceEvent::Kind::kAdded) {
    if (device == known && known < Limits::kDevices) return {};
    return Fail(ErrorCode::kBadArguments, fmt::format("device {} is added out of turn", device),
                fmt::format("devices are numbered from 0 as they come: {} is next, {} the last",
                            known, Limits::kDevices - 1));
  }
  if (device >= 0 && device < known && present_[static_cast<size_t>(device)]) return {};
  return Fail(ErrorCode::kBadArguments, fmt::format("there is no device {} here", device),
              "a `device` line must add it before its events");
}

Result<void> DrawingRules::Take(const InputEvent& event) {
  auto fine = CheckTime(std::visit([](const auto& e) { return e.t_s; }, event), t_s_);
  if (fine) fine = CheckDevice(event);
  if (fine) fine = std::visit([](const auto& e) { return CheckNumbers(e); }, event);
  if (!fine) return fine;
  t_s_ = std::visit([](const auto& e) { return e.t_s; }, event);
  if (const auto* change = std::get_if<DeviceEvent>(&event)) {
    const bool added = change->kind == DeviceEvent::Kind::kAdded;
    if (added)
      present_.push_back(true);
    else
      present_[static_cast<size_t>(change->device)] = false;
  }
  if (contacts_.Feed(event).ended) ++strokes_;
  return {};
}

Result<void> DrawingRules::TakeCommand(int after_stroke, std::string_view text) {
  if (after_stroke != strokes_) {
    return Fail(ErrorCode::kBadNumber,
                fmt::format("a command after stroke {} stands where {} strokes are complete",
                            after_stroke, strokes_),
                "put it right after the `pen … up` that completes its stroke");
  }
  using namespace std::string_view_literals;
  if (text.find_first_not_of(" \t") == std::string_view::npos) {
    return Fail(ErrorCode::kBadArguments, "a command without words");
  }
  if (text.size() + sizeof("after 2147483647: ") > Limits::kLineBytes) {
    return Fail(ErrorCode::kBadArguments, fmt::format("a command of {} bytes", text.size()),
                fmt::format("at most {} bytes go on a line", Limits::kLineBytes));
  }
  if (text.find_first_of("\n\r\0"sv) != std::string_view::npos) {
    return Fail(ErrorCode::kBadArguments, "a command with a line break or a zero byte in it");
  }
  return {};
}

}  // namespace parti::input
