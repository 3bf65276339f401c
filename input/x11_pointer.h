// One pointing device of an X server, from its raw reports to events: a value-typed state machine.
// Pure: knows no server. What the device is, is read in x11_devices.h.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/event.h"

namespace parti::input {

/// What a valuator of a device means to us.
enum class X11Role : uint8_t { kPressure, kDistance, kTiltX, kTiltY, kScrollX, kScrollY };

/// One valuator.
struct X11Axis {
  int number = 0;  ///< as in reports
  X11Role role = X11Role::kPressure;
  double low = 0, high = 0;          ///< its range; high > low but for scrolling
  double step = 1;                   ///< of scrolling: one notch; may be negative
  std::optional<double> value = {};  ///< the last one; of scrolling: as far as known
};

/// What is known of a device when it comes.
struct X11PointerFacts {
  int device = 0;  ///< our number for it
  PenTool tool = PenTool::kMouse;
  std::vector<X11Axis> axes;
  /// Its buttons are told when its tip touches, in place of button 1, and go when it lifts; 2 and 3
  /// are exchanged. So the wacom driver does with what is built into a computer's screen.
  bool buttons_with_tip = false;
};

/// A report, as XInput2 sends it.
struct X11PointerReport {
  enum class Kind : uint8_t { kMotion, kPress, kRelease, kEnter, kLeave, kProximityOut };
  Kind kind = Kind::kMotion;
  double t_s = 0;
  Vec2 position_px{0, 0};                      ///< in the window; not of kProximityOut
  int button = 0;                              ///< X's number: 1 the tip or the left one
  bool emulated = false;                       ///< made by the server from another report
  std::vector<std::pair<int, double>> values;  ///< of valuators that changed, by number
  /// X's numbers of the buttons that were down before it, where the server says so.
  std::optional<std::vector<int>> held = {};
};

/// What a report of a tablet's pad means: its ring and strips turn a wheel where the pointer is.
/// Its keys are buttons to X, but not the pointer's: they mean nothing. device  in whose name it is
/// told.
std::optional<ScrollEvent> X11PadScroll(const X11PointerReport& report, int device,
                                        double px_per_mm);

/// Pens: X has no word for coming near, so a pen's first report is that; the tip is button 1.
/// Buttons 4 to 7 are a wheel's where the device has no scrolling valuators. A pen that comes near
/// with buttons held tells them at once: it left while another device moved the pointer, or beyond
/// the window's edge, and X tells a press once.
class X11Pointer {
 public:
  X11Pointer(X11PointerFacts facts, double px_per_mm)
      : facts_(std::move(facts)), px_per_mm_(px_per_mm) {}

  /// The events that follow from it, in order.
  std::vector<InputEvent> Feed(const X11PointerReport& report);
  /// The pointer went to another device, or the device out of use: it is lifted and leaves.
  std::vector<InputEvent> Leave(double t_s);
  /// The device's scrolling valuators stand here now; scrolling elsewhere doesn't count.
  void SetScroll(const std::vector<std::pair<int, double>>& values);

  int device() const { return facts_.device; }
  PenTool tool() const { return facts_.tool; }
  bool is_down() const { return down_; }

 private:
  PenEvent Make(PenEvent::Kind kind, double t_s) const;
  std::optional<double> Fraction(X11Role role) const;
  std::optional<double> Tilt_deg(X11Role role) const;
  void TakeValues(const X11PointerReport& report, Vec2* steps);
  uint32_t CodeOf(int button) const;
  void ComeNear(const X11PointerReport& report, std::vector<InputEvent>* out);
  PenEvent SideButton(int button, bool pressed, double t_s) const;
  void Touch(bool touches, double t_s, std::vector<InputEvent>* out);
  void Press(const X11PointerReport& report, std::vector<InputEvent>* out);
  bool HasScroll() const;

  X11PointerFacts facts_;
  double px_per_mm_;
  Vec2 position_mm_{0, 0};
  bool near_ = false;
  std::vector<int> held_;  // a pen's side buttons, by X's number
  bool down_ = false;
};

}  // namespace parti::input
