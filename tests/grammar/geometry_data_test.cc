// Every polygon of the real footprints and plots through the whole table: what goes in comes out,
// and what is refused is refused for a reason.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/grammar/geometry_support.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

std::vector<Ring> RingsFrom(const nlohmann::json& json) {
  std::vector<Ring> rings;
  for (const auto& ring : json.at("rings")) {
    rings.emplace_back();
    for (const auto& p : ring) rings.back().emplace_back(p.at(0), p.at(1));
  }
  return rings;
}

double AreaOf(const std::vector<Product>& products) {
  double sum = 0;
  for (const Product& p : products) sum += grammar::AreaOf(p.item);
  return sum;
}

void ExpectSplitTiles(const Item& item, Axis axis) {
  const bool is_volume = item.type == ItemType::kVolume;
  const double whole = is_volume ? VolumeOf(item) : grammar::AreaOf(item);
  const auto parts =
      Apply(Split(axis, {Metres(1.5, "A"), Group({Floating(2.5, "B")}), Share(0.125, "C")}), item);
  ASSERT_TRUE(parts.has_value()) << parts.error().message;
  double sum = 0;
  for (const Product& p : *parts) {
    sum += is_volume ? VolumeOf(p.item) : grammar::AreaOf(p.item);
    EXPECT_EQ(is_volume ? OpenEdges(MeshOf(p.item)) : 0, 0);
  }
  EXPECT_NEAR(sum, whole, 1e-7 * (1 + whole));
}

void ExpectFacesFit(const Item& mass, const Item& lot, double height) {
  const auto faces = Apply(AllFaces(), mass);
  ASSERT_TRUE(faces.has_value());
  EXPECT_NEAR(AreaOf(*faces), grammar::AreaOf(mass), 1e-6);
  const Action by_side =
      Comp({Selected(Selector::Kind::kTop, "Roof"), Selected(Selector::Kind::kSide, "Facade")});
  double perimeter = 0;
  for (const Segment3& edge : EdgesOf(lot)) perimeter += glm::distance(edge.a, edge.b);
  double roofs = 0, facades = 0;
  const auto sides = Apply(by_side, mass);
  ASSERT_TRUE(sides.has_value());
  for (const Product& p : *sides) {
    (p.successor == 0 ? roofs : facades) += grammar::AreaOf(p.item);
  }
  EXPECT_NEAR(roofs, grammar::AreaOf(lot), 1e-6);
  EXPECT_NEAR(facades, perimeter * height, 1e-6 * perimeter * height);
}

void ExpectOffsetFits(const Item& lot, double distance) {
  const auto parts = Apply(OffsetBy(distance), lot);
  ASSERT_TRUE(parts.has_value()) << parts.error().message;
  double inside = 0, border = 0;
  for (const Product& p : *parts) {
    (p.successor == 0 ? inside : border) += grammar::AreaOf(p.item);
    std::vector<Vec3> corners;
    TrianglesOf(p.item, &corners);
    double triangles = 0;
    for (size_t i = 0; i + 2 < corners.size(); i += 3) {
      triangles +=
          glm::length(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i])) / 2;
    }
    EXPECT_NEAR(triangles, grammar::AreaOf(p.item), 1e-6);
  }
  const double whole = grammar::AreaOf(lot);
  EXPECT_NEAR(distance < 0 ? inside + border : inside - border, whole, 1e-6 * (1 + whole));
  EXPECT_EQ(inside > whole, distance > 0);
}

void ExpectAllFits(const Item& lot) {
  const double height = 9;
  const auto mass = Apply(Extrude(height), lot);
  ASSERT_TRUE(mass.has_value());
  const Item& volume = mass->front().item;
  EXPECT_NEAR(VolumeOf(volume), height * grammar::AreaOf(lot), 1e-6);
  EXPECT_EQ(OpenEdges(MeshOf(volume)), 0);
  ExpectFacesFit(volume, lot, height);
  for (const Axis axis : {Axis::kX, Axis::kY}) ExpectSplitTiles(lot, axis);
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) ExpectSplitTiles(volume, axis);
  for (const double distance : {-0.5, -2.0, 1.0}) ExpectOffsetFits(lot, distance);
}

/// `refused`: how many lines of the file are no simple polygons, each of which must say where.
void ExpectFileFits(const std::string& path, int lines, int refused) {
  std::ifstream file(path);
  std::string line;
  int read = 0, not_simple = 0;
  while (std::getline(file, line)) {
    if (line.empty()) continue;
    ++read;
    const auto json = nlohmann::json::parse(line);
    const std::string id = json.at("id");
    SCOPED_TRACE(id);
    const auto lot = LotFrom(RingsFrom(json));
    if (lot) {
      ExpectAllFits(*lot);
      continue;
    }
    ++not_simple;
    EXPECT_EQ(lot.error().code, ErrorCode::kSelfIntersecting) << lot.error().message;
    EXPECT_NE(lot.error().message.find(" at ("), std::string::npos) << lot.error().message;
    std::cout << id << ": " << lot.error().message << "\n";
  }
  EXPECT_EQ(read, lines);
  EXPECT_EQ(not_simple, refused);
}

TEST(RealPolygons, Footprints) {
  PARTI_NEED_DATA(path, "buildings/footprints-dev.jsonl");
  ExpectFileFits(path, 72, 0);
}

TEST(RealPolygons, Plots) {
  PARTI_NEED_DATA(path, "buildings/plots-dev.jsonl");
  ExpectFileFits(path, 204, 0);
}

}  // namespace
}  // namespace parti::grammar::tests
