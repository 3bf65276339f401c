#include "app/panels/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

namespace parti::app::panels {
namespace {

using grammar::Action;
using grammar::Selector;
using grammar::Size;
using grammar::Successor;

std::string Metres(double value) { return PlainNumber(value) + " m"; }

double NumberOf(const Action& action, size_t argument) {
  if (argument >= action.arguments.size()) return 0;
  const auto* number = std::get_if<double>(&action.arguments[argument]);
  return number ? *number : 0;
}

std::string Along(const Action& action) {
  for (const grammar::Argument& argument : action.arguments) {
    const auto* axis = std::get_if<grammar::Axis>(&argument);
    if (!axis) continue;
    return *axis == grammar::Axis::kX   ? "across"
           : *axis == grammar::Axis::kY ? "upward"
                                        : "in depth";
  }
  return "";
}

std::string WordsOf(const Size& size) {
  if (size.kind == Size::Kind::kAbsolute) return Metres(size.value);
  if (size.kind == Size::Kind::kRelative) return PlainNumber(size.value * 100) + " %";
  return "about " + Metres(size.value);  // of what is repeated: as many as fit
}

std::string WordsOf(const Successor& successor) {
  if (!successor.repeat.empty()) {
    std::string inside;
    for (const Successor& s : successor.repeat) inside += (inside.empty() ? "" : ", ") + WordsOf(s);
    return "repeated (" + inside + ")";
  }
  if (const auto* size = std::get_if<Size>(&successor.key)) return WordsOf(*size);
  if (const auto* selector = std::get_if<Selector>(&successor.key)) {
    return selector->kind == Selector::Kind::kIndex ? fmt::format("face {}", selector->index)
                                                    : std::string(NameOf(selector->kind));
  }
  return successor.symbol;
}

const Size* FloatingSize(const Successor& successor) {
  const auto* size = std::get_if<Size>(&successor.key);
  return size && successor.repeat.empty() && size->kind == Size::Kind::kFloating ? size : nullptr;
}

/// What stretches shares what the others leave: "rest", and of several unequal ones "2 parts of the
/// rest".
std::string WordsOfShare(double share, const std::vector<double>& shares) {
  const double least = *std::min_element(shares.begin(), shares.end());
  const bool equal = *std::max_element(shares.begin(), shares.end()) <= least * (1 + 1e-9);
  if (equal || !(least > 0)) return "rest";
  return fmt::format("{} × rest", PlainNumber(share / least));
}

/// "1 : 2 : 1" of what shares the whole.
std::string Ratio(const std::vector<double>& shares) {
  const double least = *std::min_element(shares.begin(), shares.end());
  std::string ratio;
  for (const double share : shares) {
    ratio += (ratio.empty() ? "" : " : ") + PlainNumber(least > 0 ? share / least : share);
  }
  return ratio;
}

std::string Parts(const Action& action) {
  std::vector<double> shares;
  for (const Successor& s : action.successors) {
    if (const Size* size = FloatingSize(s)) shares.push_back(size->value);
  }
  const size_t count = action.successors.size();
  const bool all = shares.size() == count && count > 1;
  const bool equal = all && std::adjacent_find(shares.begin(), shares.end(),
                                               std::not_equal_to<>()) == shares.end();
  if (equal) return fmt::format("{} equal parts", count);
  if (all) return Ratio(shares);
  if (count == 3 && shares.size() == 2 && shares[0] == shares[1] &&
      !FloatingSize(action.successors[1])) {
    return WordsOf(action.successors[1]) + " in the middle";
  }
  std::string parts;
  for (const Successor& s : action.successors) {
    const Size* size = FloatingSize(s);
    parts += (parts.empty() ? "" : ", ") + (size ? WordsOfShare(size->value, shares) : WordsOf(s));
  }
  return parts;
}

std::string Extruded(const Action& action) {
  const double d = NumberOf(action, 0);
  return d < 0 ? fmt::format("Push in {}", Metres(-d)) : fmt::format("Extrude {}", Metres(d));
}

std::string Offset(const Action& action) {
  const double d = NumberOf(action, 0);
  return fmt::format("Offset {} {}", Metres(std::abs(d)), d < 0 ? "inward" : "outward");
}

std::string Repeated(const Action& action) {
  if (action.successors.size() == 1) {
    if (const auto* size = std::get_if<Size>(&action.successors[0].key)) {
      return fmt::format("Repeat {} every {}", Along(action), Metres(size->value));
    }
  }
  return fmt::format("Repeat {}: {}", Along(action), Parts(action));
}

/// "Gable roof 3 m high" or "Gable roof 35°".
std::string Roof(std::string_view kind, Action action) {
  const std::vector<grammar::Dial> dials = grammar::Dials(&action);
  const bool high = dials.at(0).kind == grammar::ParameterKind::kLength;
  const std::string number = PlainNumber(*dials[0].value);
  return fmt::format("{} roof {}{}", kind, number, high ? " m high" : "°");
}

/// "L shape: 3 m, 4 m".
std::string Wings(std::string_view letter, const Action& action) {
  std::string widths;
  for (size_t i = 0; i < action.arguments.size(); ++i) {
    widths += (i == 0 ? ": " : ", ") + Metres(NumberOf(action, i));
  }
  return fmt::format("{} shape{}", letter, widths);
}

/// Of operations without words of their own: their name, with a capital, and what they were told.
std::string Named(const Action& action) {
  std::string words = Capital(std::string(action.operation->name));
  for (size_t i = 0; i < action.arguments.size() && i < action.operation->parameters.size(); ++i) {
    const grammar::Parameter& parameter = action.operation->parameters[i];
    if (!parameter.required && action.arguments[i] == parameter.default_value) continue;
    if (const auto* text = std::get_if<std::string>(&action.arguments[i])) words += " " + *text;
    if (!std::holds_alternative<double>(action.arguments[i])) continue;
    const std::string unit = UnitOf(action.operation->parameters[i].kind);
    words += " " + PlainNumber(NumberOf(action, i)) + (unit.empty() ? "" : " " + unit);
  }
  return words;
}

std::string Taken(const Action& action) {
  const auto& component = std::get<std::string>(action.arguments.at(0));
  return fmt::format("Take {}: {}", NameOfComponent(component), Parts(action));
}

struct Row {
  std::string_view name;
  Icon icon;
  std::string (*words)(const Action&);
  std::optional<Icon> upward = {};  ///< where it differs
};

constexpr Row kRows[] = {
    {"extrude", Icon::kExtrude, Extruded},
    {"split", Icon::kSplitAcross,
     [](const Action& a) { return fmt::format("Split {}: {}", Along(a), Parts(a)); },
     Icon::kSplitUpward},
    {"repeat", Icon::kRepeatAcross, Repeated, Icon::kRepeatUpward},
    {"comp", Icon::kComp, Taken},
    {"offset", Icon::kOffset, Offset},
    {"roofHip", Icon::kOperation, [](const Action& a) { return Roof("Hip", a); }},
    {"roofGable", Icon::kOperation, [](const Action& a) { return Roof("Gable", a); }},
    {"roofPyramid", Icon::kOperation, [](const Action& a) { return Roof("Pyramid", a); }},
    {"roofShed", Icon::kOperation, [](const Action& a) { return Roof("Shed", a); }},
    {"shapeL", Icon::kOperation, [](const Action& a) { return Wings("L", a); }},
    {"shapeU", Icon::kOperation, [](const Action& a) { return Wings("U", a); }},
    {"shapeO", Icon::kOperation, [](const Action& a) { return Wings("O", a); }},
    {"color", Icon::kColor, Named},
    {"tag", Icon::kTag, Named},
};

const Row* RowOf(const Action& action) {
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows), [&](const Row& r) {
    return action.operation && r.name == action.operation->name;
  });
  return row == std::end(kRows) ? nullptr : row;
}

void AddSymbols(const std::vector<Successor>& successors, std::vector<std::string>* symbols) {
  for (const Successor& s : successors) {
    AddSymbols(s.repeat, symbols);
    const bool known = std::find(symbols->begin(), symbols->end(), s.symbol) != symbols->end();
    if (!s.symbol.empty() && s.symbol != grammar::kNil && !known) symbols->push_back(s.symbol);
  }
}

}  // namespace

std::string_view NameOfComponent(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kNames = {
      {{"f", "faces"}, {"e", "edges"}, {"fe", "face edges"}, {"v", "vertices"}}};
  const auto* name = std::find_if(kNames.begin(), kNames.end(),
                                  [&](const auto& entry) { return entry.first == word; });
  return name == kNames.end() ? word : name->second;
}

std::string Capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] -= 'a' - 'A';
  return text;
}

std::string KeptTogether(const std::string& text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string kept;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool between = text[i] == ' ' && i > 0 && i + 1 < text.size();
    const bool unit = between && is_digit(text[i - 1]) && !is_digit(text[i + 1]);
    const bool brace = between && (text[i - 1] == '{' || text[i + 1] == '}');
    if (unit || brace) {
      kept += "\u00a0";
    } else {
      kept += text[i];
    }
  }
  return kept;
}

std::string PlainNumber(double value) {
  if (!std::isfinite(value)) return "?";
  std::string text = fmt::format("{:.3f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  if (text == "-0") return "0";
  return text;
}

std::string UnitOf(grammar::ParameterKind kind) {
  if (kind == grammar::ParameterKind::kLength) return "m";
  return kind == grammar::ParameterKind::kAngle ? "°" : "";
}

std::string WordsOf(const Action& action) {
  if (!action.operation) return "";
  const Row* row = RowOf(action);
  return row ? row->words(action) : Named(action);
}

std::string SymbolsOf(const Action& action) {
  std::vector<std::string> symbols;
  AddSymbols(action.successors, &symbols);
  if (!action.symbol.empty()) symbols.push_back(action.symbol);
  std::string text;
  for (const std::string& symbol : symbols) text += (text.empty() ? "" : ", ") + symbol;
  return text;
}

Icon IconOf(const Action& action) {
  const Row* row = RowOf(action);
  if (!row) return Icon::kOperation;
  return row->upward && Along(action) == "upward" ? *row->upward : row->icon;
}

}  // namespace parti::app::panels
