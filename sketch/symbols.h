// Default names for what a suggested operation makes, for a person to change.
// Words only: no name has a meaning to the program.
#pragma once

#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::sketch {

/// Fills in the symbols of an action that has none:
///   extrude         Mass on an item that faces up or down, Block elsewhere
///   comp            Facade for sides, Roof for top, Base for bottom, Face for others
///   offset          RoofInner and RoofBorder on an item that faces up, Inner and Border elsewhere
///   split           by position: Lower | Upper, Lower | Middle | Upper where the axis is upright,
///                   Left | Right … else; four parts and more are Part1, Part2 …; sizes that are
///                   equal (`equal`: groups of successors) share the name of the first; Part
///                   where all are
///   repeat          Floor where the axis is upright, else Tile
///   other braces    the operation's word and the successor's number; without braces its word
void NameProducts(const grammar::Item& item, const std::vector<std::vector<size_t>>& equal,
                  grammar::Action* action);

}  // namespace parti::sketch
