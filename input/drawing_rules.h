// What every drawing keeps to, checked event by event: by the reader, where breaking a rule is
// damage, and by the writer, so that it never writes what the reader would refuse.
#pragma once

#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "input/pen_contacts.h"

namespace parti::input {

/// Bounds that no honest drawing reaches; beyond them a file is damaged or hostile.
struct DrawingLimits {
  static constexpr size_t kLines = 20'000'000;     ///< events and commands; 27 h of pen at 200 Hz
  static constexpr size_t kLineBytes = 8'388'608;  ///< a line without its end; may be a rule file
  static constexpr int kDevices = 1'000;           ///< come and gone, in one drawing
  static constexpr double kSeconds = 1e7;          ///< length of a drawing: 115 days
  static constexpr double kMillimetres = 1e5;      ///< distance from the surface's corner: 100 m
  static constexpr double kTiltDegrees = 90;
  static constexpr uint32_t kEvdevCode = 0xffff;  ///< of buttons and keys: evdev's are 16 bits
  static constexpr size_t kNameBytes = 1'000;     ///< of a device's name
  static constexpr size_t kTextBytes = 256;       ///< that one key types
  static constexpr double kSteps = 1'000;         ///< of a wheel in one report
  static constexpr double kPixelsPerMm = 1e4;     ///< of a view; more than 0
};

/// Value-typed state of a drawing so far.
class DrawingRules {
 public:
  /// The next event of the stream.
  /// errors  kBadNumber      a number is not finite or outside the limits, or a time is before its
  ///                         predecessor's;
  ///         kBadArguments   a device that is used before it was added, added twice or gone; a
  ///                         key's text that is too long or not UTF-8.
  Result<void> Take(const InputEvent& event);

  /// A command at this place of the stream.
  /// errors  kBadNumber     `after_stroke` is not the number of strokes completed here;
  ///         kBadArguments  the text is empty, too long, or holds a line break or a zero byte.
  Result<void> TakeCommand(int after_stroke, std::string_view text);

  /// Strokes completed so far, by any pen.
  int strokes() const { return strokes_; }
  bool pen_is_down() const { return !contacts_.down().empty(); }

 private:
  Result<void> CheckDevice(const InputEvent& event) const;

  PenContacts contacts_;
  int strokes_ = 0;
  double t_s_ = 0;
  std::vector<bool> present_;  // by device number
};

}  // namespace parti::input
