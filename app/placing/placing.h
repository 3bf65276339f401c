// Placing by hand in the application: what of the face in hand can be placed, the drag that goes
// on, and the command that it ends in. The face is looked up beside the thread that draws. What a
// drag does is layer_drag.h's; which drags come here is application.h's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/hands.h"
#include "app/latest_worker.h"
#include "app/placing/element_in_hand.h"
#include "app/placing/held_element.h"
#include "app/placing/layer_marks.h"

namespace parti::app {

/// What a drag of act kSelect came to.
struct PlacingStep {
  bool taken = false;   ///< it places, or did until it was cancelled: it selects nothing
  bool tapped = false;  ///< it took hold of an element, but stayed where it was
  std::optional<PlaceElement> command = {};  ///< to be posted: the drag has ended elsewhere
};

/// Used by the thread that draws; owns one that looks at rules. Nothing is lost by cancelling: only
/// commands change the model. They say what a hand wants, not what the rules are: the session may
/// be deriving still when the next one comes. Properties: (1) a drag that is taken is taken until
/// it ends; (2) a cancelled one gives no command, nor does one whose rules somebody else has
/// changed meanwhile; (3) drags and buttons go on from what the ones before have come to, executed
/// or not.
class Placing {
 public:
  /// The newest state, and up to which request it is.
  void SetState(std::shared_ptr<const SessionState> state, uint64_t executed);
  /// Shows what has been found since; whether marks look different. Call it when ready() wakes.
  bool Update();

  /// One report of a drag of act kSelect, seen in this view. scale: of the display.
  PlacingStep Take(const DragAct& drag, const View& view, double scale);
  /// What a button does with the element in hand; the command to be posted, if it changes it.
  std::optional<PlaceElement> Do(ElementCommand command);
  /// The command of the last drag or button was posted as request `number`: until that is executed
  /// and looked at, elements are shown as it places them.
  void Await(uint64_t number);
  /// Lets go of what is dragged and leaves all as it was; whether anything was dragged.
  bool Cancel();
  /// The same where a finger of this device drags: a second one came down.
  bool CancelOf(int device) { return device_ == device && Cancel(); }

  /// A pen that would select hovers there. Whether marks look different.
  bool HoverAt(const Vec2& px, const View& view, double scale);
  bool HoverEnd();
  /// "Door", "edge of Door": what the hovering pen would take hold of; while an element is dragged
  /// where it is, or how large: "4 m from the left, 0.5 m up"; "" nothing.
  std::string word() const;

  /// The element in hand, the one that was dragged or tapped last; nothing while one is dragged.
  std::optional<ElementInHand> InHand(const View& view) const;
  /// All that show handles; what lies behind the eye is left out.
  std::vector<SeenElement> Seen(const View& view) const;

  /// Adds what is to be seen of it in a view.
  void AddMarks(const View& view, std::vector<render::Mark>* marks) const;

  /// Whether the face in hand of the newest state is still to be looked at.
  bool busy() const { return !UpToDate(); }
  const WakeFd& ready() const { return worker_.ready(); }

 private:
  using State = std::shared_ptr<const SessionState>;
  struct Found {
    State state;
    std::shared_ptr<const PlacedLayers> placed;
  };
  /// Keeps the rules that it read last.
  class Finder {
   public:
    Found operator()(const State& state);

   private:
    std::shared_ptr<const RuleSource> source_;
    std::shared_ptr<const grammar::RuleSet> rules_;
  };

  bool UpToDate() const { return found_.state == state_; }
  /// What there is to see and to take; null: nothing.
  const std::shared_ptr<const PlacedLayers>& placed() const {
    return wanted_ ? wanted_ : found_.placed;
  }
  /// From now on until the model is so.
  void Want(const PlacedLayers& before, size_t layer, const grammar::InteractiveLayer& now);
  void SeeWhetherDone();
  PlacingStep Begin(const DragAct& drag, const View& view, double scale);
  PlacingStep End(const DragAct& drag, const View& view);

  State state_;
  uint64_t executed_ = 0;
  Found found_;                                 // of the newest state that has been looked at
  std::optional<LayerDrag> drag_;               // that goes on
  std::shared_ptr<const PlacedLayers> wanted_;  // as commands that are on their way place them
  uint64_t posted_ = 0;  // the last of those; none yet of its number: UINT64_MAX
  HeldElement held_;
  std::optional<int> device_;  // whose drag is taken
  std::optional<LayerGrip> meant_;
  LatestWorker<State, Found> worker_{Finder()};
};

}  // namespace parti::app
