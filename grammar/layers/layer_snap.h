// How an element that is being placed by hand falls in with others: on their edges, their middles
// and their sizes, by same_size, align and center of Jesus 2018, 8.2.1.
// What the hand does to it before is layer_handle.h's; lines that show it are app/placing's.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "grammar/layers/layer_handle.h"

namespace parti::grammar {

/// What an element has in common with another in one axis.
struct LayerSnap {
  enum class Kind : uint8_t {
    kEdge,    ///< an edge lies where the same edge of the other does
    kCenter,  ///< so do their middles
    kSize,    ///< they are as wide, or as high
  };
  Kind kind = Kind::kEdge;
  size_t like = 0;  ///< which of the others
  double at_m = 0;  ///< kEdge, kCenter: of the line that they share, from the left or from below
  bool operator==(const LayerSnap&) const = default;
};

/// An element and what it snapped to.
struct SnappedLayer {
  InteractiveLayer layer;
  std::optional<LayerSnap> across, up;
};

/// An element that was pulled by a handle, moved on to what is nearest within reach in each axis:
/// as a whole to the same edge or the middle of another; by an edge so that this edge, or the size,
/// is as another's. What the borders don't allow is left out. Of what is equally near, the first of
/// the others counts, and of that edges before middles before sizes.
/// pulled   as Pulled made it; in the frame of the others.
/// reach_m  >= 0; 0 snaps only to what is there already.
/// cost     linear in the others.
/// Property: (1) the layer is pulled's, moved or resized by at most reach_m in each axis.
SnappedLayer Snapped(const InteractiveLayer& pulled, LayerHandle handle,
                     std::span<const InteractiveLayer> others, double reach_m);

}  // namespace parti::grammar
