#include "app/placing/layer_arranging.h"

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

std::optional<grammar::RuleFile> FileWith(const PlacedLayers& placed, size_t layer,
                                          const InteractiveLayer& now) {
  const grammar::InteractiveRules& rules = placed.layers[layer].rules;
  const grammar::RuleFile& file = placed.rules->files[rules.left.file];
  std::string text = grammar::TextWith(*placed.rules, rules, now);
  if (text == file.text) return std::nullopt;
  return grammar::RuleFile{file.name, std::move(text)};
}

std::array<bool, kArrangements> ChangesOf(const PlacedLayers& placed, size_t layer,
                                          const InteractiveLayer& by) {
  std::array<bool, kArrangements> changes{};
  for (size_t i = 0; i < kArrangements; ++i) {
    const InteractiveLayer& now = placed.layers[layer].rules.layer;
    changes[i] =
        FileWith(placed, layer, Arranged(now, static_cast<ElementCommand>(i), by)).has_value();
  }
  return changes;
}

}  // namespace parti::app
