// One operation with its numbers and what follows from it: "split(y) { 4: Ground | { ~3: Floor }*
// }". The value that rules, selection-action nodes, suggestions and panels share.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grammar/item.h"

namespace parti::grammar {

struct Asset;
struct Operation;

/// An axis of an item's scope.
enum class Axis : uint8_t { kX, kY, kZ };

/// A size along a split axis: 3 (m), '0.5 (of the whole), ~1 (share of the rest).
struct Size {
  enum class Kind : uint8_t { kAbsolute, kRelative, kFloating };
  Kind kind = Kind::kAbsolute;
  double value = 1;
  bool operator==(const Size&) const = default;
};

/// CGA's selectors of faces, edges and parts; each row of the table lists those that it knows. The
/// street's sides are those of front_edge.h.
struct Selector {
  enum class Kind : uint8_t {
    kAll,
    kFront,
    kBack,
    kLeft,
    kRight,
    kTop,
    kBottom,
    kSide,
    kVertical,
    kHorizontal,
    kIndex,
    kInside,
    kBorder,
    kStreetFront,
    kStreetBack,
    kStreetLeft,
    kStreetRight,
    kStreetSide,
    kShape,
    kRemainder,
    kAslant,
    kNutant,
    kEave,
    kHip,
    kValley,
    kRidge,
    kWorldSouth,
    kWorldNorth,
    kWorldWest,
    kWorldEast,
    kWorldUp,
    kWorldDown,
    kWorldSide
  };
  Kind kind = Kind::kAll;
  int index = 0;  ///< kIndex
  bool operator==(const Selector&) const = default;
};

std::string_view NameOf(Axis axis);  ///< "x"
/// "front", "street.front"; kIndex is written as its number.
std::string_view NameOf(Selector::Kind kind);
/// Every name but that of kIndex, in the order of the kinds.
std::vector<std::string_view> SelectorNames();
/// Nothing when there is no such selector; kIndex has no name.
std::optional<Selector::Kind> SelectorNamed(std::string_view name);

struct Action;

/// What stands before a successor: a size (split), a selector (comp, offset), a name (layers).
using SuccessorKey = std::variant<std::monostate, Size, Selector, std::string>;

/// One alternative in the braces. A split's has a size, comp's and offset's a selector, layers' the
/// name of its layer. `repeat` not empty: "{ … }*", a group that repeats; all else is then unused.
struct Successor {
  SuccessorKey key;
  std::vector<Action> actions;  ///< in place, before the symbol: 4: tag("x") Ground
  std::string symbol;           ///< "" none; "NIL" makes nothing
  bool deferred = false;        ///< "@Symbol": derived after the next normalisation (4.3.3)
  std::vector<Successor> repeat;
  bool operator==(const Successor&) const;
};

/// A number, a switch, an axis, a text or word, or a size (metres, or '0.5 of the scope's size).
using Argument = std::variant<double, bool, Axis, std::string, Size>;

/// An operation with its arguments and what it makes: a value that text, panels and sketches share.
struct Action {
  const Operation* operation = nullptr;  ///< a row of the table; not null in a valid action
  std::vector<Argument> arguments;       ///< one per parameter of the row, in its order
  std::vector<Successor> successors;
  std::string symbol;                  ///< after an operation without braces: extrude(12) Mass
  std::shared_ptr<const Asset> asset;  ///< read from the file it names (asset_library.h); never
                                       ///< compared
  bool operator==(const Action&) const;
};

inline constexpr std::string_view kNil = "NIL";

}  // namespace parti::grammar
