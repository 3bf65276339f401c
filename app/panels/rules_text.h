// The rules as lines of text that can be typed over, with what is wrong at its line.
// Pure: what lines look like is text_sheet.h's; the language is grammar's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/session_state.h"

namespace parti::app::panels {

/// One line, without its indentation.
struct RulesLine {
  std::string text;
  int depth = 0;                     ///< steps of indentation
  bool closes = false;               ///< only a brace: nothing to type over
  std::vector<std::string> notes{};  ///< what is wrong here, and what its last run had to say
};

/// Notes what is wrong at the line of its place; without a place, or past the last line, there. A
/// text without lines gets one.
void AddNote(const Error& error, std::vector<RulesLine>* lines);

/// Text that was typed and can't be read yet.
struct TypedRules {
  std::vector<std::string> lines;  ///< empty: nothing is typed, the rules are what they are
  std::shared_ptr<const grammar::Trees> over;  ///< the rules that it was typed over

  /// Whether it is to be shown for these rules: they are still those that it was typed over.
  bool Waits(const Model& model) const { return !lines.empty() && over == model.rules; }
};

/// The lines of the rules that are in force, or of what is typed over them.
std::vector<RulesLine> LinesOf(const SessionState& state, const TypedRules& typed);

/// All rules on one line.
Rewrite RewriteAs(const grammar::Trees& trees);

/// Types `text` over a line; an empty one is taken out, and so is the tree that was emptied. What
/// can be read is the command to send, and nothing waits any more; else it waits in `*typed`.
std::optional<Rewrite> TypeOver(const SessionState& state, size_t line, const std::string& text,
                                TypedRules* typed);

}  // namespace parti::app::panels
