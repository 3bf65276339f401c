// The layers of rules as a list that a person reads and changes: which are on, in which order, of
// which rule; and one change at a time, as edits. What edits do to the rules is layer_edits.h's.
#pragma once

#include <string>
#include <vector>

#include "grammar/rules/layer_edits.h"

namespace parti::grammar {

/// One layer as the edits leave it.
struct ListedLayer {
  std::string name;    ///< "door"
  std::string own;     ///< the symbol that it gets in the text; "" for more than a symbol
  std::string symbol;  ///< the symbol that it gets now; "" for more than a symbol
  bool on = true;
  bool operator==(const ListedLayer&) const = default;
};

/// The layers that one rule lays out, those that are off included.
struct LayeredRule {
  std::string rule;                 ///< its symbol
  std::vector<ListedLayer> layers;  ///< from the topmost down; of equal names, one
  bool operator==(const LayeredRule&) const = default;
};

/// All rules with layers, in the order of the text. `rules` are as they were read, without edits.
std::vector<LayeredRule> ListLayers(const RuleSet& rules, const LayerEdits& edits);

/// Symbols that a layer of `rule` may get: of rules without parameters, in the order of the text,
/// but for those that would come to `rule` again without end.
std::vector<std::string> SymbolsForLayers(const RuleSet& rules, const std::string& rule);

/// The edits with one layer switched.
LayerEdits Switched(LayerEdits edits, const std::string& rule, const std::string& layer, bool on);
/// The edits with one layer getting a symbol; "": the one of the text again.
LayerEdits Given(LayerEdits edits, const std::string& rule, const std::string& layer,
                 const std::string& symbol);
/// The edits with the layer at `from` of a listed rule moved to the place `to`, both counted from
/// the topmost and less than layers.size(). Where that is the order of the text, none is left.
LayerEdits Moved(LayerEdits edits, const RuleSet& rules, const LayeredRule& listed, size_t from,
                 size_t to);

}  // namespace parti::grammar
