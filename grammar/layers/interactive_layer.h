// Elements of a façade that are placed and sized by hand, each in a layer of its own (Jesus 2018,
// 8.2.1): what dragging, resizing and arranging do to their four numbers.
// How the numbers stand in rules is interactive_rules.h's.
#pragma once

#include <cstdint>
#include <string>

namespace parti::grammar {

/// Equation 8.1's l: the rule `name` places the symbol `payload` in a planar shape; m from its
/// lower left corner.
struct InteractiveLayer {
  std::string name;
  std::string payload;
  double bottom = 0;
  double left = 0;
  double width = 1;
  double height = 1;
  bool operator==(const InteractiveLayer&) const = default;
};

/// Sides of an element.
enum class LayerEdge : uint8_t { kTop, kBottom, kLeft, kRight };
/// Across or up.
enum class LayerAxis : uint8_t { kHorizontal, kVertical };

/// Sizes don't get smaller.
inline constexpr double kLeastLayerSize_m = 0.01;

/// Moved (8.2). Elements stop at the planar shape's left and lower border: segment knows no
/// negative sizes. Beyond the others they are clipped.
InteractiveLayer Drag(InteractiveLayer layer, double up_m, double right_m);
/// Grown, or shrunk where negative (8.3); the lower left corner stays.
InteractiveLayer Resize(InteractiveLayer layer, double width_m, double height_m);
/// `layer` with the size of `like`.
InteractiveLayer SameSize(const InteractiveLayer& like, InteractiveLayer layer);
/// `layer` moved so that its edge lies where `to`'s does (as far as Drag lets it).
InteractiveLayer Align(const InteractiveLayer& to, InteractiveLayer layer, LayerEdge edge);
/// `layer` moved so that its middle lies where `to`'s does (as far as Drag lets it).
InteractiveLayer Center(const InteractiveLayer& to, InteractiveLayer layer, LayerAxis axis);

}  // namespace parti::grammar
