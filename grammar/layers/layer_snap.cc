#include "grammar/layers/layer_snap.h"

#include <cmath>

namespace parti::grammar {
namespace {

constexpr double kSame_m = 1e-9;  ///< lines and sizes this near are one

/// One axis of an element.
struct Extent {
  double low = 0, size = 0;
  double middle() const { return low + size / 2; }
  double high() const { return low + size; }
};

Extent ExtentOf(const InteractiveLayer& layer, LayerAxis axis) {
  return axis == LayerAxis::kHorizontal ? Extent{layer.left, layer.width}
                                        : Extent{layer.bottom, layer.height};
}

/// The nearest so far.
struct Best {
  double off_m = 0;  ///< how far it is away
  InteractiveLayer layer;
  std::optional<LayerSnap> snap;

  void Consider(const InteractiveLayer& layer_then, const LayerSnap& how, double off) {
    const bool nearer = snap ? std::abs(off) < off_m : std::abs(off) <= off_m;
    if (!nearer) return;
    off_m = std::abs(off);
    layer = layer_then;
    snap = how;
  }
};

/// The nearest of what one axis of an element could snap to.
class AxisSnap {
 public:
  AxisSnap(const InteractiveLayer& pulled, int held, LayerAxis axis, double reach_m)
      : pulled_(pulled), held_(held), axis_(axis), best_{reach_m, pulled, std::nullopt} {}

  void ConsiderMoving(const InteractiveLayer& other, size_t like) {
    const bool across = axis_ == LayerAxis::kHorizontal;
    const Extent mine = ExtentOf(pulled_, axis_), theirs = ExtentOf(other, axis_);
    const LayerEdge low = across ? LayerEdge::kLeft : LayerEdge::kBottom;
    const LayerEdge high = across ? LayerEdge::kRight : LayerEdge::kTop;
    ConsiderAt(Align(other, pulled_, low), theirs.low - mine.low,
               {LayerSnap::Kind::kEdge, like, theirs.low});
    ConsiderAt(Align(other, pulled_, high), theirs.high() - mine.high(),
               {LayerSnap::Kind::kEdge, like, theirs.high()});
    ConsiderAt(Center(other, pulled_, axis_), theirs.middle() - mine.middle(),
               {LayerSnap::Kind::kCenter, like, theirs.middle()});
  }

  void ConsiderResizing(const InteractiveLayer& other, size_t like) {
    const Extent mine = ExtentOf(pulled_, axis_), theirs = ExtentOf(other, axis_);
    const double edge = held_ < 0 ? theirs.low : theirs.high();
    const double to_edge = edge - (held_ < 0 ? mine.low : mine.high());
    ConsiderAt(PulledBy(to_edge), to_edge, {LayerSnap::Kind::kEdge, like, edge});
    const double to_size = held_ * (ExtentOf(SameSize(other, pulled_), axis_).size - mine.size);
    ConsiderAt(PulledBy(to_size), to_size, {LayerSnap::Kind::kSize, like, 0});
  }

  const Best& best() const { return best_; }

 private:
  InteractiveLayer PulledBy(double by_m) const {
    return axis_ == LayerAxis::kHorizontal ? Pulled(pulled_, {held_, 0}, 0, by_m)
                                           : Pulled(pulled_, {0, held_}, by_m, 0);
  }

  /// Only where the borders let it come so far.
  void ConsiderAt(const InteractiveLayer& there, double off, const LayerSnap& how) {
    const Extent from = ExtentOf(pulled_, axis_), to = ExtentOf(there, axis_);
    const double went = held_ > 0 ? to.size - from.size : to.low - from.low;
    if (std::abs(went - off) <= kSame_m) best_.Consider(there, how, off);
  }

  const InteractiveLayer& pulled_;
  int held_;
  LayerAxis axis_;
  Best best_;
};

Best SnappedAlong(const InteractiveLayer& pulled, LayerHandle handle, LayerAxis axis,
                  std::span<const InteractiveLayer> others, double reach_m) {
  const int held = axis == LayerAxis::kHorizontal ? handle.across : handle.up;
  AxisSnap snap(pulled, held, axis, reach_m);
  for (size_t i = 0; i < others.size(); ++i) {
    if (handle.whole()) {
      snap.ConsiderMoving(others[i], i);
    } else if (held != 0) {
      snap.ConsiderResizing(others[i], i);
    }
  }
  return snap.best();
}

}  // namespace

SnappedLayer Snapped(const InteractiveLayer& pulled, LayerHandle handle,
                     std::span<const InteractiveLayer> others, double reach_m) {
  const Best across = SnappedAlong(pulled, handle, LayerAxis::kHorizontal, others, reach_m);
  const Best up = SnappedAlong(across.layer, handle, LayerAxis::kVertical, others, reach_m);
  return {up.layer, across.snap, up.snap};
}

}  // namespace parti::grammar
