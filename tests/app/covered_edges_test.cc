// Which edges a roof covers, and which stay open.
#include "app/covered_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "grammar/action_text.h"
#include "grammar/operation.h"
#include "tests/grammar/geometry_support.h"

namespace parti::app {
namespace {

using grammar::Item;
using grammar::ShapeIndex;
using grammar::ShapeTree;

/// The leaves under a lot, as they are given.
ShapeTree TreeOf(const std::vector<Item>& items) {
  ShapeTree tree(grammar::tests::Lot("0,0 10,0 10,8 0,8"));
  for (const Item& item : items) tree.Append(0, item, grammar::kNoName, nullptr);
  return tree;
}

SortedEdges Sorted(const std::vector<Item>& items) {
  const ShapeTree tree = TreeOf(items);
  return SortEdges(tree, tree.Leaves());
}

double LengthOf(const std::vector<Segment3>& edges) {
  double length = 0;
  for (const Segment3& edge : edges) length += glm::distance(edge.a, edge.b);
  return length;
}

double CoveredLength(const SortedEdges& edges) {
  double length = 0;
  for (const CoveredEdges& covered : edges.covered) length += LengthOf(covered.edges);
  return length;
}

std::vector<Item> Made(const std::string& action, const Item& item) {
  const auto products = grammar::Apply(grammar::ParseAction(action).value(), item);
  EXPECT_TRUE(products) << FormatError(products.error());
  std::vector<Item> items;
  for (const grammar::Product& product : *products) items.push_back(product.item);
  return items;
}

/// Upright walls of 10 x 8 m, 3 m high, and the roof over them as one body.
std::vector<Item> House(const std::string& roof) {
  const Item mass = Made("extrude(3) Mass", grammar::tests::Lot("0,0 10,0 10,8 0,8"))[0];
  std::vector<Item> items;
  for (const Item& face : grammar::FacesOf(mass)) {
    if (std::abs(face.scope.z.y) < 0.5) items.push_back(face);
    if (face.scope.z.y > 0.5) items.push_back(Made(roof, face)[0]);
  }
  return items;
}

TEST(SortEdges, WallsEndUnderARoofThatRunsOnBeyondThem) {
  const SortedEdges edges = Sorted(House("roofHip(35, 0.8) Roof"));
  ASSERT_EQ(edges.covered.size(), 4u);
  for (const CoveredEdges& covered : edges.covered) {
    EXPECT_GT(covered.normal.y, 0.5);
    for (const Segment3& edge : covered.edges) {
      EXPECT_NEAR(edge.a.y, 3, 1e-6);
      EXPECT_NEAR(edge.b.y, 3, 1e-6);
    }
  }
  EXPECT_NEAR(CoveredLength(edges), 2 * (10 + 8), 0.1);
  EXPECT_EQ(edges.covered_shapes.size(), 4u) << "the walls";
}

TEST(SortEdges, WallsThatMeetTheEavesAreOpen) {
  EXPECT_TRUE(Sorted(House("roofHip(35) Roof")).covered.empty());
  EXPECT_TRUE(Sorted(House("extrude(0.3) Slab")).covered.empty());
}

TEST(SortEdges, ARoofOfSheetsCoversAsItsBodyDoes) {
  std::vector<Item> items = House("roofHip(35, 0.8) Roof");
  std::vector<Item> sheets;
  for (const Item& item : items) {
    for (const Item& face : grammar::FacesOf(item)) sheets.push_back(face);
  }
  EXPECT_NEAR(CoveredLength(Sorted(sheets)), CoveredLength(Sorted(items)), 1e-6);
}

TEST(SortEdges, CornersOfWallsEndBelowARoofsPlane) {
  const SortedEdges edges = Sorted(House("roofGable(40, 0.6, 0.4) Roof"));
  ASSERT_FALSE(edges.covered.empty());
  for (const Segment3& edge : edges.open) {
    if (std::abs(edge.a.y - edge.b.y) < 2) continue;  // upright ones of walls
    if (glm::length(Vec2(edge.a.x - edge.b.x, edge.a.z - edge.b.z)) > 1e-6) continue;
    EXPECT_LT(std::max(edge.a.y, edge.b.y), 2.96);
  }
}

TEST(SortEdges, WhatStandsOnARoofIsOpen) {
  const Item flat = grammar::tests::Lot("0,0 10,0 10,8 0,8");
  const Item box = Made("extrude(2) Attic", grammar::tests::Lot("2,2 5,2 5,5 2,5"))[0];
  EXPECT_TRUE(Sorted({flat, box}).covered.empty());
  std::vector<Item> walls = {flat};
  for (const Item& face : grammar::FacesOf(box)) walls.push_back(face);
  EXPECT_TRUE(Sorted(walls).covered.empty());
}

TEST(SortEdges, EdgesAreCutWhereTheFaceEnds) {
  // A wall of 10 m below ground under a sheet of 4 m, with a hole of 1 m over the wall.
  const Vec3 up(0, 1, 0);
  const Item wall = *grammar::PlanarFrom({{{0, -3, 0}, {10, -3, 0}, {10, 0, 0}, {0, 0, 0}}});
  const Item sheet = *grammar::PlanarFrom({{{2, 0, 3}, {6, 0, 3}, {6, 0, -3}, {2, 0, -3}},
                                           {{3, 0, 1}, {3, 0, -1}, {4, 0, -1}, {4, 0, 1}}},
                                          &up);
  const SortedEdges edges = Sorted({wall, sheet});
  ASSERT_EQ(edges.covered.size(), 1u);
  EXPECT_NEAR(CoveredLength(edges), 3, 1e-9);
  const double all = LengthOf(grammar::EdgesOf(wall)) + LengthOf(grammar::EdgesOf(sheet));
  EXPECT_NEAR(CoveredLength(edges) + LengthOf(edges.open), all, 1e-9);
  EXPECT_NEAR(edges.covered[0].normal.y, 1, 1e-9);
}

TEST(SortEdges, WithoutFacesThatLookUpEdgesComeInTheirOrder) {
  const std::vector<Item> boxes = {Made("extrude(2) A", grammar::tests::Lot("0,0 1,0 1,1 0,1"))[0],
                                   Made("extrude(3) A", grammar::tests::Lot("2,0 3,0 3,1 2,1"))[0]};
  const SortedEdges edges = Sorted(boxes);
  std::vector<Segment3> own;
  for (const Item& box : boxes) grammar::EdgesOf(box, &own);
  ASSERT_EQ(edges.open.size(), own.size());
  for (size_t i = 0; i < own.size(); ++i) {
    EXPECT_EQ(edges.open[i].a, own[i].a);
    EXPECT_EQ(edges.open[i].b, own[i].b);
  }
}

}  // namespace
}  // namespace parti::app
