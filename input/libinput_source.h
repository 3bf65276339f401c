// Pens and touch screens through libinput: a udev seat, or given device nodes (S1).
// Not responsible for keyboards, mice and touchpads (they are left alone), for gestures and palm
// rejection, or for mapping the surface into a view.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/event.h"

namespace parti::input {

/// Pen positions are as the device sent them: libinput's smoothing is off (unsmoothed.h). Times are
/// CLOCK_MONOTONIC's, whole microseconds, never decreasing; those of devices that come and go are
/// the times at which that was noticed. Pressure is libinput's: 0 at the tip's threshold (usually 5
/// % of the device's range), 1 at the range's end.
class LibinputSource {
 public:
  /// All devices of a seat, now and later; none may be there yet (WhyNothing says why).
  /// errors  kDevice  libinput can't be started on the seat;  kFile as Unsmoothed::Make.
  static Result<LibinputSource> OpenSeat(const std::string& seat = "seat0");

  /// The devices of these nodes ("/dev/input/event5").
  /// errors  kDevice  a node is missing, not permitted, or no pen tablet and no touch screen.
  static Result<LibinputSource> OpenDevices(const std::vector<std::string>& nodes);

  LibinputSource(LibinputSource&&) noexcept;
  LibinputSource& operator=(LibinputSource&&) noexcept;
  ~LibinputSource();

  /// Readable when Dispatch has something to give; for an application's own poll.
  int fd() const;

  /// What came since the last call, without waiting. The first call gives the devices that are
  /// there. errors  kDevice  libinput failed for good; events that came before are lost with it.
  Result<std::vector<InputEvent>> Dispatch();

  /// Waits until there is something to dispatch, a signal comes, or the time is over; says whether
  /// there is.
  bool Wait(double timeout_s) const;

  /// The node of a device that was added, by its number.
  const std::string& node(int device) const;

  /// Pens and touch screens that are there now, as of the last Dispatch.
  int present() const;

  /// kDevice: why no pen and no touch screen has come, with the remedy.
  Error WhyNothing() const;

 private:
  struct State;
  explicit LibinputSource(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

/// Why a device node can't be opened, with the remedy. `reason` is an errno value.
Error CannotOpen(const std::string& node, int reason);

}  // namespace parti::input
