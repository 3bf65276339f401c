#include "grammar/action.h"

#include <array>

namespace parti::grammar {
namespace {

constexpr std::array<std::string_view, 33> kSelectorNames = {
    "all",      "front",        "back",        "left",        "right",        "top",
    "bottom",   "side",         "vertical",    "horizontal",  "index",        "inside",
    "border",   "street.front", "street.back", "street.left", "street.right", "street.side",
    "shape",    "remainder",    "aslant",      "nutant",      "eave",         "hip",
    "valley",   "ridge",        "world.south", "world.north", "world.west",   "world.east",
    "world.up", "world.down",   "world.side"};

}  // namespace

// Written out: clang 16 crashes on defaulted comparisons of types that contain each other.
bool Successor::operator==(const Successor& other) const {
  return key == other.key && actions == other.actions && symbol == other.symbol &&
         deferred == other.deferred && repeat == other.repeat;
}

bool Action::operator==(const Action& other) const {
  return operation == other.operation && arguments == other.arguments &&
         successors == other.successors && symbol == other.symbol;
}

std::string_view NameOf(Axis axis) {
  constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
  return kNames[static_cast<size_t>(axis)];
}

std::string_view NameOf(Selector::Kind kind) { return kSelectorNames[static_cast<size_t>(kind)]; }

std::optional<Selector::Kind> SelectorNamed(std::string_view name) {
  for (size_t i = 0; i < kSelectorNames.size(); ++i) {
    const auto kind = static_cast<Selector::Kind>(i);
    if (kSelectorNames[i] == name && kind != Selector::Kind::kIndex) return kind;
  }
  return std::nullopt;
}

std::vector<std::string_view> SelectorNames() {
  std::vector<std::string_view> names(kSelectorNames.begin(), kSelectorNames.end());
  names.erase(names.begin() + static_cast<std::ptrdiff_t>(Selector::Kind::kIndex));
  return names;
}

}  // namespace parti::grammar
