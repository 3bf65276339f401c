// The elements that can be placed by hand on the face in hand (Jesus 2018, 8.2.1): which rules make
// them, and where the model has them.
// What a pen does to them is layer_drag.h's; what the numbers in a text are is
// grammar/layers/interactive_rules.h's.
#pragma once

#include <memory>
#include <vector>

#include "app/session_state.h"
#include "grammar/layers/interactive_rules.h"

namespace parti::app {

/// One element where a face has it. Its rectangle in `frame` is (left, bottom) to (left + width,
/// bottom + height), x across and y up; m.
struct PlacedLayer {
  grammar::InteractiveRules rules;
  grammar::Scope frame;
};

/// Those of one face. A value; the rules are shared and never null where there are layers.
struct PlacedLayers {
  std::shared_ptr<const grammar::RuleSet> rules;
  grammar::Scope face;              ///< of the planar shape that they lie on
  std::vector<PlacedLayer> layers;  ///< the uppermost first
};

/// The rules of a source as far as a hand can change them; attributes that the settings fix count
/// as no numbers of the text, so that what they place is not found. Null where the texts can't be
/// read.
/// cost  reads the texts.
std::shared_ptr<const grammar::RuleSet> RulesInReach(const RuleSource& source);

/// The elements on the innermost face that holds the shape selected last, or is it, and has any. A
/// face is a planar shape with its scene; elements that were dropped for what covers them count.
/// Not known are numbers that `set` changes within the rules: such elements lie elsewhere.
/// rules  of the source that made the model.
/// cost   linear in the scenes that the shape lies in.
PlacedLayers PlacedLayersOf(const Model& model, const std::vector<ShapeRef>& selected,
                            std::shared_ptr<const grammar::RuleSet> rules);

/// The same with other numbers of one of them: what shares one follows. The texts stay.
PlacedLayers PlacedWith(PlacedLayers placed, size_t layer, const grammar::InteractiveLayer& now);

}  // namespace parti::app
