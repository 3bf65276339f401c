// What a person does besides drawing, as values: picked suggestions, views, typed text, undo.
// The lines of a drawing's command stream, of the document's history, and of the panels to come.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/camera.h"
#include "base/error.h"

namespace parti::app {

/// "lot rect(20,14)": begins a building on one or more lots (LOT of docs/interfaces.md).
struct SetLot {
  std::string lot;
  bool operator==(const SetLot&) const = default;
};

/// "view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000": m, degrees, px; up is +y.
struct SetView {
  Camera camera;
  bool operator==(const SetView&) const = default;
};

/// "pick 2" or "pick 2 split": accepts the 2nd suggestion. With an operation's name, the first
/// suggestion of that name where the 2nd is of another: a drawing outlives better rankings.
struct Pick {
  int number = 1;  ///< from 1
  std::string operation;
  bool operator==(const Pick&) const = default;
};

/// "name B CenterFloors": renames a symbol that the node just made gives.
struct RenameSymbol {
  std::string from, to;
  bool operator==(const RenameSymbol&) const = default;
};

/// "query .Facade:north": another selection for the node just made.
struct SetQuery {
  std::string query;
  bool operator==(const SetQuery&) const = default;
};

/// "set distance 12": a typed number for the node just made; the name is a dial's.
struct SetNumber {
  std::string dial;
  double value = 0;
  bool operator==(const SetNumber&) const = default;
};

/// "node .Glass --> color("#7f9db5")": a typed node, at the end of the first tree.
struct AddNode {
  std::string text;
  bool operator==(const AddNode&) const = default;
};

/// "clear": drops the strokes that no suggestion has been picked for.
struct ClearSketch {
  bool operator==(const ClearSketch&) const = default;
};
/// "undo": takes back the last stroke or command.
struct Undo {
  bool operator==(const Undo&) const = default;
};
/// "redo": does again what was taken back.
struct Redo {
  bool operator==(const Redo&) const = default;
};

using Command = std::variant<SetLot, SetView, Pick, RenameSymbol, SetQuery, SetNumber, AddNode,
                             ClearSketch, Undo, Redo>;

/// errors  kUnknownName  no such command, with "did you mean";  kBadText  what is missing;
///         kBadNumber  a number that is not one, or a camera that can't see.
Result<Command> ParseCommand(std::string_view line);

/// Reads back as the same command.
std::string TextOf(const Command& command);

}  // namespace parti::app
