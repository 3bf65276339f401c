// The layers of a scene merged: what of each shape is left when those over it are taken away
// (Jesus 2018, 4.3.1; errata 2, 5). Regions in one plane; knows nothing of shape trees.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/layers/region.h"

namespace parti::grammar {

/// A shape of a scene, clipped to what it lies in (4.17). Placeholders are none.
struct SceneShape {
  Region region;
  bool fixed = true;   ///< covered by area: discarded, not cut
  uint16_t layer = 0;  ///< a later one lies over an earlier one
  int32_t depth = 0;   ///< in a layer a smaller one lies over a larger one
};

/// Disjoint regions that fill the background.
struct MergedLayers {
  std::vector<Region> visible;     ///< of each shape, in the given order; empty: discarded
  std::vector<Polygon> uncovered;  ///< what is left of the background
};

/// Occlusion from the top down (4.18). Of shapes with the same layer and depth, the later in the
/// list lies on top.
/// errors  those of Shared.
/// cost    O(n log n) and the pairs that overlap; about 10 us a shape.
Result<MergedLayers> MergeLayers(const Region& background, std::span<const SceneShape> shapes,
                                 const Negligible& negligible);

}  // namespace parti::grammar
