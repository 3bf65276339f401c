// Shapes and checks that the geometry tests share.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grammar/operation.h"

namespace parti::grammar::tests {

inline Ring RingFrom(std::initializer_list<Vec2> corners) { return Ring(corners); }

/// "0,0 10,0 10,8": corners apart by blanks.
inline Ring RingFrom(const std::string& text) {
  Ring ring;
  const char* at = text.c_str();
  while (*at != '\0') {
    char* end = nullptr;
    const double x = std::strtod(at, &end);
    const double y = std::strtod(end + 1, &end);
    ring.emplace_back(x, y);
    at = end;
    while (*at == ' ') ++at;
  }
  return ring;
}

/// A lot in the world's ground plane from rings of (east, north): x = east, z = -north.
inline Result<Item> LotFrom(const std::vector<Ring>& rings) {
  std::vector<std::vector<Vec3>> world;
  for (const Ring& ring : rings) {
    world.emplace_back();
    for (const Vec2& p : ring) world.back().emplace_back(p.x, 0.0, -p.y);
  }
  const Vec3 up(0, 1, 0);
  return PlanarFrom(world, &up);
}
inline Item Lot(const std::string& outline) { return LotFrom({RingFrom(outline)}).value(); }

inline Successor Sized(Size::Kind kind, double value, std::string symbol) {
  Successor s;
  s.key = Size{kind, value};
  s.symbol = std::move(symbol);
  return s;
}
inline Successor Metres(double value, std::string symbol) {
  return Sized(Size::Kind::kAbsolute, value, std::move(symbol));
}
inline Successor Share(double value, std::string symbol) {
  return Sized(Size::Kind::kRelative, value, std::move(symbol));
}
inline Successor Floating(double value, std::string symbol) {
  return Sized(Size::Kind::kFloating, value, std::move(symbol));
}
inline Successor Group(std::vector<Successor> pattern) {
  Successor s;
  s.repeat = std::move(pattern);
  return s;
}
inline Successor Selected(Selector::Kind kind, std::string symbol, int index = 0) {
  Successor s;
  s.key = Selector{kind, index};
  s.symbol = std::move(symbol);
  return s;
}

inline Action Make(std::string_view operation, std::vector<Argument> arguments,
                   std::vector<Successor> successors = {}, std::string symbol = {}) {
  Action action;
  action.operation = FindOperation(operation);
  action.arguments = std::move(arguments);
  const auto parameters = action.operation->parameters;
  for (size_t i = action.arguments.size(); i < parameters.size(); ++i) {
    if (!parameters[i].required) action.arguments.push_back(parameters[i].default_value);
  }
  action.successors = std::move(successors);
  action.symbol = std::move(symbol);
  return action;
}
inline Action Extrude(double distance) { return Make("extrude", {distance}, {}, "Mass"); }
inline Action Split(Axis axis, std::vector<Successor> sizes) {
  return Make("split", {axis}, std::move(sizes));
}
inline Action Repeat(Axis axis, std::vector<Successor> pattern) {
  return Make("repeat", {axis}, std::move(pattern));
}
inline Action Comp(std::vector<Successor> faces) {
  return Make("comp", {std::string("f")}, std::move(faces));
}
inline Action AllFaces() { return Comp({Selected(Selector::Kind::kAll, "Face")}); }
inline Action OffsetBy(double distance) {
  return Make(
      "offset", {distance},
      {Selected(Selector::Kind::kInside, "Inside"), Selected(Selector::Kind::kBorder, "Border")});
}

/// Sizes of the products along a scope axis.
inline std::vector<double> SizesOf(const std::vector<Product>& products, int axis) {
  std::vector<double> sizes;
  for (const Product& p : products) sizes.push_back(p.item.scope.size[axis]);
  return sizes;
}

/// Directed edges that are not matched by exactly one the other way round: 0 when watertight.
inline int OpenEdges(const Mesh& mesh) {
  std::map<std::pair<uint32_t, uint32_t>, int> count;
  const auto add = [&](const std::vector<uint32_t>& loop) {
    for (size_t i = 0; i < loop.size(); ++i) ++count[{loop[i], loop[(i + 1) % loop.size()]}];
  };
  for (const MeshFace& face : mesh.faces) {
    add(face.loop);
    for (const auto& hole : face.holes) add(hole);
  }
  int open = 0;
  for (const auto& [edge, times] : count) {
    const auto back = count.find({edge.second, edge.first});
    if (back == count.end() || back->second != times) ++open;
  }
  return open;
}

}  // namespace parti::grammar::tests
