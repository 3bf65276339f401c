// Tells that the machine was asleep: screens that slept want their mode set anew.
// Not responsible for what then has to be done.
#pragma once

namespace parti::app {

/// Needs no desktop and no D-Bus: the kernel wakes a timer of the wall clock when the machine comes
/// out of sleep, and the clock that counts sleep (CLOCK_BOOTTIME) has then gone ahead of the one
/// that doesn't.
class WakeWatch {
 public:
  WakeWatch();
  ~WakeWatch();
  WakeWatch(const WakeWatch&) = delete;
  WakeWatch& operator=(const WakeWatch&) = delete;

  /// Readable when Look has something to do, which also the setting of the clock causes.
  int fd() const { return fd_; }
  /// Whether the machine has slept since the last call.
  bool Look();

 private:
  void Arm() const;

  int fd_;
  double asleep_s_;
};

}  // namespace parti::app
