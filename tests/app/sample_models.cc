#include "tests/app/sample_models.h"

#include <gtest/gtest.h>

#include <map>

#include "grammar/operation.h"
#include "grammar/selection_action.h"

namespace parti::app::tests {
namespace {

using grammar::Item;
using grammar::ShapeTree;

Item Flat(const std::vector<std::vector<Vec3>>& rings) {
  const Vec3 up(0, 1, 0);
  auto item = grammar::PlanarFrom(rings, &up);
  EXPECT_TRUE(item) << FormatError(item.error());
  return item.value_or(Item{});
}

Item Extruded(const Item& base, double height_m) {
  grammar::Action action = grammar::Default(*grammar::FindOperation("extrude"));
  action.arguments[0] = height_m;
  auto products = grammar::Apply(action, base);
  EXPECT_TRUE(products) << FormatError(products.error());
  return products ? (*products)[0].item : Item{};
}

/// About the y axis by 30 degrees.
Vec3 Turned(double x, double z) { return {0.8660254 * x + 0.5 * z, 0, -0.5 * x + 0.8660254 * z}; }

Item LWithCourtyard() {
  std::vector<Vec3> outline, court;
  for (const auto& [x, z] :
       {std::pair(0.1, 0.3), {14.3, 0.3}, {14.3, 6.1}, {9.7, 6.1}, {9.7, 12.9}, {0.1, 12.9}}) {
    outline.push_back(Turned(x, z));
  }
  for (const auto& [x, z] : {std::pair(2.1, 2.2), {7.3, 2.2}, {7.3, 9.4}, {2.1, 9.4}}) {
    court.push_back(Turned(x, z));
  }
  return Flat({outline, court});
}

}  // namespace

ShapeTree Courtyard() {
  const auto rect = [](double x, double z, double w, double d) {
    return Flat({{{x, 0, z}, {x + w, 0, z}, {x + w, 0, z + d}, {x, 0, z + d}}});
  };
  ShapeTree tree(rect(-6, -14, 30, 34));
  const auto add = [&tree](Item item, const char* symbol) {
    tree.Append(0, std::move(item), tree.Intern(symbol), nullptr);
  };
  add(rect(-6, -14, 30, 34), "Garden");
  Item body = Extruded(LWithCourtyard(), 7.3);
  body.color_rgb = 0xC8A084;
  add(body, "Mass");
  add(Extruded(rect(17.1, 1.3, 3.3, 3.1), 2.9), "Shed");
  add(Extruded(rect(17.1, 4.4, 3.3, 3.1), 4.1), "Shed");
  add(Flat({{{17, 0, 12}, {21, 0, 12}, {19, 0, 16}}}), "Sign");
  return tree;
}

ShapeTree TownHouse() {
  constexpr std::string_view kTree = R"(tree house {
    .Lot --> offset(-2) { inside: Footprint | border: Garden }
    .Footprint --> extrude(11.2) Mass
    .Mass --> comp(f) { side: Facade | top: Roof }
    .Facade --> split(y) { 3.8: Ground | { ~3.2: Floor }* | 0.6: Parapet }
    .Floor --> split(x) { ~1: Wall | { ~2.6: Bay }* | ~1: Wall }
    .Bay --> split(x) { ~1: Wall | 1.3: Column | ~1: Wall }
    .Column --> split(y) { 0.7: Wall | ~1: Window | 0.5: Wall }
    .Window --> extrude(-0.2) Glass
    .Ground --> split(x) { ~1: Wall | 1.6: DoorColumn | ~1: Wall | ~2: Shop | ~1: Wall }
    .Shop --> split(y) { 0.5: Wall | ~1: Window | 0.6: Wall }
    .DoorColumn --> split(y) { 2.5: Door | ~1: Wall }
    .Door --> extrude(0.15) Leaf
    .Roof --> offset(-1.8) { inside: Attic | border: Terrace }
    .Attic --> extrude(2.8) Storey
  })";
  const auto trees = grammar::ParseTrees(kTree);
  EXPECT_TRUE(trees) << FormatError(trees.error()[0]);
  const Vec3 up(0, 1, 0);
  const Item lot = *grammar::PlanarFrom({{{0, 0, 0}, {20, 0, 0}, {20, 0, 15}, {0, 0, 15}}}, &up);
  const auto derived = grammar::Derive(*trees, ShapeTree(lot));
  EXPECT_TRUE(derived) << FormatError(derived.error());
  return derived->tree;
}

double SignedVolume(const std::vector<Vec3>& corners) {
  double six = 0;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    six += glm::dot(corners[i], glm::cross(corners[i + 1], corners[i + 2]));
  }
  return six / 6;
}

bool IsClosed(const std::vector<Vec3>& points, const std::vector<uint32_t>& triangles) {
  // By position: faces of different normals name their corners apart.
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<Vec3, int, decltype(less)> number(less);
  std::map<std::pair<int, int>, int> balance;
  const auto at = [&](uint32_t i) {
    return number.emplace(points[i], static_cast<int>(number.size())).first->second;
  };
  for (size_t i = 0; i < triangles.size(); ++i) {
    const int a = at(triangles[i]), b = at(triangles[i % 3 == 2 ? i - 2 : i + 1]);
    balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  }
  for (const auto& [edge, sum] : balance) {
    if (sum != 0) return false;
  }
  return !triangles.empty();
}

}  // namespace parti::app::tests
