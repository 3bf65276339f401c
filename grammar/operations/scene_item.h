// 2D shapes as segment and vectorial lay them out in a scene.
// What the scene makes of them in the end is layers/normalise.h.
#pragma once

#include "grammar/item.h"

namespace parti::grammar {

constexpr ItemTypes kSceneItemTypes =
    Types(ItemType::kPlanar, ItemType::kLayer, ItemType::kShape2D);

/// A 2D shape in the rectangle [low, low + size] of its predecessor's scope: in the same layer (the
/// scene's only one where that is a planar shape), one step over it, with its color and its fixed
/// geometry (4.2.3; errata 2, 6).
Item SceneItem(const Item& predecessor, const Vec2& low, const Vec2& size);

}  // namespace parti::grammar
