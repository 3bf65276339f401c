// Interactive layers in rule files: the pattern of Jesus 2018, Listing 8.2, found in rules that
// were read, written as text, and its numbers changed where they stand. What dragging does to the
// numbers is interactive_layer.h's.
#pragma once

#include <string>
#include <vector>

#include "grammar/layers/interactive_layer.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// Two rules of that pattern, and where their numbers stand: in the rules themselves, or in the
/// attributes that they name.
struct InteractiveRules {
  InteractiveLayer layer;
  TextRange bottom, left, width, height;  ///< of one file
};

/// All pairs of rules of the form
///   Name --> segment(x, left, width, ~1) { NIL | Tile | NIL }
///   Tile --> segment(y, bottom, height, ~1) { NIL | Payload | NIL }
/// in the order of their names in the text. The numbers are written as such, or are attributes and
/// constants whose values are.
std::vector<InteractiveRules> InteractiveLayersOf(const RuleSet& rules);

/// The text of the file with `layer`'s numbers in the place of the old ones, to the millimetre; all
/// else stays as it was, to the byte. Where layers share an attribute, all of them follow; where
/// numbers of the layer do, the first that changed of bottom, left, width, height counts.
std::string TextWith(const RuleSet& rules, const InteractiveRules& found,
                     const InteractiveLayer& layer);

/// What `one` is once TextWith has written `layer` in the place of `changed`: its numbers that
/// stand where those that changed did are the same. Itself, if none does.
InteractiveLayer Following(const InteractiveRules& one, const InteractiveRules& changed,
                           const InteractiveLayer& layer);

/// The two rules as text: InteractiveLayer(Name, Payload, bottom, left, width, height) of Listing
/// 8.2. The tile's symbol is the name with "VTile" after it.
std::string RulesTextOf(const InteractiveLayer& layer);

}  // namespace parti::grammar
