#include "app/placing/layer_arranging.h"

#include <cmath>

namespace parti::app {
namespace {

using grammar::InteractiveLayer;
using grammar::LayerAxis;
using grammar::LayerEdge;

constexpr double kSameFrame_m = 1e-9;

bool SameFrame(const grammar::Scope& a, const grammar::Scope& b) {
  return glm::distance(a.origin, b.origin) <= kSameFrame_m &&
         glm::distance(a.size, b.size) <= kSameFrame_m;
}

/// Whether changing the one changes the other, too.
bool ShareNumbers(const grammar::InteractiveRules& a, const grammar::InteractiveRules& b) {
  for (const auto& mine : {a.bottom, a.left, a.width, a.height}) {
    for (const auto& theirs : {b.bottom, b.left, b.width, b.height}) {
      if (mine.file == theirs.file && mine.from == theirs.from) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<InteractiveLayer> LayersBeside(const PlacedLayers& placed, size_t layer) {
  const PlacedLayer& mine = placed.layers[layer];
  std::vector<InteractiveLayer> beside;
  for (const PlacedLayer& other : placed.layers) {
    if (SameFrame(other.frame, mine.frame) && !ShareNumbers(other.rules, mine.rules)) {
      beside.push_back(other.rules.layer);
    }
  }
  beside.push_back({"", "", 0, 0, mine.frame.size.x, mine.frame.size.y});
  return beside;
}

InteractiveLayer Arranged(const InteractiveLayer& layer, ElementCommand how,
                          const InteractiveLayer& by) {
  switch (how) {
    case ElementCommand::kSameSize:
      return SameSize(by, layer);
    case ElementCommand::kAlignLeft:
      return Align(by, layer, LayerEdge::kLeft);
    case ElementCommand::kCenterAcross:
      return Center(by, layer, LayerAxis::kHorizontal);
    case ElementCommand::kAlignRight:
      return Align(by, layer, LayerEdge::kRight);
    case ElementCommand::kAlignTop:
      return Align(by, layer, LayerEdge::kTop);
    case ElementCommand::kCenterUp:
      return Center(by, layer, LayerAxis::kVertical);
    case ElementCommand::kAlignBottom:
      return Align(by, layer, LayerEdge::kBottom);
    case ElementCommand::kByNext:
    case ElementCommand::kLetGo:
      break;
  }
  return layer;
}

std::optional<PlaceElement> ChangeBetween(const InteractiveLayer& before,
                                          const InteractiveLayer& after) {
  PlaceElement change{before.name};
  bool any = false;
  const auto add = [&](double from, double to, std::optional<double>* number) {
    const double from_mm = std::round(from * 1000), to_mm = std::round(to * 1000);
    if (from_mm == to_mm) return;
    *number = to_mm / 1000;
    any = true;
  };
  add(before.left, after.left, &change.left);
  add(before.bottom, after.bottom, &change.bottom);
  add(before.width, after.width, &change.width);
  add(before.height, after.height, &change.height);
  return any ? std::optional(std::move(change)) : std::nullopt;
}

std::array<bool, kArrangements> ChangesOf(const PlacedLayers& placed, size_t layer,
                                          const InteractiveLayer& by) {
  std::array<bool, kArrangements> changes{};
  const InteractiveLayer& now = placed.layers[layer].rules.layer;
  for (size_t i = 0; i < kArrangements; ++i) {
    const InteractiveLayer then = Arranged(now, static_cast<ElementCommand>(i), by);
    changes[i] = ChangeBetween(now, then).has_value();
  }
  return changes;
}

}  // namespace parti::app
