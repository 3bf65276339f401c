// Which strokes are to be seen as ink: those that the session has not read yet, those of the
// sketch, and what is left out while the eraser goes over it. Ink is on the screen from the first
// sample on, whatever the session does; a stroke never flickers when the session takes it over.
// Not responsible for the stroke being drawn (render/canvas.h) or for its looks (ink_style.h).
#pragma once

#include <cstdint>
#include <memory>
#include <set>
#include <vector>

#include "app/session_state.h"
#include "render/ink_strokes.h"

namespace parti::app {

/// A value with its ids: each stroke keeps the id that it was drawn with, so that a canvas knows it
/// again.
class InkBook {
 public:
  /// A fresh id for a stroke that begins.
  uint64_t NewId() { return ++last_id_; }

  /// A stroke is done and has been posted as request `request`.
  void Posted(uint64_t id, uint64_t request, const Stroke& stroke);

  /// All ink to show, in the order drawn, for a session that has executed requests up to
  /// `executed`: what was posted since, and the sketch's strokes that were drawn in the view of
  /// `now`. What was executed and is not in the sketch any more is forgotten. O(strokes), without
  /// looking at the samples of those that were there the last time.
  std::vector<render::InkStroke> Shown(const SessionState& state, const Camera& now,
                                       uint64_t executed);

  /// The numbers of the sketch's strokes that come within `radius_px` of the segment a-b and were
  /// drawn in the view of `now`. O(samples of the sketch).
  static std::vector<uint32_t> Touched(const SessionState& state, const Camera& now, const Vec2& a,
                                       const Vec2& b, double radius_px);

  /// Strokes that are not shown, by number: the eraser has gone over them. Kept until Unhide.
  void Hide(const std::vector<uint32_t>& numbers) {
    hidden_.insert(numbers.begin(), numbers.end());
  }
  void Unhide() { hidden_.clear(); }
  const std::set<uint32_t>& hidden() const { return hidden_; }

 private:
  struct Waiting {
    uint64_t request = 0;
    Stroke stroke;
    render::InkStroke ink;
  };
  struct Read {
    std::shared_ptr<const DrawnStroke> drawn;
    render::InkStroke ink;
  };
  /// The ink of a stroke that is in the sketch for the first time.
  render::InkStroke InkOfNew(const DrawnStroke& drawn);

  uint64_t last_id_ = 0;
  std::vector<Waiting> waiting_;  // not executed yet, in order
  std::vector<Read> read_;        // of the sketch, in the order drawn
  std::set<uint32_t> hidden_;
};

}  // namespace parti::app
