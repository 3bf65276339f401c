// How far an image runs over a shape: what geometry.uMin and tileUV ask for.
// The maps themselves are material.h's.
#pragma once

#include <array>
#include <string_view>

#include "grammar/item.h"
#include "grammar/material.h"
#include "grammar/operation.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// The words of a size's parameter that may float: "~2" fits a whole number of times.
inline constexpr std::array<std::string_view, 1> kFloatingToo = {"~"};

/// Whether the parameter's size may float.
constexpr bool TakesFloating(const Parameter& parameter) {
  return !parameter.words.empty() && parameter.words[0] == kFloatingToo[0];
}

/// The item's texture coordinates; where it has none a metre an image, along the scope's x and y
/// from its origin.
TextureMap TextureMapOf(const Item& item);

/// The least and largest coordinates over the corners of its edges; of a shape without edges 0.
Box2 TextureExtent(const Item& item, const TextureMap& map);

}  // namespace parti::grammar
