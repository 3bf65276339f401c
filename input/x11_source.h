// Pens, fingers, mice and keys of an X server, over one window: XInput2's events as ours.
// Not responsible for the window itself, or for palms and gestures (palm_arbitration.h,
// gestures.h).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/event.h"
#include "input/x11_clock.h"
#include "input/x11_devices.h"
#include "input/x11_keyboard.h"

struct _XDisplay;
union _XEvent;

namespace parti::input {

/// All of its devices point into the view. A pen and its eraser are two devices, as X has them.
/// Times are CLOCK_MONOTONIC's, never decreasing.
class X11Source {
 public:
  /// Listens to `window` from now on; the display outlives the source. px_per_mm > 0 turns the
  /// window's pixels into events' millimetres.
  /// errors  kDevice  the server has no XInput 2.2.
  static Result<std::unique_ptr<X11Source>> Create(_XDisplay* display, unsigned long window,
                                                   double px_per_mm);

  /// The devices that are there; before any other event.
  std::vector<InputEvent> Begin();
  /// The input events in `event`, of whatever kind it is; its cookie is fetched and freed.
  std::vector<InputEvent> Take(_XEvent* event);
  /// The window lost the keyboard: keys that are held are released.
  std::vector<InputEvent> ReleaseKeys();

 private:
  struct Touches {
    std::map<uint32_t, int> fingers;  // by the server's number
    std::map<int, Vec2> positions_mm;
  };
  struct Held {
    int device = 0;
    uint32_t keycode = 0;  // the server's
    uint32_t code = 0;     // of its press
  };

  X11Source(_XDisplay* display, unsigned long window, double px_per_mm, int opcode);
  void Select();
  void Add(const X11Device& device, double t_s, std::vector<InputEvent>* out);
  void Remove(int id, double t_s, std::vector<InputEvent>* out);
  void Refresh(double t_s, std::vector<InputEvent>* out);
  void WatchProximity(int id);
  std::map<int, X11Pointer>::iterator FindPointer(int id, int master);
  std::map<int, X11Pointer>::iterator AnyMouse();
  void TakePointer(const void* data, std::vector<InputEvent>* out);
  void TakeCrossing(const void* data, std::vector<InputEvent>* out);
  void TakeTouch(const void* data, std::vector<InputEvent>* out);
  void TakeKey(const void* data, std::vector<InputEvent>* out);
  void TakeHierarchy(const void* data, std::vector<InputEvent>* out);
  void LeaveOthers(int id, double t_s, std::vector<InputEvent>* out);
  double Time(unsigned long time_ms);

  _XDisplay* display_;
  unsigned long window_;
  double px_per_mm_;
  int opcode_;
  int proximity_out_ = -1;  // the event's number, once a device that sends it has come
  X11Clock clock_;
  X11Keyboard keyboard_;
  int next_number_ = 0;
  std::map<int, std::pair<int, DeviceFacts>> devices_;  // by the server's number: ours and facts
  std::map<int, X11Pointer> pointers_;
  std::map<int, Touches> touches_;
  std::vector<Held> held_;
};

}  // namespace parti::input
