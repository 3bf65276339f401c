#include "app/command.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <span>

namespace parti::app {
namespace {

/// The words of a line, and what follows the first one, untouched.
struct Words {
  std::vector<std::string_view> items;
  std::string_view rest;
};

Words Split(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r";
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
  if (words.items.size() != 3) return Usage("set distance 12");
  const auto number = Number(words.items[2]);
  if (!number) return Fail(number);
  return SetNumber{std::string(words.items[1]), *number};
}

struct Row {
  std::string_view word;
  Result<Command> (*parse)(const Words&);
};

constexpr std::array kRows = {
    Row{"lot",
        [](const Words& w) -> Result<Command> {
          if (w.rest.empty()) return Usage("lot rect(20,14)");
          return SetLot{std::string(w.rest)};
        }},
    Row{"view", ParseView},
    Row{"pick", ParsePick},
    Row{"name",
        [](const Words& w) -> Result<Command> {
          if (w.items.size() != 3) return Usage("name B CenterFloors");
          return RenameSymbol{std::string(w.items[1]), std::string(w.items[2])};
        }},
    Row{"query",
        [](const Words& w) -> Result<Command> {
          if (w.rest.empty()) return Usage("query .Facade:north");
          return SetQuery{std::string(w.rest)};
        }},
    Row{"set", ParseSetNumber},
    Row{"node",
        [](const Words& w) -> Result<Command> {
          if (w.rest.empty()) return Usage("node .Glass --> color(\"#7f9db5\")");
          return AddNode{std::string(w.rest)};
        }},
    Row{"clear", [](const Words&) -> Result<Command> { return ClearSketch{}; }},
    Row{"undo", [](const Words&) -> Result<Command> { return Undo{}; }},
    Row{"redo", [](const Words&) -> Result<Command> { return Redo{}; }},
};

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>  // clang 16 can't work it out
Overloaded(Cases...) -> Overloaded<Cases...>;

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
          [](const SetQuery& c) { return "query " + c.query; },
          [](const SetNumber& c) { return fmt::format("set {} {}", c.dial, c.value); },
          [](const AddNode& c) { return "node " + c.text; },
          [](const ClearSketch&) { return std::string("clear"); },
          [](const Undo&) { return std::string("undo"); },
          [](const Redo&) { return std::string("redo"); },
      },
      command);
}

}  // namespace parti::app
