// What a person does besides drawing, as values: picked suggestions, views, typed text, undo.
// The lines of a drawing's command stream and of the document's history; what panels send. The list
// for people is in docs/drawings.md.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "app/node_path.h"
#include "base/camera.h"
#include "base/error.h"
#include "grammar/rules/layer_edits.h"

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

/// "name B CenterFloors": renames a symbol that the node in hand gives. Queries follow where no
/// other node gives that symbol, and always below the node.
struct RenameSymbol {
  std::string from, to;
  bool operator==(const RenameSymbol&) const = default;
};

/// "rename-symbol Facade Wall": renames a symbol wherever it is given and asked for.
struct RenameEverywhere {
  std::string from, to;
  bool operator==(const RenameEverywhere&) const = default;
};

/// "query .Facade:north": another selection for the node in hand; where none is, what the next
/// sketch acts on. "query 2": the 2nd query offered for the shapes tapped. "query none": the next
/// sketch acts on what it is drawn on again, whatever is in hand.
struct SetQuery {
  static constexpr const char* kNone = "none";

  std::string query;
  bool operator==(const SetQuery&) const = default;
};

/// "set distance 12", "set sizes[1] 350 cm": a typed number for the node in hand; the name is a
/// dial's. Lengths may have a unit (ParseLength); the value is in metres.
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

/// "rewrite tree house { .Lot --> extrude(9) Mass }": all trees anew, as they are typed, on one
/// line: blanks and line feeds are alike in trees. What is then at the path of the node in hand is
/// in hand.
struct Rewrite {
  std::string text;
  bool operator==(const Rewrite&) const = default;
};

/// "rule-text {"file":"house.cga","text":"Lot --> extrude(9)"}": another text in the place of one
/// of the rule files that the building is made by; RuleFile::name names it. Bytes that are no UTF-8
/// become U+FFFD in the line.
struct SetRuleText {
  std::string file, text;
  bool operator==(const SetRuleText&) const = default;
};

/// "layers {"off":["Facade.door"],"order":[["Facade",["door","floors"]]]}": what is off, in another
/// order or of another rule, of all layers of the rule files; "layers {}": none.
struct EditLayers {
  grammar::LayerEdits layers;
  bool operator==(const EditLayers&) const = default;
};

/// "layer Facade.door off" or on; up or down, by one; "gets Gate", or "as-written": one layer of
/// the rule files. What others have become in between stays.
struct ChangeLayer {
  enum class How { kOff, kOn, kUp, kDown, kGets };
  std::string layer;  ///< "Facade.door"
  How how = How::kOff;
  std::string symbol = {};  ///< that it gets; "": the one of the text
  bool operator==(const ChangeLayer&) const = default;
};

/// "place Door left 16.5 bottom 1.22": numbers of an element that rule files place by numbers, in
/// m; those that are not named stay. Of the newest text, whatever has been typed in between.
struct PlaceElement {
  std::string element;  ///< its rule
  std::optional<double> left = {}, bottom = {}, width = {}, height = {};
  bool operator==(const PlaceElement&) const = default;
};

/// "take 0/2": the node in hand, which name, query and set act on; "take none": none is.
struct Take {
  NodePath path;  ///< of a node; empty: none
  bool operator==(const Take&) const = default;
};

/// "switch 0/2 off": keeps a node and all below it, or a whole tree, from running; or lets it.
struct Switch {
  NodePath path;
  bool on = true;
  bool operator==(const Switch&) const = default;
};

/// "move 0/2 to 0/0/1": a node with all below it, or a tree, to the path that it then has.
struct Move {
  NodePath from, to;
  bool operator==(const Move&) const = default;
};

/// "delete 0/2": a node with all below it, or a tree.
struct Delete {
  NodePath path;
  bool operator==(const Delete&) const = default;
};

/// "tree ornaments": a new tree, which runs last.
struct AddTree {
  std::string name;
  bool operator==(const AddTree&) const = default;
};

/// "rename-tree 1 ornaments".
struct RenameTree {
  int tree = 0;
  std::string name;
  bool operator==(const RenameTree&) const = default;
};

/// "keep-view street corner": keeps the view at hand under a name, or anew under one that is there.
struct KeepView {
  std::string name;
  bool operator==(const KeepView&) const = default;
};

/// "go-view street corner": looks from there again, in a picture of the present size.
struct GoView {
  std::string name;
  bool operator==(const GoView&) const = default;
};

/// "drop-view street corner".
struct DropView {
  std::string name;
  bool operator==(const DropView&) const = default;
};

/// "erase 3 4": strokes of the sketch, by their numbers in the session (DrawnStroke::number).
struct Erase {
  std::vector<uint32_t> strokes;
  bool operator==(const Erase&) const = default;
};

/// "select 0/2/5 lot-1:0/3": shapes tapped; one that was selected before no longer is. "select
/// none": no shape is. Empty: none. The last that goes takes along the query chosen for the next
/// sketch.
struct Select {
  std::vector<std::string> shapes;  ///< their ids
  bool operator==(const Select&) const = default;
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

using Command = std::variant<SetLot, SetView, Pick, RenameSymbol, RenameEverywhere, SetQuery,
                             SetNumber, AddNode, Rewrite, SetRuleText, EditLayers, ChangeLayer,
                             PlaceElement, Take, Switch, Move, Delete, AddTree, RenameTree,
                             KeepView, GoView, DropView, Erase, Select, ClearSketch, Undo, Redo>;

/// Looking and taking a node in hand change nothing that undo would bring back.
bool IsLooking(const Command& command);

/// One line; line feeds in names become blanks.
/// errors  kUnknownName  no such command, with "did you mean";  kBadText  what is missing, or not a
///         path;  kBadNumber  a number that is not one, or a camera that can't see.
Result<Command> ParseCommand(std::string_view line);

/// Reads back as the same command.
std::string TextOf(const Command& command);

}  // namespace parti::app
