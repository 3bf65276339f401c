#include "grammar/layers/interactive_layer.h"

#include <algorithm>
#include <utility>

namespace parti::grammar {

InteractiveLayer Drag(InteractiveLayer layer, double up_m, double right_m) {
  layer.bottom = std::max(0.0, layer.bottom + up_m);
  layer.left = std::max(0.0, layer.left + right_m);
  return layer;
}

InteractiveLayer Resize(InteractiveLayer layer, double width_m, double height_m) {
  layer.width = std::max(kLeastLayerSize_m, layer.width + width_m);
  layer.height = std::max(kLeastLayerSize_m, layer.height + height_m);
  return layer;
}

InteractiveLayer SameSize(const InteractiveLayer& like, InteractiveLayer layer) {
  layer.width = like.width;
  layer.height = like.height;
  return layer;
}

InteractiveLayer Align(const InteractiveLayer& to, InteractiveLayer layer, LayerEdge edge) {
  switch (edge) {
    case LayerEdge::kTop:
      return Drag(layer, to.bottom + to.height - layer.bottom - layer.height, 0);
    case LayerEdge::kBottom:
      return Drag(layer, to.bottom - layer.bottom, 0);
    case LayerEdge::kLeft:
      return Drag(layer, 0, to.left - layer.left);
    case LayerEdge::kRight:
      return Drag(layer, 0, to.left + to.width - layer.left - layer.width);
  }
  return layer;
}

InteractiveLayer Center(const InteractiveLayer& to, InteractiveLayer layer, LayerAxis axis) {
  const double right = to.left + to.width / 2 - layer.left - layer.width / 2;
  const double up = to.bottom + to.height / 2 - layer.bottom - layer.height / 2;
  return axis == LayerAxis::kHorizontal ? Drag(std::move(layer), 0, right)
                                        : Drag(std::move(layer), up, 0);
}

}  // namespace parti::grammar
