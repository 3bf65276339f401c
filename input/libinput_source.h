// Pens, touch screens, mice and keyboards through libinput: a udev seat, or given device nodes
// (S1). Not responsible for gestures and palm rejection, or for mapping a tablet's surface into a
// view.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "input/device_opener.h"

namespace parti::input {

/// What a source listens to, and how it opens devices.
struct LibinputOptions {
  DeviceOpener opener = OwnOpener();
  /// Mice, touchpads and keyboards as well as pens and touch screens. A recorder does without:
  /// passwords are typed, too.
  bool mice_and_keys = false;
};

/// Pen positions are as the device sent them: libinput's smoothing is off (unsmoothed.h). Its
/// calibration of pens and touch screens (udev's LIBINPUT_CALIBRATION_MATRIX) is applied. Times are
/// CLOCK_MONOTONIC's, whole microseconds, never decreasing; those of devices that come and go are
/// the times at which that was noticed. Pressure is libinput's: 0 at the tip's threshold (usually 5
/// % of the device's range), 1 at the range's end. Mice move one pointer, within the view that
/// SetView tells; keys type by the system's layout and repeat while they are held.
class LibinputSource {
 public:
  /// All devices of a seat, now and later; none may be there yet (WhyNothing says why).
  /// errors  kDevice  libinput can't be started on the seat;  kFile as Unsmoothed::Make.
  static Result<LibinputSource> OpenSeat(const std::string& seat = "seat0",
                                         LibinputOptions options = {});

  /// The devices of these nodes ("/dev/input/event5").
  /// errors  kDevice  a node is missing, not permitted, or not what the options listen to.
  static Result<LibinputSource> OpenDevices(const std::vector<std::string>& nodes,
                                            LibinputOptions options = {});

  LibinputSource(LibinputSource&&) noexcept;
  LibinputSource& operator=(LibinputSource&&) noexcept;
  ~LibinputSource();

  /// Readable when Dispatch has something to give, repeating keys included; for an application's
  /// own poll.
  int fd() const;

  /// What came since the last call, without waiting. The first call gives the devices that are
  /// there. errors  kDevice  libinput failed for good; events that came before are lost with it.
  Result<std::vector<InputEvent>> Dispatch();

  /// Waits until there is something to dispatch, a signal comes, or the time is over; says whether
  /// there is.
  bool Wait(double timeout_s) const;

  /// Gives all devices back, as when another virtual terminal comes to the front. The next
  /// Dispatch says that they are gone; nothing comes until Resume.
  void Suspend();

  /// Takes the devices again; they come with new numbers. Without Suspend it does nothing.
  /// errors  kDevice  the seat can't be watched again; Resume may be tried once more.
  Result<void> Resume();

  /// The view that mice point into: its size and how many of its pixels one of libinput's is.
  /// 1600 x 1000 and 1 until it is told.
  void SetView(const Vec2& size_px, double scale);

  /// Swaps the buttons of mice and touchpads. Tablets are turned by app::TabletMapping.
  void SetLeftHanded(bool left_handed);

  /// The node of a device that was added, by its number.
  const std::string& node(int device) const;

  /// Devices listened to that are there now, as of the last Dispatch.
  int present() const;

  /// kDevice: why no device has come, with the remedy.
  Error WhyNothing() const;

 private:
  struct State;
  explicit LibinputSource(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

/// Why a device node can't be opened, with the remedy. `reason` is an errno value.
Error CannotOpen(const std::string& node, int reason);

}  // namespace parti::input
