// One thread tells another, which waits in poll, that there is something to fetch.
// What there is to fetch lies elsewhere, behind its owner's lock.
#pragma once

namespace parti::app {

/// An eventfd. Wake may be called from any thread, and from signal handlers.
class WakeFd {
 public:
  WakeFd();
  ~WakeFd();
  WakeFd(const WakeFd&) = delete;
  WakeFd& operator=(const WakeFd&) = delete;

  int fd() const { return fd_; }  ///< readable after Wake, until Clear
  void Wake() const;
  /// Whether it was woken since the last Clear; any number of times count as one.
  bool Clear() const;

 private:
  int fd_;
};

}  // namespace parti::app
