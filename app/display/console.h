// One of Linux's text consoles, taken over for graphics: its keys and its text rest, switching away
// is asked first, and it is as it was at the end, however the end comes.
// Not responsible for screens and devices (direct_seat.cc).
#pragma once

#include <memory>
#include <string>

#include "base/error.h"

namespace parti::app {

/// A child process waits for this one's end and restores the console then, so that kill -9 and
/// crashes leave no dead screen behind; signal handlers could not do as much.
class Console {
 public:
  enum class Wish { kNone, kLeave, kReturn };

  /// The console of standard input, or else the one in front. Nothing where the machine has none.
  /// errors  kDevice  it shows graphics already, or may not be used.
  static Result<std::unique_ptr<Console>> TakeOver();

  virtual ~Console() = default;
  Console() = default;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Readable when a wish has come.
  virtual int fd() const = 0;
  /// What the kernel wants since the last call: the last wish counts.
  virtual Wish Next() = 0;
  /// Answers kLeave: another console comes to the front.
  virtual void Leave() = 0;
  virtual void SwitchTo(int number) = 0;
  virtual int number() const = 0;  ///< 2 of /dev/tty2
};

}  // namespace parti::app
