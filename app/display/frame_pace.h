// "Not before so many seconds have passed", as a descriptor that wakes a loop.
// Not a clock: what time it is, is nobody's business here.
#pragma once

namespace parti::app {

/// Open until closed, then closed for a while; it opens within Look. Used by one thread.
class FramePace {
 public:
  FramePace();
  ~FramePace();
  FramePace(const FramePace&) = delete;
  FramePace& operator=(const FramePace&) = delete;

  /// Readable when Look would open it.
  int fd() const { return fd_; }
  bool open() const { return open_; }
  /// Closes it for so long; 0 or less leaves it open. [s]
  void CloseFor(double seconds_s);
  /// Opens it when its time has come; says whether it did.
  bool Look();

 private:
  int fd_;
  bool open_ = true;
};

}  // namespace parti::app
