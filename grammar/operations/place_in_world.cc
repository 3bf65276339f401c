// translate and rotate(mode, system, x, y, z): a shape moved and turned along the scope's or the
// world's axes. The scope's own, shorter forms are translate.cc's and rotate.cc's.
#include <array>

#include "grammar/item_place.h"
#include "grammar/operations/row_parts.h"
#include "grammar/reframe.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kRelative = "rel", kAbsolute = "abs";
constexpr std::string_view kScope = "scope", kPivot = "pivot", kWorld = "world", kObject = "object";

bool Is(const Action& action, size_t argument, std::string_view word) {
  return std::get<std::string>(action.arguments[argument]) == word;
}

/// A lot's own axes are the world's.
bool InWorld(const Action& action) { return Is(action, 1, kWorld) || Is(action, 1, kObject); }

Vec3 VectorOf(const Action& action) {
  return {std::get<double>(action.arguments[2]), std::get<double>(action.arguments[3]),
          std::get<double>(action.arguments[4])};
}

Result<std::vector<Product>> ApplyMove(const Item& item, const Action& action) {
  Scope moved = NamedScope(item);
  const Vec3 by = VectorOf(action);
  if (Is(action, 0, kRelative)) {
    moved.origin += InWorld(action) ? by : moved.x * by.x + moved.y * by.y + moved.z * by.z;
  } else if (Is(action, 1, kWorld)) {
    moved.origin = by;
  } else {
    return Fail(ErrorCode::kBadArguments, "translate: only a place in the world is absolute",
                "translate(abs, world, x, y, z), or rel for a distance");
  }
  return std::vector<Product>{{Placed(item, moved), -1}};
}

Result<std::vector<Product>> ApplyTurn(const Item& item, const Action& action) {
  const Scope named = NamedScope(item);
  const Vec3 angles_deg = VectorOf(action);
  const Scope world = TurnedAxes(Scope(), angles_deg);
  const auto turn = [&](const Vec3& v) { return world.x * v.x + world.y * v.y + world.z * v.z; };
  Scope turned = TurnedAxes(named, angles_deg);
  if (Is(action, 0, kAbsolute)) {
    turned = world;
  } else if (InWorld(action)) {
    turned.x = turn(named.x);
    turned.y = turn(named.y);
    turned.z = turn(named.z);
  }
  turned.origin = named.origin;
  turned.size = named.size;
  return std::vector<Product>{{Placed(item, turned), -1}};
}

constexpr std::array<std::string_view, 2> kModes = {kRelative, kAbsolute};
constexpr std::array<std::string_view, 4> kSystems = {kScope, kPivot, kObject, kWorld};

Parameter Mode(std::string_view doc) {
  return {.name = "mode",
          .kind = ParameterKind::kWord,
          .default_value = std::string(kRelative),
          .doc = doc,
          .words = kModes};
}

Parameter System() {
  return {.name = "system",
          .kind = ParameterKind::kWord,
          .default_value = std::string(kWorld),
          .doc = "whose axes: the scope's (pivot is the same), or the world's (object, too)",
          .words = kSystems};
}

Parameter Along(std::string_view name) {
  return {.name = name,
          .kind = ParameterKind::kLength,
          .low = -1e6,
          .high = 1e6,
          .default_value = 0.0,
          .doc = "along this axis"};
}

constexpr std::string_view kAboutAxis = "around this axis; x first, then y, then z";

const std::array<Parameter, 5> kMoveParameters = {Mode("rel: by so much; abs: to this place"),
                                                  System(), Along("x"), Along("y"), Along("z")};
const std::array<Parameter, 5> kTurnParameters = {
    Mode("rel: by so much; abs: from the world's axes"), System(),
    TurnParameter("xAngle", kAboutAxis), TurnParameter("yAngle", kAboutAxis),
    TurnParameter("zAngle", kAboutAxis)};

}  // namespace

constinit const Operation kMoveInWorld = {
    .name = "translate",
    .word = "MoveInWorld",
    .doc = "Moves a shape along the axes of its scope or of the world; its scope's origin counts.",
    .source = "CGA",
    .parameters = kMoveParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .sampled = false,
    .apply = ApplyMove,
};

constinit const Operation kTurnInWorld = {
    .name = "rotate",
    .word = "TurnInWorld",
    .doc = "Turns a shape around its scope's origin, about the axes of its scope or of the world.",
    .source = "CGA",
    .parameters = kTurnParameters,
    .takes = kMovable,
    .gives = kMovable,
    .in_place = true,
    .sampled = false,
    .apply = ApplyTurn,
};

}  // namespace parti::grammar
