#include "app/panels/rules_text.h"

#include <algorithm>

#include "app/panels/tree_rows.h"
#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

constexpr size_t kIndent = 2;  // blanks a step, as TextOf writes it

std::vector<std::string> Split(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t from = 0; from < text.size();) {
    const size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

std::string Joined(const std::vector<std::string>& lines, char between) {
  std::string text;
  for (const std::string& line : lines) text += line + between;
  return text;
}

RulesLine LineOf(const std::string& text) {
  const size_t first = std::min(text.find_first_not_of(" \t"), text.size());
  RulesLine line{text.substr(first), static_cast<int>(first / kIndent)};
  line.closes = line.text == "}";
  return line;
}

/// What each node's last run had to say, at the line with its arrow; a node has one line.
void AddNotesOfRuns(const SessionState& state, std::vector<RulesLine>* lines) {
  auto line = lines->begin();
  for (const TreeRow& row : RowsOf(state)) {
    if (!row.node) continue;
    line = std::find_if(line, lines->end(),
                        [](const RulesLine& l) { return l.text.find("-->") != std::string::npos; });
    if (line == lines->end()) return;
    line->notes = row.notes;
    ++line;
  }
}

void AddErrors(const std::vector<std::string>& typed, std::vector<RulesLine>* lines) {
  const auto read = grammar::ParseTrees(Joined(typed, '\n'));
  if (read || lines->empty()) return;
  for (const Error& error : read.error()) AddNote(error, lines);
}

std::vector<std::string> TextLines(const SessionState& state, const TypedRules& typed) {
  return typed.Waits(state.model) ? typed.lines : Split(grammar::TextOf(state.model.trees()));
}

}  // namespace

void AddNote(const Error& error, std::vector<RulesLine>* lines) {
  if (lines->empty()) lines->emplace_back();
  const int last = static_cast<int>(lines->size());
  const int number = error.place ? std::clamp(error.place->line, 1, last) : last;
  const std::string hint = error.hint.empty() ? "" : " (" + error.hint + ")";
  (*lines)[static_cast<size_t>(number - 1)].notes.push_back(Capital(error.message) + hint + ".");
}

std::vector<RulesLine> LinesOf(const SessionState& state, const TypedRules& typed) {
  std::vector<RulesLine> lines;
  for (const std::string& line : TextLines(state, typed)) lines.push_back(LineOf(line));
  if (typed.Waits(state.model)) {
    AddErrors(typed.lines, &lines);
  } else {
    AddNotesOfRuns(state, &lines);
  }
  return lines;
}

Rewrite RewriteAs(const grammar::Trees& trees) {
  // As TextOf writes them, so that no comment swallows what follows.
  std::string text;
  for (const std::string& line : Split(grammar::TextOf(trees))) {
    text +=
        (text.empty() ? "" : " ") + line.substr(std::min(line.find_first_not_of(' '), line.size()));
  }
  return {text};
}

std::optional<Rewrite> TypeOver(const SessionState& state, size_t line, const std::string& text,
                                TypedRules* typed) {
  std::vector<std::string> lines = TextLines(state, *typed);
  if (line >= lines.size()) return std::nullopt;
  const std::string indent(std::min(lines[line].find_first_not_of(' '), lines[line].size()), ' ');
  if (text.empty()) {
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
  } else {
    lines[line] = indent + text;
  }
  const auto read = grammar::ParseTrees(Joined(lines, '\n'));
  if (read && !read->empty()) {
    typed->lines.clear();
    return RewriteAs(*read);
  }
  *typed = {std::move(lines), state.model.rules};
  return std::nullopt;
}

}  // namespace parti::app::panels
