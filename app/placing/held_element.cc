#include "app/placing/held_element.h"

#include <algorithm>

#include "app/placing/layer_arranging.h"

namespace parti::app {
namespace {

using grammar::InteractiveLayer;

/// Where a name is among them; their number where it is not.
size_t Find(const std::vector<InteractiveLayer>& layers, const std::string& name) {
  const auto found = std::find_if(layers.begin(), layers.end(),
                                  [&](const InteractiveLayer& one) { return one.name == name; });
  return static_cast<size_t>(found - layers.begin());
}

}  // namespace

void HeldElement::Hold(const PlacedLayers& placed, size_t layer) {
  const std::string& name = placed.layers[layer].rules.layer.name;
  const auto same = [&](const PlacedLayer& one) { return one.rules.layer.name == name; };
  const auto end = placed.layers.begin() + static_cast<std::ptrdiff_t>(layer);
  nth_ = static_cast<size_t>(std::count_if(placed.layers.begin(), end, same));
  if (name == name_) return;
  const std::vector<InteractiveLayer> beside = LayersBeside(placed, layer);
  const bool lies_beside = !name_.empty() && Find(beside, name_) < beside.size();
  by_ = lies_beside ? name_ : beside.front().name;
  name_ = name;
}

void HeldElement::TakeNext(const PlacedLayers& placed) {
  const auto layer = In(placed);
  if (!layer) return;
  const std::vector<InteractiveLayer> beside = LayersBeside(placed, *layer);
  by_ = beside[(Find(beside, by_) + 1) % beside.size()].name;
}

std::optional<size_t> HeldElement::In(const PlacedLayers& placed) const {
  if (name_.empty()) return std::nullopt;
  size_t nth = 0;
  for (size_t i = 0; i < placed.layers.size(); ++i) {
    if (placed.layers[i].rules.layer.name == name_ && nth++ == nth_) return i;
  }
  return std::nullopt;
}

InteractiveLayer HeldElement::ByIn(const PlacedLayers& placed) const {
  const std::vector<InteractiveLayer> beside = LayersBeside(placed, *In(placed));
  return beside[std::min(Find(beside, by_), beside.size() - 1)];
}

}  // namespace parti::app
