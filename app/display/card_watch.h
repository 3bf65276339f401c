// Tells that screens were plugged or unplugged, through udev.
// Not responsible for which screens there are (render/kms_output.h).
#pragma once

#include <cstdint>
#include <memory>

struct udev;
struct udev_monitor;

namespace parti::app {

/// Without udev it never tells anything.
class CardWatch {
 public:
  CardWatch();
  ~CardWatch();
  CardWatch(const CardWatch&) = delete;
  CardWatch& operator=(const CardWatch&) = delete;

  /// Readable when Look has something to do; -1 without udev.
  int fd() const;
  enum class News { kNone, kOthers, kPerhapsOurs };
  /// What graphics cards have said since the last call: that screens have changed, perhaps the one
  /// of `connector`; kernels before 5.16 don't say which.
  News Look(uint32_t connector);

 private:
  struct Unref {
    void operator()(udev* library) const;
    void operator()(udev_monitor* monitor) const;
  };
  std::unique_ptr<udev, Unref> library_;
  std::unique_ptr<udev_monitor, Unref> monitor_;
};

}  // namespace parti::app
