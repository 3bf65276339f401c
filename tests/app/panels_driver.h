// Drives panels as a hand would: finds a button by what it says and taps it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/panels/panels.h"

namespace parti::app::tests {

/// Panels with a view to look at; each call is one or more frames.
class PanelDriver {
 public:
  PanelDriver();

  PanelView view;

  /// One frame with these events.
  const PanelOutput& Frame(std::vector<PanelEvent> events = {});
  /// The first target whose name begins or ends with this: "Tools/Undo", "Undo"; fails the test,
  /// and gives an empty one, where there is none.
  PanelTarget Find(const std::string& name);
  bool Shows(const std::string& name);
  /// A tap in its middle: what a pen does, coming from nowhere. Returns what came of it.
  std::vector<PanelCommand> Tap(const std::string& name);
  /// The pointer above its middle.
  const PanelOutput& Hover(const std::string& name);
  /// Press, motion in steps, release.
  std::vector<PanelCommand> Drag(const std::string& name, const Vec2& way_px);
  /// Press and release.
  std::vector<PanelCommand> Key(uint32_t code, const std::string& text = "");
  std::vector<PanelCommand> Type(const std::string& text);
  /// Taps a line of text, types another one and presses Enter.
  std::vector<PanelCommand> TypeOver(const std::string& line, const std::string& text);
  /// Whether a line of text holds this.
  bool Says(const std::string& text);
  /// Tab until the name has the focus, then Enter.
  std::vector<PanelCommand> PressByKeys(const std::string& name);

  const PanelOutput& last() const { return *last_; }
  const PanelOutput& last_or_first() { return last_ ? *last_ : Frame(); }

 private:
  std::vector<PanelCommand> Done();

  std::unique_ptr<Panels> panels_;
  const PanelOutput* last_ = nullptr;
  double now_s_ = 0;
};

Vec2 MiddleOf(const PanelTarget& target);

/// The session of the shipped house before its n-th pick (from 1): its suggestions are on the
/// table.
std::shared_ptr<const SessionSnapshot> HouseBeforePick(int pick);
/// The house with all its rules.
std::shared_ptr<const SessionSnapshot> WholeHouse();

/// The house with windows tapped.
std::shared_ptr<const SessionSnapshot> HouseWithTaps(int taps);
/// A house made by rule files with layers; the first shape of a query, if any, is tapped.
std::shared_ptr<const SessionSnapshot> LayeredHouse(const std::string& tapped = "");
/// A façade tapped, with two elements that can be placed by hand in the middle of the window; the
/// lower one is in hand.
void HoldElement(PanelView* view);
/// The same with a node in hand.
std::shared_ptr<const SessionSnapshot> Taken(const std::shared_ptr<const SessionSnapshot>& session,
                                             const NodePath& path);
/// The same with a query chosen for the next sketch.
std::shared_ptr<const SessionSnapshot> Chosen(const std::shared_ptr<const SessionSnapshot>& session,
                                              const std::string& query);
/// The same with a full disk, and a command that failed.
std::shared_ptr<const SessionSnapshot> InTrouble(
    const std::shared_ptr<const SessionSnapshot>& session);

}  // namespace parti::app::tests
