#include "sketch/symbols.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "grammar/operation.h"
#include "sketch/actions.h"

namespace parti::sketch {
namespace {

constexpr double kUpright = 0.7071;  // errata 10: 45 degrees tell up from the four winds

bool LiesFlat(const grammar::Item& item) {
  return item.type == grammar::ItemType::kPlanar && std::abs(item.scope.z.y) >= kUpright;
}

bool IsUpright(const grammar::Item& item, const grammar::Action& action) {
  return std::abs(item.scope.axis(static_cast<int>(AxisOf(action))).y) >= kUpright;
}

std::string NameOfPart(size_t i, size_t count, bool upright) {
  constexpr std::array<const char*, 3> kUp = {"Lower", "Middle", "Upper"};
  constexpr std::array<const char*, 3> kAcross = {"Left", "Middle", "Right"};
  if (count > 3) return fmt::format("Part{}", i + 1);
  const size_t place = count == 2 && i == 1 ? 2 : i;
  return (upright ? kUp : kAcross)[place];
}

std::string NameOfComponent(grammar::Selector::Kind kind, bool flat) {
  using Kind = grammar::Selector::Kind;
  switch (kind) {
    case Kind::kTop:
      return "Roof";
    case Kind::kBottom:
      return "Base";
    case Kind::kSide:
    case Kind::kVertical:
    case Kind::kFront:
    case Kind::kBack:
    case Kind::kLeft:
    case Kind::kRight:
      return "Facade";
    case Kind::kInside:
      return flat ? "RoofInner" : "Inner";
    case Kind::kBorder:
      return flat ? "RoofBorder" : "Border";
    case Kind::kShape:
      return "Wings";
    case Kind::kRemainder:
      return flat ? "Yard" : "Rest";
    default:
      return "Face";
  }
}

void NameParts(const std::vector<std::vector<size_t>>& equal, bool upright,
               grammar::Action* action) {
  auto& parts = action->successors;
  for (size_t i = 0; i < parts.size(); ++i) {
    parts[i].symbol = NameOfPart(i, parts.size(), upright);
  }
  for (const std::vector<size_t>& group : equal) {
    if (group.size() == parts.size()) parts[group.front()].symbol = "Part";
    for (const size_t i : group) {
      if (i < parts.size()) parts[i].symbol = parts[group.front()].symbol;
    }
  }
}

void NameSuccessor(const grammar::Item& item, std::string_view word, size_t number, bool upright,
                   grammar::Successor* successor) {
  for (grammar::Successor& repeated : successor->repeat) {
    repeated.symbol = upright ? "Floor" : "Tile";
  }
  if (!successor->repeat.empty()) return;
  if (const auto* selector = std::get_if<grammar::Selector>(&successor->key)) {
    successor->symbol = NameOfComponent(selector->kind, LiesFlat(item));
  } else {
    successor->symbol = fmt::format("{}{}", word, number + 1);
  }
}

}  // namespace

void NameProducts(const grammar::Item& item, const std::vector<std::vector<size_t>>& equal,
                  grammar::Action* action) {
  const std::string_view name = action->operation->name;
  const bool upright = IsUpright(item, *action);
  if (action->successors.empty()) {
    action->symbol = name != "extrude" ? std::string(action->operation->word)
                     : LiesFlat(item)  ? "Mass"
                                       : "Block";
  } else if (name == "split") {
    NameParts(equal, upright, action);
  } else if (name == "repeat") {
    for (grammar::Successor& s : action->successors) s.symbol = upright ? "Floor" : "Tile";
  } else {
    for (size_t i = 0; i < action->successors.size(); ++i) {
      NameSuccessor(item, action->operation->word, i, upright, &action->successors[i]);
    }
  }
}

}  // namespace parti::sketch
