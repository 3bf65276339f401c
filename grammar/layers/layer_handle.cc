#include "grammar/layers/layer_handle.h"

#include <algorithm>

namespace parti::grammar {
namespace {

/// How far a left or lower edge may go: to the border, and until the least size is left.
double Stopped(double by_m, double before_m, double extent_m) {
  const double most = std::max(0.0, extent_m - kLeastLayerSize_m);
  return std::min(std::max(by_m, -std::max(0.0, before_m)), most);
}

}  // namespace

InteractiveLayer Pulled(const InteractiveLayer& layer, LayerHandle handle, double up_m,
                        double right_m) {
  if (handle.whole()) return Drag(layer, up_m, right_m);
  InteractiveLayer pulled = layer;
  if (handle.across < 0) {
    const double by = Stopped(right_m, layer.left, layer.width);
    pulled = Resize(Drag(pulled, 0, by), -by, 0);
  } else if (handle.across > 0) {
    pulled = Resize(pulled, right_m, 0);
  }
  if (handle.up < 0) {
    const double by = Stopped(up_m, layer.bottom, layer.height);
    pulled = Resize(Drag(pulled, by, 0), 0, -by);
  } else if (handle.up > 0) {
    pulled = Resize(pulled, 0, up_m);
  }
  return pulled;
}

}  // namespace parti::grammar
