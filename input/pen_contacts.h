// When pens touch and leave their surfaces: the one definition of where a stroke begins and ends,
// shared by the strokes themselves and by the stroke counts of drawings.
// Not responsible for samples (strokes_from_events.h) or for what a stroke means.
#pragma once

#include <optional>
#include <vector>

#include "base/event.h"

namespace parti::input {

/// Why a stroke was over.
enum class StrokeEnd : uint8_t { kPenUp, kProximityOut, kDeviceRemoved, kEndOfStream };

/// What one event did to its device's pen. `ended` and `began` together: the report that the pen
/// was lifted got lost, and it is down again.
struct ContactChange {
  std::optional<StrokeEnd> ended = {};
  bool began = false;
  bool moved = false;  ///< a further sample of the stroke in progress

  bool operator==(const ContactChange&) const = default;
};

/// Value-typed state machine: feed it every event of a stream in order; any stream is taken.
///
/// A stroke lasts from kDown to the first of: kUp; kProximityOut or kProximityIn (the up got lost);
/// another kDown; the device going or coming anew; the end of the stream. Motion and kUp without a
/// kDown are hovering. Each device has one pen at a time. Cost: linear in the pens that are down.
class PenContacts {
 public:
  /// The next event of the stream.
  ContactChange Feed(const InputEvent& event);

  /// Whether a device's pen is down; and all whose pens are, in the order in which they came down.
  bool IsDown(int device) const;
  const std::vector<int>& down() const { return down_; }

  bool operator==(const PenContacts&) const = default;

 private:
  ContactChange Feed(const PenEvent& event);
  bool Lift(int device);

  std::vector<int> down_;
};

}  // namespace parti::input
