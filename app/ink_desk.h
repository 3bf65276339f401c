// Drawing and erasing on the canvas: what a pen's drags of kDraw and kErase do between the tip's
// coming down and the session's taking over. Samples are on the canvas the moment they come.
// Not responsible for what strokes mean (session.h) or for who may draw (hands.h).
#pragma once

#include <functional>
#include <optional>

#include "app/hands.h"
#include "app/ink_book.h"
#include "app/session_snapshot.h"
#include "input/stroke_predictor.h"
#include "render/canvas.h"

namespace parti::app {

/// The numbers of drawing and erasing on the screen.
struct InkDeskParams {
  double tap_px = 6;       ///< a pen that stays within this only taps, at scale 1, [1, 30]
  double tap_s = 0.35;     ///< and lifts again within this, [0.1, 1]
  double ahead_s = 0.012;  ///< how far ahead ink is drawn: about a frame, [0, 0.03]
  double eraser_px = 10;   ///< radius of the eraser, at scale 1, [2, 60]
};

/// Posts to the session; gives the request's number.
using PostRequest = std::function<uint64_t(SessionRequest)>;

/// Used by the thread that draws, with the canvas's context current.
class InkDesk {
 public:
  /// `canvas` must outlive it.
  InkDesk(render::Canvas* canvas, PostRequest post, const InkDeskParams& params = {})
      : canvas_(canvas), post_(std::move(post)), params_(params) {}

  /// One drag of act kDraw. The stroke is posted when it ends; where it was only a tap, nothing is,
  /// and its place is returned.
  std::optional<Vec2> Draw(const DragAct& drag, double scale);
  /// One drag of act kErase over the sketch of a state.
  void Erase(const DragAct& drag, double scale, const SessionState& state, const Camera& camera);

  /// Shows the ink of a snapshot in a view; what has been posted since stays.
  void Show(const SessionSnapshot& snapshot, const Camera& camera);

  bool drawing() const { return !stroke_.empty(); }
  /// Posted, and not executed in the newest snapshot shown.
  bool waiting() const { return last_request_ > executed_; }

 private:
  void Add(const DragAct& drag);
  std::optional<Vec2> EndStroke(const DragAct& drag, double scale);

  render::Canvas* canvas_;
  PostRequest post_;
  InkDeskParams params_;
  InkBook book_;
  Stroke stroke_;  // being drawn
  uint64_t id_ = 0;
  input::StrokePredictor predictor_;
  Vec2 erased_to_px_{0, 0};
  uint64_t erase_request_ = 0;
  uint64_t last_request_ = 0, executed_ = 0;
};

}  // namespace parti::app
