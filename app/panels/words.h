// Operations and numbers in plain words: what is written on cards and rows.
// Pure functions of the table's values; the language of rules is grammar's.
#pragma once

#include <string>
#include <string_view>

#include "app/panels/icons.h"
#include "grammar/action.h"
#include "grammar/operation.h"

namespace parti::app::panels {

/// With a capital first letter, where that is one of a to z: messages that stand alone.
std::string Capital(std::string text);

/// A line that lets no number and its unit part: "19 m" with a blank that doesn't break.
std::string KeptTogether(const std::string& text);

/// As people write it: "3", "2.5", "0.05"; at most three places, no trailing zeros, "-" before
/// negative ones; reads back as a number.
std::string PlainNumber(double value);

/// "m", "°", or "" for factors.
std::string UnitOf(grammar::ParameterKind kind);

/// "Extrude 19 m", "Split upward: 4 m, rest, 1 m", "Repeat across every 2.5 m". Operations without
/// words of their own give their name and numbers.
std::string WordsOf(const grammar::Action& action);

/// What comp's letters stand for: "faces" of "f"; the word itself where it has no other name.
std::string_view NameOfComponent(std::string_view word);

/// What it gives: "Ground, CenterFloors, TopFloor"; "" when nothing has a name.
std::string SymbolsOf(const grammar::Action& action);

/// The operation's icon, turned as its axis is; Icon::kOperation for those without one.
Icon IconOf(const grammar::Action& action);

}  // namespace parti::app::panels
