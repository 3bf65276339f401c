// The right to use a screen and its input devices, and when it is lent to somebody else (another
// console). Through libseat where logind, seatd or root's powers are there, else direct.
// Not responsible for what is opened: screens are render/kms_screen.h, input LibinputSource.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"

namespace parti::app {

/// What happened to the seat since the last Dispatch.
struct SeatNews {
  /// Another console is wanted: stop using screen and input, then ConfirmPause.
  bool pause_asked = false;
  /// The seat is ours again; input devices have to be opened anew, the mode set anew.
  bool resumed = false;
};

/// Used by one thread, but for Open and Close, which any may call. The console shows text again,
/// and takes keys, once the seat is destroyed or the process ends in whatever way, kill -9
/// included.
class Seat {
 public:
  virtual ~Seat() = default;
  Seat() = default;
  Seat(const Seat&) = delete;
  Seat& operator=(const Seat&) = delete;

  /// Opens /dev/dri/cardN (as DRM master) or /dev/input/eventN; close it with Close.
  /// Returns a descriptor, or a negative errno value.
  virtual int Open(const std::string& path) = 0;
  virtual void Close(int fd) = 0;

  /// Whether screen and devices are ours now.
  virtual bool active() const = 0;
  /// Readable when Dispatch has something to do.
  virtual int fd() const = 0;
  /// Never waits. errors  kDevice  the seat is gone for good.
  virtual Result<SeatNews> Dispatch() = 0;
  /// After pause_asked, once screen and input rest.
  virtual void ConfirmPause() = 0;
  /// Asks for console `vt` (Ctrl+Alt+F3 is 3); what follows comes with Dispatch.
  virtual void SwitchTo(int vt) = 0;
  /// "seat0".
  virtual std::string name() const = 0;
  /// Who manages it, for a line in a terminal: "libseat", "the console tty2".
  virtual std::string Description() const = 0;
};

/// errors  kDevice  neither works; says why, and the remedy.
Result<std::unique_ptr<Seat>> OpenSeat();

/// logind, seatd, or what root may do, whichever libseat finds.
/// errors  kDevice  none of them is there, or this console is not in front.
Result<std::unique_ptr<Seat>> OpenLibseatSeat();

/// The console that is in front, with the permissions of the user. Works without a console too:
/// then nobody can take the seat away.
/// errors  kDevice  the console is in use by a desktop, or may not be used.
Result<std::unique_ptr<Seat>> OpenDirectSeat();

/// Why a seat's device can't be opened, with the remedy. `reason` is an errno value.
Error CannotOpenScreen(const std::string& path, int reason);

}  // namespace parti::app
