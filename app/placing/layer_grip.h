// Where a pen takes hold of an element placed by hand: from pixels to its handles, and from pixels
// to metres on its face. What pulling does is grammar/layers/layer_handle.h's.
#pragma once

#include <array>
#include <optional>

#include "app/placing/element_in_hand.h"
#include "app/placing/placed_layers.h"
#include "base/camera.h"
#include "grammar/layers/layer_handle.h"

namespace parti::app {

/// A handle of one of the layers.
struct LayerGrip {
  size_t layer = 0;  ///< of PlacedLayers::layers
  grammar::LayerHandle handle;
  bool operator==(const LayerGrip&) const = default;
};

/// A rectangle's handles but for the whole: corners, then edges, counter-clockwise from the lower
/// left corner and the lower edge.
inline constexpr std::array<grammar::LayerHandle, 8> kLayerHandles = {
    {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};

/// Where a handle is in the frame's x and y: a corner, the middle of an edge, the middle; m.
Vec2 PlaceOf(const grammar::InteractiveLayer& layer, grammar::LayerHandle handle);

/// A rectangle in a frame with its handles as they are seen; those behind the eye are left out.
SeenElement SeenAs(const grammar::Scope& frame, const grammar::InteractiveLayer& layer,
                   const View& view);

/// The point of the frame's plane at a pixel, in its x and y; m. Nothing where the plane is seen
/// from the side, or lies behind the eye. Property: (1) the inverse of projecting.
std::optional<Vec2> OnFrame(const grammar::Scope& frame, const View& view, const Vec2& px);

/// What a pen at a pixel takes hold of: a corner within reach, else an edge, else what the pixel
/// lies in. The nearest counts; of what is equally near or lies in each other, the uppermost.
/// Within a small rectangle the reach is a quarter of its shorter side, so that it can be moved.
/// reach_px  how near a handle is meant, [0, 100].
/// returns   nothing also where the face is seen from behind.
/// cost      linear in the layers.
std::optional<LayerGrip> GripAt(const PlacedLayers& placed, const View& view, const Vec2& px,
                                double reach_px);

}  // namespace parti::app
