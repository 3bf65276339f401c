#include "app/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/length_text.h"
#include "app/rule_source.h"
#include "base/json.h"

namespace parti::app {
namespace {

/// The words of a line, and what follows the first one, untouched.
struct Words {
  std::vector<std::string_view> items;
  std::string_view rest;
};

constexpr std::string_view kSpace = " \t\r\n";

Words Split(std::string_view line) {
  Words words;
  for (size_t at = line.find_first_not_of(kSpace); at != std::string_view::npos;
       at = line.find_first_not_of(kSpace, at)) {
    if (words.items.size() == 1) words.rest = line.substr(at);
    size_t end = line.find_first_of(kSpace, at);
    if (end == std::string_view::npos) end = line.size();
    words.items.push_back(line.substr(at, end - at));
    at = end;
  }
  while (!words.rest.empty() && kSpace.find(words.rest.back()) != std::string_view::npos) {
    words.rest.remove_suffix(1);
  }
  return words;
}

Result<double> Number(std::string_view word) {
  double value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
    return Fail(ErrorCode::kBadNumber, fmt::format("'{}' is not a number", word));
  }
  return value;
}

tl::unexpected<Error> Usage(std::string_view example) {
  return Fail(ErrorCode::kBadText, "this command is not complete",
              fmt::format("for example: {}", example));
}

Result<uint32_t> Count(std::string_view word) {
  uint32_t value = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (code != std::errc() || end != word.data() + word.size()) {
    return Fail(ErrorCode::kBadNumber, fmt::format("'{}' is not a number counted from 0", word));
  }
  return value;
}

constexpr std::string_view kNone = "none";

constexpr std::string_view kViewExample = "view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000";

Result<Command> ParseView(const Words& words) {
  // view eye X Y Z target X Y Z fov D size W H
  constexpr std::array<std::string_view, 14> kForm = {
      "view", "eye", "", "", "", "target", "", "", "", "fov", "", "size", "", ""};
  if (words.items.size() != kForm.size()) return Usage(kViewExample);
  std::vector<double> numbers;
  for (size_t i = 0; i < kForm.size(); ++i) {
    if (!kForm[i].empty()) {
      if (words.items[i] != kForm[i]) return Usage(kViewExample);
      continue;
    }
    const auto number = Number(words.items[i]);
    if (!number) return Fail(number);
    numbers.push_back(*number);
  }
  Camera camera;
  camera.eye = {numbers[0], numbers[1], numbers[2]};
  camera.target = {numbers[3], numbers[4], numbers[5]};
  camera.vertical_fov = Angle::Degrees(numbers[6]);
  camera.width_px = numbers[7];
  camera.height_px = numbers[8];
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  return SetView{camera};
}

Result<Command> ParsePick(const Words& words) {
  if (words.items.size() < 2 || words.items.size() > 3) return Usage("pick 1 extrude");
  const auto number = Number(words.items[1]);
  if (!number) return Fail(number);
  if (*number < 1 || *number > 1000 || *number != std::floor(*number)) {
    return Fail(ErrorCode::kBadNumber, "suggestions are numbered from 1");
  }
  return Pick{static_cast<int>(*number),
              std::string(words.items.size() == 3 ? words.items[2] : std::string_view())};
}

Result<Command> ParseSetNumber(const Words& words) {
  if (words.items.size() < 3) return Usage("set distance 12");
  // The dial's name is the first word; a length may have blanks before its unit.
  const std::string_view dial = words.items[1];
  const auto value = ParseLength(words.rest.substr(dial.size()));
  if (!value) return Fail(value);
  return SetNumber{std::string(dial), *value};
}

Result<Command> ParseRuleText(const Words& words) {
  const auto text = [](const Json& object, const char* key) -> const std::string* {
    const auto found = object.find(key);
    return found != object.end() ? found->get_ptr<const std::string*>() : nullptr;
  };
  const auto json = words.rest.empty() ? Json() : ParseJson(words.rest);
  if (!json) return Fail(json);
  if (json->is_object() && text(*json, "file") != nullptr && text(*json, "text") != nullptr) {
    return SetRuleText{*text(*json, "file"), *text(*json, "text")};
  }
  return Usage(R"~(rule-text {"file":"house.cga","text":"Lot --> extrude(9)"})~");
}

Result<Command> ParseLayers(const Words& words) {
  if (words.rest.empty()) return Usage(R"(layers {"off":["Facade.door"]})");
  auto layers = LayerEditsFrom(words.rest);
  if (!layers) return Fail(layers);
  return EditLayers{std::move(*layers)};
}

/// NAME and what becomes of it; the name is all that stands before that.
Result<Command> ParseLayer(const Words& words) {
  using How = ChangeLayer::How;
  constexpr std::pair<std::string_view, How> kHow[] = {{"off", How::kOff},
                                                       {"on", How::kOn},
                                                       {"up", How::kUp},
                                                       {"down", How::kDown},
                                                       {"as-written", How::kGets}};
  const size_t count = words.items.size();
  const auto name = [&](size_t following) {
    const std::string_view last = words.items[count - following - 1];
    return std::string(words.rest.data(), last.data() + last.size());
  };
  if (count >= 4 && words.items[count - 2] == "gets") {
    return ChangeLayer{name(2), How::kGets, std::string(words.items[count - 1])};
  }
  for (const auto& [word, how] : kHow) {
    if (count >= 3 && words.items[count - 1] == word) return ChangeLayer{name(1), how};
  }
  return Usage("layer Facade.door off");
}

/// NAME and pairs of a word and a number; the name is all that stands before them.
Result<Command> ParsePlace(const Words& words) {
  constexpr std::string_view kExample = "place Door left 16.5 bottom 1.22";
  PlaceElement place;
  const std::pair<std::string_view, std::optional<double>*> fields[] = {{"left", &place.left},
                                                                        {"bottom", &place.bottom},
                                                                        {"width", &place.width},
                                                                        {"height", &place.height}};
  size_t first = words.items.size();  // of the pairs, from the last one on
  while (first >= 4) {
    const auto field = std::find_if(std::begin(fields), std::end(fields), [&](const auto& one) {
      return one.first == words.items[first - 2];
    });
    if (field == std::end(fields) || *field->second) break;
    const auto number = Number(words.items[first - 1]);
    if (!number) return Fail(number);
    *field->second = *number;
    first -= 2;
  }
  if (first == words.items.size()) return Usage(kExample);
  const char* end = words.items[first - 1].data() + words.items[first - 1].size();
  place.element.assign(words.rest.data(), end);
  return place;
}

Result<Command> ParseTake(const Words& words) {
  if (words.items.size() != 2) return Usage("take 0/1");
  if (words.items[1] == kNone) return Take{};
  auto path = ParseNodePath(words.items[1]);
  if (!path) return Fail(path);
  return Take{std::move(*path)};
}

Result<Command> ParseSwitch(const Words& words) {
  if (words.items.size() != 3 || (words.items[2] != "on" && words.items[2] != "off")) {
    return Usage("switch 0/1 off");
  }
  auto path = ParseNodePath(words.items[1]);
  if (!path) return Fail(path);
  return Switch{std::move(*path), words.items[2] == "on"};
}

Result<Command> ParseMove(const Words& words) {
  if (words.items.size() != 4 || words.items[2] != "to") return Usage("move 0/2 to 0/0/1");
  auto from = ParseNodePath(words.items[1]);
  if (!from) return Fail(from);
  auto to = ParseNodePath(words.items[3]);
  if (!to) return Fail(to);
  return Move{std::move(*from), std::move(*to)};
}

Result<Command> ParseDelete(const Words& words) {
  if (words.items.size() != 2) return Usage("delete 0/1");
  auto path = ParseNodePath(words.items[1]);
  if (!path) return Fail(path);
  return Delete{std::move(*path)};
}

Result<Command> ParseRenameTree(const Words& words) {
  if (words.items.size() < 3) return Usage("rename-tree 0 structure");
  const auto path = ParseNodePath(words.items[1]);
  if (!path || path->size() != 1) return Usage("rename-tree 0 structure");
  std::string_view name = words.rest.substr(words.items[1].size());
  name.remove_prefix(name.find_first_not_of(kSpace));
  return RenameTree{path->front(), std::string(name)};
}

Result<Command> ParseErase(const Words& words) {
  if (words.items.size() < 2) return Usage("erase 3 4");
  Erase erase;
  for (size_t i = 1; i < words.items.size(); ++i) {
    const auto number = Count(words.items[i]);
    if (!number) return Fail(number);
    erase.strokes.push_back(*number);
  }
  return erase;
}

Result<Command> ParseSelect(const Words& words) {
  if (words.items.size() < 2) return Usage("select 0/2/5");
  if (words.rest == kNone) return Select{};
  return Select{{words.items.begin() + 1, words.items.end()}};
}

/// A command whose argument is all the rest of the line.
template <typename C>
Result<Command> OfRest(const Words& words, std::string_view example) {
  if (words.rest.empty()) return Usage(example);
  return C{std::string(words.rest)};
}

/// "WORD FROM TO"
template <typename C>
Result<Command> OfTwoNames(const Words& words, std::string_view example) {
  if (words.items.size() != 3) return Usage(example);
  return C{std::string(words.items[1]), std::string(words.items[2])};
}

struct Row {
  std::string_view word;
  Result<Command> (*parse)(const Words&);
};

constexpr std::array kRows = {
    Row{"lot", [](const Words& w) { return OfRest<SetLot>(w, "lot rect(20,14)"); }},
    Row{"view", ParseView},
    Row{"pick", ParsePick},
    Row{"name", [](const Words& w) { return OfTwoNames<RenameSymbol>(w, "name B CenterFloors"); }},
    Row{"rename-symbol",
        [](const Words& w) { return OfTwoNames<RenameEverywhere>(w, "rename-symbol B Floors"); }},
    Row{"query", [](const Words& w) { return OfRest<SetQuery>(w, "query .Facade:north"); }},
    Row{"set", ParseSetNumber},
    Row{"node",
        [](const Words& w) { return OfRest<AddNode>(w, "node .Glass --> color(\"#7f9db5\")"); }},
    Row{"rewrite",
        [](const Words& w) {
          return OfRest<Rewrite>(w, "rewrite tree house { .Lot --> extrude(9) Mass }");
        }},
    Row{"rule-text", ParseRuleText},
    Row{"layers", ParseLayers},
    Row{"layer", ParseLayer},
    Row{"place", ParsePlace},
    Row{"take", ParseTake},
    Row{"switch", ParseSwitch},
    Row{"move", ParseMove},
    Row{"delete", ParseDelete},
    Row{"tree", [](const Words& w) { return OfRest<AddTree>(w, "tree ornaments"); }},
    Row{"rename-tree", ParseRenameTree},
    Row{"keep-view", [](const Words& w) { return OfRest<KeepView>(w, "keep-view corner"); }},
    Row{"go-view", [](const Words& w) { return OfRest<GoView>(w, "go-view corner"); }},
    Row{"drop-view", [](const Words& w) { return OfRest<DropView>(w, "drop-view corner"); }},
    Row{"erase", ParseErase},
    Row{"select", ParseSelect},
    Row{"clear", [](const Words&) -> Result<Command> { return ClearSketch{}; }},
    Row{"undo", [](const Words&) -> Result<Command> { return Undo{}; }},
    Row{"redo", [](const Words&) -> Result<Command> { return Redo{}; }},
};

}  // namespace

Result<Command> ParseCommand(std::string_view line) {
  const Words words = Split(line);
  if (words.items.empty()) return Fail(ErrorCode::kBadText, "a command is missing here");
  for (const Row& row : kRows) {
    if (row.word == words.items[0]) return row.parse(words);
  }
  std::vector<std::string> names;
  for (const Row& row : kRows) names.emplace_back(row.word);
  const auto meant = DidYouMean(words.items[0], names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no command '{}'", words.items[0]),
              meant ? fmt::format("did you mean '{}'?", *meant)
                    : fmt::format("commands are {}", fmt::join(names, ", ")));
}

bool IsLooking(const Command& command) {
  return std::holds_alternative<SetView>(command) || std::holds_alternative<GoView>(command) ||
         std::holds_alternative<Take>(command);
}

}  // namespace parti::app
