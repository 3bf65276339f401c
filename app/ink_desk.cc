#include "app/ink_desk.h"

#include <algorithm>

#include "app/scene_from_model.h"

namespace parti::app {

using input::DragPhase;

std::optional<Vec2> InkDesk::Draw(const DragAct& drag, double scale) {
  switch (drag.phase) {
    case DragPhase::kBegin:
      id_ = book_.NewId();
      stroke_.clear();
      predictor_.Begin();
      canvas_->BeginStroke(id_, DrawingStyle().ink);
      Add(drag);
      return std::nullopt;
    case DragPhase::kMove:
      Add(drag);
      return std::nullopt;
    case DragPhase::kEnd:
      return EndStroke(drag, scale);
    case DragPhase::kCancel:
      stroke_.clear();
      canvas_->CancelStroke();
      return std::nullopt;
  }
  return std::nullopt;
}

void InkDesk::Add(const DragAct& drag) {
  const double t_s = stroke_.empty() ? drag.t_s : std::max(drag.t_s, stroke_.back().t_s);
  stroke_.push_back({drag.px, t_s, drag.pressure});
  const render::Vec2f point(drag.px);
  const float width_px = InkWidth_px(drag.pressure);
  canvas_->AddSamples({&point, 1}, {&width_px, 1});
  predictor_.Add(drag.px / drag.px_per_mm, t_s);
  if (const auto ahead_mm = predictor_.Predict(params_.ahead_s)) {
    const render::Vec2f ahead(*ahead_mm * drag.px_per_mm);
    canvas_->SetPrediction({&ahead, 1}, {&width_px, 1});
  }
}

std::optional<Vec2> InkDesk::EndStroke(const DragAct& drag, double scale) {
  // The position at which the tip has left the surface is no sample (see StrokesFromEvents).
  Stroke stroke = std::move(stroke_);
  stroke_.clear();
  if (stroke.empty()) return std::nullopt;
  const bool is_tap =
      Diagonal(stroke) <= params_.tap_px * scale && drag.t_s - stroke.front().t_s <= params_.tap_s;
  if (is_tap) {
    canvas_->CancelStroke();
    return stroke.front().position;
  }
  canvas_->EndStroke();
  last_request_ = post_(stroke);
  book_.Posted(id_, last_request_, stroke);
  return std::nullopt;
}

void InkDesk::Erase(const DragAct& drag, double scale, const SessionState& state,
                    const Camera& camera) {
  if (drag.phase == DragPhase::kBegin) erased_to_px_ = drag.px;
  if (drag.phase == DragPhase::kCancel) {
    book_.Unhide();
  } else {
    book_.Hide(InkBook::Touched(state, camera, erased_to_px_, drag.px, params_.eraser_px * scale));
    erased_to_px_ = drag.px;
  }
  if (drag.phase == DragPhase::kEnd && !book_.hidden().empty()) {
    last_request_ = erase_request_ =
        post_(app::Erase{{book_.hidden().begin(), book_.hidden().end()}});
  }
  canvas_->SetStrokes(book_.Shown(state, camera, executed_));
}

void InkDesk::Show(const SessionSnapshot& snapshot, const Camera& camera) {
  executed_ = snapshot.executed;
  if (erase_request_ && executed_ >= erase_request_) {
    book_.Unhide();
    erase_request_ = 0;
  }
  canvas_->SetStrokes(book_.Shown(*snapshot.state, camera, executed_));
}

}  // namespace parti::app
