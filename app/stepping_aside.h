// Which sheets of the panels step aside for a pen that draws, and how far they have: sheets, a pen
// and a time in, opacities out. The pen never waits for it, and no panel is made anew.
// Not responsible for drawing (Canvas::SetPanelOpacities) or for what panels take (application.h).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/panels/panel_output.h"

namespace parti::app {

/// The numbers of stepping aside. Chosen by looking.
struct SteppingAsideParams {
  double fade_s = 0.12;  ///< from being there to being gone, and back; 0: at once, [0, 1]
  int levels = 6;        ///< of opacity on the way, a frame each, [1, 60]
  double slack_px = 6;   ///< a pen that stays within this only taps: nothing moves for it, [0, 30]
};

/// Properties  (1) opacities are 1 where no pen has come near since it was put down, and at the end
///                 0 where one has; (2) what has stepped aside stays there until the pen is lifted;
///             (3) at the end after lifting all are 1; (4) Step changes something at most `levels`
///                 times for each sheet that goes or comes.
class SteppingAside {
 public:
  explicit SteppingAside(const SteppingAsideParams& params = {}) : params_(params) {}

  /// What lies on the drawing from now on. A sheet of a name that was there stays as far aside.
  void SetSheets(const std::vector<PanelSheet>& sheets);
  /// A pen draws here, at a time that never goes back; sheets nearer than reach_px go. O(sheets),
  /// no allocation. scale: view pixels for a pixel of slack_px.
  void PenAt(const Vec2& px, double reach_px, double scale, double now_s);
  /// All that has gone comes back.
  void PenLifted(double now_s);
  /// Brings opacities up to a time; whether they are others than before.
  bool Step(double now_s);

  /// Of the sheets, in their order, in [0, 1].
  std::span<const float> opacities() const { return opacities_; }
  /// When Step has something to do; nothing where all has come to rest.
  std::optional<double> next_s() const;
  /// Whether a sheet is there for whoever taps at a pixel: none that steps aside, or has.
  bool IsOverSheet(const Vec2& px) const;

 private:
  struct Place {
    PanelSheet sheet;
    bool aside = false;
    int level = 0;       // of the way gone or come, in params_.levels
    double since_s = 0;  // when it was at level 0, or would have been
  };
  void Turn(Place* place, double now_s) const;
  float OpacityOf(const Place& place) const;
  double Step_s() const { return params_.fade_s / params_.levels; }
  double NextOf(const Place& place) const { return place.since_s + Step_s() * (place.level + 1); }

  SteppingAsideParams params_;
  std::vector<Place> places_;
  std::vector<float> opacities_;
  std::optional<Vec2> down_px_;  // where the pen was put down
  bool draws_ = false;           // and has left that place
};

}  // namespace parti::app
