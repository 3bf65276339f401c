// What commands change of the rule files that a building is made by: their text, their layers.
// Pure functions of a model. Undo is session.h's; reading and deriving are rule_source.h's and
// session_state.h's.
#pragma once

#include <vector>

#include "app/command.h"
#include "app/session_state.h"

namespace parti::app {

/// A model, or everything that is wrong with the rules.
using EditedModel = tl::expected<Model, std::vector<Error>>;

/// The model with another text in the place of one of its files. `tree` blocks of the texts take
/// the place of the model's trees where the edit changes them; else those stay.
/// errors  kNothingMade  the model has no rule files;  kUnknownName  no such file;  those of
///         RulesOf, all;  those of GroundOf and Derived.
/// cost  reads all files, derives all lots.
EditedModel WithRuleText(const Model& model, const SetRuleText& edit);

/// The model with these edits in the place of all that its layers had. errors, cost  as above.
EditedModel WithLayerEdits(const Model& model, const EditLayers& edit);

/// The model with one of its layers changed, and the others as they are. The topmost stays where it
/// is when it is moved up, the undermost when down.
/// errors  kUnknownName  no rule has such a layer;  the others as above. cost  as above.
EditedModel WithLayerChange(const Model& model, const ChangeLayer& change);

/// The model with other numbers of one of the elements that its rules place by numbers, where they
/// stand in the text; nothing else of it changes.
/// errors  kUnknownName  the rules place none of this name;  the others as above. cost  as above.
EditedModel WithElementPlaced(const Model& model, const PlaceElement& edit);

/// The shapes of `before` that are in `after`, too: of the same id and symbol. In the place of one
/// that is not, the nearest of its ancestors that is, but for the lot; each once.
std::vector<ShapeRef> KeptShapes(const Model& before, const std::vector<ShapeRef>& shapes,
                                 const Model& after);

/// All errors in the words of one: the first, and the others after it with their places. Not empty.
Error AsOne(const std::vector<Error>& errors);

}  // namespace parti::app
