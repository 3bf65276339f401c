// An annotated façade as a layered grammar: a layer for each label, a rule for each kind of
// element.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tests/facades/annotated_facade.h"

namespace parti::tests {

/// What becomes of a label.
struct LabelLayer {
  std::string_view label;   ///< "window"
  std::string_view layer;   ///< "windows"
  std::string_view symbol;  ///< "Window"
  std::string_view finish;  ///< the operations that give it depth and color
};

/// From the back to the front; labels that are not among them lie in the last one.
std::span<const LabelLayer> LabelLayers();

/// The place of a label among LabelLayers.
size_t LayerOf(std::string_view label);

/// The whole rule file; its start is "Lot", its lot rect(WIDTH,1), its front the photograph.
/// Every element is a child of its layer: "WindowAt", placed by `segment`, or "WindowOutline",
/// placed by `vectorial` because it reaches over the wall's border. Not `finished`: what would give
/// elements depth is left out, so that their rectangles stay in the scene, as they are before any
/// normalisation.
std::string RulesOf(const AnnotatedFacade& facade, bool finished = true);

/// The lot for it.
std::string LotOf(const AnnotatedFacade& facade);

}  // namespace parti::tests
