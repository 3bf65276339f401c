// Input events to pen strokes on the device's surface (S1): a pure state machine.
// Not responsible for mapping strokes into a view, or for recognising anything.
#pragma once

#include <optional>
#include <vector>

#include "base/event.h"
#include "input/pen_contacts.h"

namespace parti::input {

/// One report of a pen in contact.
struct PenSample {
  Vec2 position_mm{0, 0};               ///< as in PenEvent
  double t_s = 0;                       ///< s, of the source's clock
  std::optional<double> pressure = {};  ///< [0, 1]
  std::optional<Vec2> tilt_deg = {};    ///< as in PenEvent

  bool operator==(const PenSample&) const = default;
};

/// A line drawn without lifting the pen.
struct PenStroke {
  int device = 0;
  PenTool tool = PenTool::kPen;  ///< kEraser: the stroke rubs out
  /// One or more, in the order drawn, times never decreasing. A dot has one sample.
  std::vector<PenSample> samples;
  StrokeEnd end = StrokeEnd::kPenUp;

  bool operator==(const PenStroke&) const = default;
};

/// Value-typed, incremental: an application feeds it each event as it comes.
///
/// A stroke's samples are its kDown and the kMotion events up to its end (see PenContacts). The
/// position of kUp is not one of them: the tip has left the surface by then. Reports without a
/// finite position and time are skipped; a time before its predecessor's is raised to it.
/// Properties  (1) feeding a stream in any pieces gives the same strokes;
///             (2) the samples of all strokes are the stream's kDown and in-contact kMotion events;
///             (3) as many strokes finish as PenContacts reports begun, if each has a finite
///             sample.
class StrokesFromEvents {
 public:
  /// The stroke that this event ended, if any.
  std::optional<PenStroke> Feed(const InputEvent& event);

  /// The strokes that the end of the stream cuts off; the machine is as new afterwards.
  std::vector<PenStroke> Finish();

  /// The strokes being drawn now, for live ink.
  const std::vector<PenStroke>& in_progress() const { return in_progress_; }

  bool operator==(const StrokesFromEvents&) const = default;

 private:
  std::optional<PenStroke> Take(int device, StrokeEnd end);
  void Append(const PenEvent& event);

  PenContacts contacts_;
  std::vector<PenStroke> in_progress_;
};

/// All strokes of a whole stream.
std::vector<PenStroke> StrokesOf(const std::vector<InputEvent>& events);

}  // namespace parti::input
