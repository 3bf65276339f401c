// The layers that the sheet shows: those of the rule that made the face in hand, else all.
// Pure: what rows look like is layers_sheet.h's; what edits do is grammar's.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session_state.h"
#include "grammar/rules/layer_list.h"

namespace parti::app::panels {

/// The rules of a model's files without layer edits, read once for each text.
class KnownRules {
 public:
  /// Null where the model has no files. cost  reads them where they are other than at the last
  /// call.
  const grammar::RuleSet* Of(const Model& model);

 private:
  std::shared_ptr<const RuleSource> of_;
  std::shared_ptr<const grammar::RuleSet> rules_;
};

/// Layers in the order of the text, of each rule from the topmost down.
struct ShownLayers {
  bool of_face = false;  ///< the only rule is that of the face in hand
  std::vector<grammar::LayeredRule> rules;
};

/// Of the shape tapped last: the nearest of its rule and those that it came of that lays out
/// layers; where none does, or nothing is tapped, all. `rules` are the model's (KnownRules).
ShownLayers LayersOf(const SessionState& state, const grammar::RuleSet& rules);

}  // namespace parti::app::panels
