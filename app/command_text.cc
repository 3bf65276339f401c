// Commands as the text that ParseCommand (command.cc) reads back.
#include <fmt/format.h>

#include "app/command.h"
#include "app/rule_source.h"
#include "base/json.h"

namespace parti::app {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>  // clang 16 can't work it out
Overloaded(Cases...) -> Overloaded<Cases...>;

/// On one line; what is no UTF-8 can't stand in JSON.
std::string LineOf(const SetRuleText& command) {
  const Json json = {{"file", command.file}, {"text", command.text}};
  return "rule-text " + json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string_view TextOf(ChangeLayer::How how) {
  switch (how) {
    case ChangeLayer::How::kOff:
      return "off";
    case ChangeLayer::How::kOn:
      return "on";
    case ChangeLayer::How::kUp:
      return "up";
    case ChangeLayer::How::kDown:
      return "down";
    case ChangeLayer::How::kGets:
      break;
  }
  return "gets";
}

std::string LineOf(const ChangeLayer& command) {
  if (command.how != ChangeLayer::How::kGets) {
    return fmt::format("layer {} {}", command.layer, TextOf(command.how));
  }
  if (command.symbol.empty()) return fmt::format("layer {} as-written", command.layer);
  return fmt::format("layer {} gets {}", command.layer, command.symbol);
}

std::string LineOf(const PlaceElement& command) {
  std::string line = "place " + command.element;
  const auto add = [&](const char* word, const std::optional<double>& number) {
    if (number) line += fmt::format(" {} {}", word, *number);
  };
  add("left", command.left);
  add("bottom", command.bottom);
  add("width", command.width);
  add("height", command.height);
  return line;
}

}  // namespace

std::string TextOf(const Command& command) {
  return std::visit(
      Overloaded{
          [](const SetLot& c) { return "lot " + c.lot; },
          [](const SetView& c) {
            const Camera& v = c.camera;
            return fmt::format("view eye {} {} {} target {} {} {} fov {} size {} {}", v.eye.x,
                               v.eye.y, v.eye.z, v.target.x, v.target.y, v.target.z,
                               v.vertical_fov.degrees(), v.width_px, v.height_px);
          },
          [](const Pick& c) {
            return c.operation.empty() ? fmt::format("pick {}", c.number)
                                       : fmt::format("pick {} {}", c.number, c.operation);
          },
          [](const RenameSymbol& c) { return fmt::format("name {} {}", c.from, c.to); },
          [](const RenameEverywhere& c) {
            return fmt::format("rename-symbol {} {}", c.from, c.to);
          },
          [](const SetQuery& c) { return "query " + c.query; },
          [](const SetNumber& c) { return fmt::format("set {} {}", c.dial, c.value); },
          [](const AddNode& c) { return "node " + c.text; },
          [](const Rewrite& c) { return "rewrite " + c.text; },
          [](const SetRuleText& c) { return LineOf(c); },
          [](const EditLayers& c) { return "layers " + TextOf(c.layers); },
          [](const ChangeLayer& c) { return LineOf(c); },
          [](const PlaceElement& c) { return LineOf(c); },
          [](const Take& c) { return "take " + (c.path.empty() ? "none" : PathText(c.path)); },
          [](const Switch& c) {
            return fmt::format("switch {} {}", PathText(c.path), c.on ? "on" : "off");
          },
          [](const Move& c) {
            return fmt::format("move {} to {}", PathText(c.from), PathText(c.to));
          },
          [](const Delete& c) { return "delete " + PathText(c.path); },
          [](const AddTree& c) { return "tree " + c.name; },
          [](const RenameTree& c) { return fmt::format("rename-tree {} {}", c.tree, c.name); },
          [](const KeepView& c) { return "keep-view " + c.name; },
          [](const GoView& c) { return "go-view " + c.name; },
          [](const DropView& c) { return "drop-view " + c.name; },
          [](const Erase& c) { return fmt::format("erase {}", fmt::join(c.strokes, " ")); },
          [](const Select& c) {
            return c.shapes.empty() ? std::string("select none")
                                    : fmt::format("select {}", fmt::join(c.shapes, " "));
          },
          [](const ClearSketch&) { return std::string("clear"); },
          [](const Undo&) { return std::string("undo"); },
          [](const Redo&) { return std::string("redo"); },
      },
      command);
}

}  // namespace parti::app
