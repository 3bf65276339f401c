// A seat that is not there: several mocked devices that come and go while the real libinput looks.
// For one device and one recording, mock_tablet.h is simpler.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "tests/support/evdev_recording.h"
#include "tests/support/umockdev_files.h"

namespace parti::tests {

/// What the source said at one look.
struct SeatLook {
  std::vector<InputEvent> events;
  std::vector<std::string> words;  ///< other lines: why there is nothing
};

/// Builds the script of seat/mock_seat.cc, then runs it. Everything but Send is followed by a look.
class MockSeat {
 public:
  MockSeat();
  ~MockSeat();
  MockSeat(const MockSeat&) = delete;
  MockSeat& operator=(const MockSeat&) = delete;

  /// Describes a device that may be plugged in.
  void Describe(const EvdevRecording& device, const MockPlace& place);

  /// A line of the script: "plug 5", "unplug 5", "deny 5", "suspend", "why", "wait 0.5" …
  void Do(const std::string& line) { script_ += line + "\n"; }

  /// Raw events of a device; a SYN_REPORT is added after each group of equal times.
  void Send(int number, const std::vector<EvdevEvent>& events);

  /// Recorded events, which have their own SYN_REPORTs.
  void Play(int number, const std::vector<EvdevEvent>& events);

  /// The layout of its keyboards ("de"); "us" unless set.
  void SetLayout(const std::string& layout) { layout_ = layout; }

  /// What each look saw, in order. errors  kDevice  the seat's program failed.
  Result<std::vector<SeatLook>> Run();

 private:
  std::filesystem::path folder_;
  std::string script_;
  std::string layout_ = "us";
};

/// Raw events by short names, times in ms.
EvdevEvent Raw(double t_ms, int type, int code, int value);

/// A touch screen of ten fingers, 40 units/mm, of no known make.
EvdevRecording TouchScreen(Vec2 size_mm);

/// A mouse with a wheel and three buttons; a keyboard with all letters; a device that is a keyboard
/// to the system, but has these keys only.
EvdevRecording Mouse();
EvdevRecording KeyboardDevice();
EvdevRecording KeysOnly(const std::string& name, const std::vector<int>& keys);

}  // namespace parti::tests
