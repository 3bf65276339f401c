// The operation table: one row per operation. Everything asks it: the parser checks arguments, the
// panels draw editors, the sketch pipeline samples and descends, the manual is generated from it.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/action.h"
#include "grammar/item.h"

namespace parti::grammar {

/// How an argument is written and stored: kLength (m), kAngle (degrees) and kFactor are numbers
/// (double); kAxis is x, y or z (Axis); kText is text in quotes (std::string), one of
/// Parameter::words where there are some; kColor is "#rrggbb" or a name in quotes (std::string;
/// color_text.h); kWord is a bare word, one of Parameter::words, dots and all (std::string): comp's
/// f, scope.xy; kBool is true or false (bool); kSize is a length, absolute or relative to a size of
/// the item's scope: 3 or '0.5 (Size, never floating; low and high bound the metres); kValue is a
/// number, true or false, or a text (double, bool, std::string), whatever it is.
enum class ParameterKind : uint8_t {
  kLength,
  kAngle,
  kFactor,
  kAxis,
  kText,
  kColor,
  kWord,
  kBool,
  kSize,
  kValue
};

/// What an operation wants to be told: one argument of it. Those that are not required may be left
/// out from the end; a word or color that is not required, also before others, as no number is one:
/// roofHip(30) is roofHip(byAngle, 30, 0), color(1, 0, 0) has the default text. A default below
/// the range stands for a number that was left out. An Action always has one argument per
/// parameter.
struct Parameter {
  std::string_view name;  ///< "distance"
  ParameterKind kind;
  double low = 0, high = 0;  ///< range of numbers, inclusive
  Argument default_value;
  bool required = true;
  std::string_view doc;
  std::span<const std::string_view> words = {};  ///< kWord, kText: what is allowed
};

/// What stands in an operation's braces. Names are written in the parentheses, and each is the key
/// of a successor: layers("floors", "door") { Floors | Door }.
enum class Braces : uint8_t { kNone, kSizes, kSelectors, kNames };

/// One item that an operation made. Successors whose symbol is NIL get none. `successor` is the
/// path-free number of the successor it belongs to: successors counted depth first through repeat
/// groups, groups themselves not counted; -1 for operations without braces.
struct Product {
  Item item;
  int successor = -1;
};

/// A row of the table: all that the program knows of an operation.
struct Operation {
  std::string_view name;  ///< in rules: "split"
  std::string_view word;  ///< in queries: "Split"
  std::string_view doc;
  std::string_view source;  ///< paper section
  std::span<const Parameter> parameters;
  Braces braces = Braces::kNone;
  std::span<const Selector::Kind> selectors = {};  ///< kSelectors: those that it knows
  ItemTypes takes;
  ItemTypes gives;
  bool in_place;        ///< changes the shape itself and makes no child: tag, color
  bool sampled = true;  ///< whether Samples spreads it: what a sketch may mean
  int file = -1;        ///< the parameter that names a file, which Action::asset then brings; -1
  std::string_view written = {};  ///< rules write it so, where not by its name; see Written
  bool notes = false;  ///< leaves the shape alone, and tells whoever derives something of it:
                       ///< report, print. Rules have it, trees don't (rules/rule_notes.h)

  /// Pure. Rows that change in place give the item itself, changed as far as an item can be
  /// (color); tag and symbol are the driver's to set on the shape. Products in creation order. An
  /// action that passed Check and an item whose type the row takes never break an invariant. errors
  /// kDegenerateGeometry, kBadArguments …: why this item can't take it.
  Result<std::vector<Product>> (*apply)(const Item& item, const Action& action);
};

/// Rows whose text tells more than their names. "repeat" is a row of its own: its argument is the
/// axis, its successors are the pattern, and it is written `split(axis) { ~size: X }*`; a group
/// inside a split's braces, `split(axis) { 4: A | { ~3: B }* }`, is Successor::repeat of the split.
/// `segment(axis) { ~size: X }*` is a segment with one successor, that group.
inline constexpr std::string_view kSplitName = "split", kRepeatName = "repeat",
                                  kSegmentName = "segment";

/// All rows, in the order of the manual.
std::span<const Operation> Operations();
/// nullptr when there is none.
const Operation* FindOperation(std::string_view name);
/// errors  kUnknownName  with "did you mean".
Result<const Operation*> OperationNamed(std::string_view name);

/// The type of what the row makes of an item of this type (4.10): a type that it takes and gives is
/// kept. Nothing where it doesn't take the type.
std::optional<ItemType> OutType(const Operation& operation, ItemType type);

/// An action of this row with default arguments and no successors.
Action Default(const Operation& operation);

/// Arguments' number, kinds and ranges, braces and keys against the row.
/// errors  kBadArguments, kBadNumber  naming the operation, and the argument or successor.
Result<void> Check(const Action& action);
/// One argument against its parameter. errors  as Check's.
Result<void> CheckArgument(const Operation& row, const Parameter& parameter,
                           const Argument& argument);
/// "a length in metres": what a parameter of this kind wants to be told.
std::string_view Wanted(ParameterKind kind);

/// "split" for the row repeat, which rules tell by its star; "extrude" for extrudeAlong, which they
/// tell by its direction; else the row's name.
inline std::string_view Written(const Operation& row) {
  return row.written.empty() ? row.name : row.written;
}

/// Check, the item's type, apply.
/// errors  those of Check and apply; kWrongItemType  names operation and type.
Result<std::vector<Product>> Apply(const Action& action, const Item& item);

/// The successor that Product::successor numbers.
const Successor& SuccessorAt(const Action& action, int number);

/// A number of an action that descent, panels and over-sketching may change.
struct Dial {
  std::string name;  ///< "distance", "sizes[2]"
  double* value;     ///< into the action
  double low, high;
  ParameterKind kind;
};
/// Every number of the action in reading order (arguments, then sizes, repeat groups included,
/// named by the number of their successor); valid until the action changes shape.
std::vector<Dial> Dials(Action* action);

/// The parameter space of a row sampled for an item: every combination of its axes and selectors
/// with each of `lengths_m` in turn for its length (both signs where its range allows them).
/// A split is sampled by one cut, { length: A | ~1: B }, a repeat by { ~length: A }*, with lengths
/// that fit the axis; comp by comp(f) { all: A }. Rows that don't take the item's type, or only
/// change an item in place, give nothing, nor do rows that are not `sampled` (Jesus 2018,
/// Listing 6.1).
std::vector<Action> Samples(const Operation& operation, const Item& item,
                            std::span<const double> lengths_m);

/// As rules write it: "extrude(12) Mass", "split(y) { 4: Ground | { ~3: Floor }* }". Numbers in the
/// shortest form that reads back as the same double.
std::string TextOf(const Action& action);

}  // namespace parti::grammar
