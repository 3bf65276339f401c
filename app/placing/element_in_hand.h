// The element that a hand placed last, and what can be done with it by a button: values between
// placing and panels.
// What the buttons do is layer_arranging.h's; where they are is panels/element_bar.h's.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/math.h"
#include "grammar/layers/interactive_layer.h"

namespace parti::app {

/// Jesus 2018, 8.2.1: same size, align (an edge) and center (an axis), by another element; and
/// which one that is.
enum class ElementCommand : uint8_t {
  kSameSize,
  kAlignLeft,
  kCenterAcross,
  kAlignRight,
  kAlignTop,
  kCenterUp,
  kAlignBottom,
  kByNext,  ///< arrange it by the next of those that there are
  kLetGo,   ///< have none in hand
};
/// Those that change the element come first.
inline constexpr size_t kArrangements = 7;

/// A value.
struct ElementInHand {
  grammar::InteractiveLayer layer;            ///< as it is seen
  std::string by;                             ///< what it is arranged by; "" the whole face
  bool by_others = false;                     ///< there is more than one to choose from
  std::array<bool, kArrangements> changes{};  ///< which of ElementCommand would change it now
  Vec2 low_px{0, 0}, high_px{0, 0};           ///< around it in the view
  bool operator==(const ElementInHand&) const = default;
};

/// An element's handles in the view, for what must not lie on them.
struct SeenElement {
  Vec2 low_px{0, 0}, high_px{0, 0};  ///< around it
  std::vector<Vec2> handles_px;
  bool operator==(const SeenElement&) const = default;
};

}  // namespace parti::app
