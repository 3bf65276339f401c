// One drag of an element that is placed by hand: from taking hold of it to the command that says
// where it is now (Jesus 2018, 8.2.1). It follows the pen and derives nothing.
// What takes hold is layer_grip.h's; how it looks is layer_marks.h's; whose drag it is,
// placing.h's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/placing/layer_grip.h"
#include "grammar/layers/layer_snap.h"

namespace parti::app {

/// The numbers of placing by hand.
struct LayerDragParams {
  double reach_px = 10;  ///< how near a handle is meant, at scale 1, [2, 40]
  double still_px = 4;   ///< a pen that stays within this only taps, at scale 1, [1, 30]
  double snap_px = 6;    ///< how near others draw an element to them, at scale 1, [0, 40]
  double step_m = 0.01;  ///< what a hand does is in whole steps: no pixel is finer, [0.001, 1]
};

/// A value.
class LayerDrag {
 public:
  /// Nothing where there is nothing at that pixel to take hold of. scale: of the display.
  static std::optional<LayerDrag> Begin(std::shared_ptr<const PlacedLayers> placed,
                                        const View& view, const Vec2& px, double scale,
                                        const LayerDragParams& params = {});

  /// The pen is there now. Elements follow as far as the face goes, and snap to others on it, to
  /// the face itself, and, once the pen has been farther away than that, to where they were. A
  /// pixel that meets no point of the face changes nothing.
  void MoveTo(const View& view, const Vec2& px);

  const PlacedLayers& placed() const { return *placed_; }
  const LayerGrip& grip() const { return grip_; }
  /// Whether the pen has left the place where it took hold: else it may only have tapped.
  bool moved() const { return moved_; }
  /// A layer as the text will have it: the one that is held, and what shares numbers with it.
  grammar::InteractiveLayer LayerNow(size_t layer) const;
  /// How its numbers stand now: "4.00 m from the left, 0.50 m up", of an edge or a corner "1.50 m
  /// wide, 2.50 m high".
  std::string Figures() const;
  /// What it lies in line with now, among others().
  const grammar::SnappedLayer& snapped() const { return now_; }
  /// What it may snap to: the other layers in its frame, the face, and last where it was.
  const std::vector<grammar::InteractiveLayer>& others() const { return others_; }

  /// The command that places it here; nothing where it is as it was, to the millimetre.
  std::optional<PlaceElement> Outcome() const;

 private:
  LayerDrag(std::shared_ptr<const PlacedLayers> placed, const LayerGrip& grip);
  const PlacedLayer& held() const { return placed_->layers[grip_.layer]; }

  std::shared_ptr<const PlacedLayers> placed_;
  LayerGrip grip_;
  std::vector<grammar::InteractiveLayer> others_;
  LayerDragParams params_;  // at the display's scale
  Vec2 from_px_{0, 0};
  Vec2 from_{0, 0};  // in the frame; m
  bool moved_ = false;
  bool been_away_ = false;  // farther from where it was than that draws
  grammar::SnappedLayer now_;
};

}  // namespace parti::app
