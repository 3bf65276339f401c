// The devices of a libinput context: numbers them, and turns their events into a stream of
// InputEvents. Not responsible for the context itself, or for waiting (libinput_source.h).
#pragma once

#include <libinput.h>

#include <optional>
#include <string>
#include <vector>

#include "base/event.h"
#include "input/key_repeat.h"
#include "input/keyboard.h"
#include "input/pointer_position.h"

namespace parti::input {

/// Times of the stream never decrease; those of devices that come and go, and of keys that repeat,
/// are the times at which that was noticed.
class LibinputDevices {
 public:
  /// Pens and touch screens are always listened to; mice, touchpads and keyboards where wanted.
  explicit LibinputDevices(bool mice_and_keys) : mice_and_keys_(mice_and_keys) {}

  /// Appends what the event says, which may be nothing.
  void Take(libinput_event* event, double now_s, std::vector<InputEvent>* out);

  /// When a held key types again; and that press, when it is due.
  std::optional<double> Due_s() const { return repeat_.Due_s(); }
  void Tick(double now_s, std::vector<InputEvent>* out);

  /// The view that mice point into (see PointerPosition).
  void SetView(const Vec2& size_px, double scale) { pointer_.SetView(size_px, scale); }

  /// Whether the buttons of mice and touchpads are swapped.
  void SetLeftHanded(bool left_handed);

  /// The node of a device by its number; how many are there now.
  const std::string& node(int device) const;
  int present() const;

 private:
  struct Device {
    libinput_device* handle = nullptr;  // libinput's, valid while present
    DeviceFacts facts;
    std::string node;
    bool present = true;
    std::vector<Vec2> fingers_mm = {};  // by finger: the last position, for ups, which have none
    std::optional<Keyboard> keyboard = {};
  };

  void Add(libinput_device* device, double now_s, std::vector<InputEvent>* out);
  void Remove(libinput_device* device, double now_s, std::vector<InputEvent>* out);
  std::optional<InputEvent> Report(libinput_event* event, int number);
  void CompletePosition(TouchEvent* touch);
  void Type(KeyEvent* key);
  void Hand(const Device& device) const;
  double NeverBefore(double t_s);
  Device& At(int number) { return devices_[static_cast<size_t>(number)]; }

  bool mice_and_keys_;
  bool left_handed_ = false;
  std::vector<Device> devices_;
  PointerPosition pointer_;
  KeyRepeat repeat_;
  double last_t_s_ = 0;
};

}  // namespace parti::input
