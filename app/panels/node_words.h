// What a node is told besides numbers: its axis, a word, a colour, a text, as things to pick.
// Numbers, query and names are node_sheet.h's.
#pragma once

#include <vector>

#include "app/panels/ui.h"
#include "grammar/selection_action.h"

namespace parti::app::panels {

/// One argument that can be picked.
struct WordPick {
  size_t argument = 0;
  std::string label;
  std::string now;  ///< as it is written in rules
  bool is_color = false;
  struct Choice {
    std::string name;   ///< "upward", "Brick"
    std::string label;  ///< on its button; "" for a colour
    grammar::Argument value;
  };
  std::vector<Choice> choices;  ///< empty: it is only typed
};

/// All of an action, in the order of its arguments; of one word there is no choice.
std::vector<WordPick> WordPicksOf(const grammar::Action& action);

/// How high a pick is in a room of this width, px.
float WordPickHeight(Ui* ui, const WordPick& pick);

/// Draws it; what was picked.
std::optional<grammar::Argument> DrawWordPick(Ui* ui, const WordPick& pick, Box box);

}  // namespace parti::app::panels
