#include "app/lot.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string ErrorOf(std::string_view text) {
  const auto lots = ParseLots(text);
  return lots ? "no error" : FormatError(lots.error());
}

/// The lots of a file with this content.
Result<std::vector<Lot>> LotsIn(const std::string& content, std::vector<Error>* refused = nullptr) {
  const std::string path = tests::TestFolder() + "/lots.json";
  EXPECT_TRUE(WriteFile(path, content));
  return ParseLots(path, refused);
}

std::string ErrorIn(const std::string& content) {
  const auto lots = LotsIn(content);
  return lots ? "no error" : FormatError(lots.error());
}

std::vector<Vec3> CornersOf(const Lot& lot) {
  std::vector<Vec3> corners;
  for (const Vec2& p : grammar::PolygonOf(lot.item).outer) {
    corners.push_back(lot.item.scope.ToWorld(Vec3(p, 0)));
  }
  return corners;
}

bool HasCorner(const Lot& lot, const Vec3& corner) {
  for (const Vec3& c : CornersOf(lot)) {
    if (glm::distance(c, corner) < 1e-6) return true;
  }
  return false;
}

void ExpectUp(const Lot& lot) { EXPECT_NEAR(lot.item.facing.y, 1, 1e-9) << lot.name; }

TEST(Lot, ARectangleHasItsMinimumCornerAtTheOrigin) {
  const auto lots = ParseLots("rect(20, 10)");
  ASSERT_TRUE(lots);
  const Lot& lot = lots->at(0);
  ExpectUp(lot);
  EXPECT_EQ(lot.item.scope.size, Vec3(20, 10, 0));
  EXPECT_EQ(lot.item.scope.x, Vec3(1, 0, 0));
  for (const Vec3& c : {Vec3(0), Vec3(20, 0, 0), Vec3(20, 0, 10), Vec3(0, 0, 10)}) {
    EXPECT_TRUE(HasCorner(lot, c));
  }
}

TEST(Lot, APolygonStandsInWorldCoordinatesAndFacesUpWhateverItsWinding) {
  for (const char* text : {"poly(1,2 9,2 9,-8 1,-8)", "poly(1,-8 9,-8 9,2 1,2)"}) {
    const auto lots = ParseLots(text);
    ASSERT_TRUE(lots) << text;
    ExpectUp(lots->at(0));
    EXPECT_NEAR(grammar::AreaOf(lots->at(0).item), 80, 1e-9);
    EXPECT_TRUE(HasCorner(lots->at(0), Vec3(9, 0, -8)));
  }
}

TEST(Lot, MistakesInATextHaveTheirPlace) {
  EXPECT_EQ(ErrorOf("rect(20)"),
            "LOT:1:8: error: expected ',', got ')'\n"
            "    1 | rect(20)\n"
            "      |        ^");
  EXPECT_THAT(ErrorOf("rect(0,10)"), HasSubstr("a lot without area"));
  EXPECT_THAT(ErrorOf("rect(20,-10)"), HasSubstr("a lot without area"));
  EXPECT_THAT(ErrorOf("rect(nan,10)"), HasSubstr("expected a number of metres, got 'nan'"));
  EXPECT_THAT(ErrorOf("rect(1e999,10)"), HasSubstr("too large"));
  EXPECT_THAT(ErrorOf("rect(1e9,10)"), HasSubstr("a lot is 1e+09 m wide"));
  EXPECT_THAT(ErrorOf("rect(20,10"), HasSubstr("expected ')', got the end"));
  EXPECT_THAT(ErrorOf("rect(20,10) x"), HasSubstr("expected the end of the lot"));
  EXPECT_THAT(ErrorOf("poly(0,0 1,1)"), HasSubstr("at least 3 corners"));
  EXPECT_THAT(ErrorOf("poly(0,0 5,0 10,0)"), HasSubstr("area"));
  EXPECT_THAT(ErrorOf("poly(0,0 10,10 10,0 0,10)"), HasSubstr("cross"));
  EXPECT_THAT(ErrorOf("circle(3)"), HasSubstr("there is no lot 'circle'"));
  EXPECT_THAT(ErrorOf(""), HasSubstr("no lot is given"));
  EXPECT_THAT(ErrorOf("no/such/file.geojson"), HasSubstr("no/such/file.geojson"));
}

constexpr const char* kLines =
    R"({"id":"a","rings":[[[100.5,200.5],[110.5,200.5],[110.5,220.5],[100.5,220.5]]]}

{"id":7,"rings":[[[120,230],[120,250],[140,250],[140,230]],[[125,235],[130,235],[130,240],[125,240]]]}
)";

TEST(Lot, EastIsXAndNorthIsMinusZFromACommonOrigin) {
  const auto lots = LotsIn(kLines);
  ASSERT_TRUE(lots);
  ASSERT_EQ(lots->size(), 2u);
  EXPECT_EQ(lots->at(0).name, "a");
  EXPECT_EQ(lots->at(1).name, "7");
  EXPECT_EQ(lots->at(0).origin, Vec2(100, 200));
  EXPECT_EQ(lots->at(1).origin, Vec2(100, 200));
  EXPECT_TRUE(HasCorner(lots->at(0), Vec3(10.5, 0, -20.5)));
  EXPECT_TRUE(HasCorner(lots->at(1), Vec3(40, 0, -50)));
  EXPECT_NEAR(grammar::AreaOf(lots->at(1).item), 400 - 25, 1e-9);
  for (const Lot& lot : *lots) ExpectUp(lot);
}

TEST(Lot, GeoJsonOfEveryShapeIsRead) {
  const auto lots = LotsIn(R"({"type":"FeatureCollection","features":[
    {"type":"Feature","id":"f","properties":null,"geometry":
      {"type":"Polygon","coordinates":[[[0,0,5],[9,0,5],[9,9,5],[0,9,5],[0,0,5]]]}},
    {"type":"Feature","properties":{"id":12},"geometry":{"type":"GeometryCollection","geometries":[
      {"type":"Point","coordinates":[3,3]},
      {"type":"MultiPolygon","coordinates":[[[[20,0],[29,0],[20,9]]],[[[40,0],[49,0],[40,9]]]]}]}},
    {"type":"Feature","properties":{},"geometry":null}]})");
  ASSERT_TRUE(lots) << FormatError(lots.error());
  ASSERT_EQ(lots->size(), 3u);
  EXPECT_EQ(lots->at(0).name, "f");
  EXPECT_EQ(lots->at(2).name, "12");
  EXPECT_EQ(CornersOf(lots->at(0)).size(), 4u);
}

TEST(Lot, BadLotsOfAFileAreNamedAndCostNoOther) {
  const std::string lines = std::string(kLines) +
                            "{\"id\":\"bow\",\"rings\":[[[0,0],[9,9],[9,0],[0,9]]]}\n"
                            "{\"id\":\"line\",\"rings\":[[[0,0],[9,9]]]}\n";
  std::vector<Error> refused;
  const auto lots = LotsIn(lines, &refused);
  ASSERT_TRUE(lots);
  EXPECT_EQ(lots->size(), 2u);
  ASSERT_EQ(refused.size(), 2u);
  EXPECT_EQ(refused[0].code, ErrorCode::kSelfIntersecting);
  EXPECT_THAT(refused[0].message, HasSubstr("lot 'bow'"));
  EXPECT_EQ(refused[1].code, ErrorCode::kDegenerateGeometry);
  EXPECT_THAT(ErrorIn(lines), HasSubstr("lot 'bow'"));
}

TEST(Lot, MistakesInAFileAreExplained) {
  EXPECT_THAT(ErrorIn(""), HasSubstr("this is not JSON"));
  EXPECT_THAT(ErrorIn("{\"type\":\"Topology\"}"), HasSubstr("holds no lots"));
  EXPECT_THAT(ErrorIn("{\"type\":\"FeatureCollection\",\"features\":[]}"),
              HasSubstr("holds no lots"));
  EXPECT_THAT(ErrorIn("{\"type\":\"FeatureCollection\"}"), HasSubstr("no list \"features\""));
  EXPECT_THAT(ErrorIn("{\"type\":\"Polygon\",\"coordinates\":[[[13.37,52.51],[13.38,52.51],"
                      "[13.38,52.52]]]}"),
              HasSubstr("look like degrees"));
  EXPECT_THAT(ErrorIn("{\"id\":1,\"rings\":[[[0,0],[\"x\",0],[1,1]]]}"),
              HasSubstr("is not a number"));
  EXPECT_THAT(ErrorIn("{\"id\":1,\"rings\":[[[0,0],[1e300,0],[1,1]]]}"),
              HasSubstr("not a finite number"));
  EXPECT_THAT(ErrorIn("{\"id\":1,\"rings\":[[[0,0],[9,0],[9,9]]]}\n{\"id\":2,\"rin"),
              HasSubstr(":2:"));
  EXPECT_THAT(ErrorIn("{\"id\":1,\"rings\":[]}"), HasSubstr("no list of rings"));
}

TEST(Lot, CityJsonGroundsAreMergedAlongTheirEdges) {
  // A unit cube's floor as two triangles, without semantics, 5 m up, in decimetres.
  const auto lots = LotsIn(R"({"type":"CityJSON","version":"1.1",
    "transform":{"scale":[0.1,0.1,0.1],"translate":[1000,2000,5]},
    "vertices":[[0,0,0],[100,0,0],[100,100,0],[0,100,0],[0,0,30],[100,0,30],[100,100,30],[0,100,30]],
    "CityObjects":{"b":{"type":"Building","geometry":[{"type":"Solid","lod":"1","boundaries":[[
      [[0,2,1]],[[0,3,2]],[[4,5,6]],[[4,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]]]}]},
      "t":{"type":"SolitaryVegetationObject"}}})");
  ASSERT_TRUE(lots) << FormatError(lots.error());
  ASSERT_EQ(lots->size(), 1u);
  EXPECT_EQ(CornersOf(lots->at(0)).size(), 4u);
  EXPECT_NEAR(grammar::AreaOf(lots->at(0).item), 100, 1e-9);
  EXPECT_TRUE(HasCorner(lots->at(0), Vec3(10, 0, -10)));
  EXPECT_EQ(lots->at(0).origin, Vec2(1000, 2000));
  ExpectUp(lots->at(0));
}

constexpr std::string_view kBoxVertices =
    "[[0,0,0],[10,0,0],[10,8,0],[0,8,0],[0,0,6],[10,0,6],[10,8,6],[0,8,6]]";
constexpr std::string_view kBoxShell =
    "[[[3,2,1,0]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]]";

TEST(Lot, APartOnTheGroundOfItsBuildingIsNoLotOfItsOwn) {
  const auto city = [](std::string_view outline) {
    return fmt::format(
        R"({{"type":"CityJSON","version":"1.1","vertices":{},"CityObjects":{{
        "b":{{"type":"Building","children":["b-0"],"geometry":[
          {{"type":"MultiSurface","lod":"0","boundaries":[[{}]]}}]}},
        "b-0":{{"type":"BuildingPart","parents":["b"],"geometry":[
          {{"type":"Solid","lod":"1.2","boundaries":[{}]}}]}}}}}})",
        kBoxVertices, outline, kBoxShell);
  };
  const auto lots = LotsIn(city("[0,1,2,3]"));
  ASSERT_TRUE(lots) << FormatError(lots.error());
  ASSERT_EQ(lots->size(), 1u);
  EXPECT_EQ(lots->at(0).name, "b");
  // A wall that stands upright covers no ground: then the part is the lot.
  const auto apart = LotsIn(city("[0,1,5,4]"));
  ASSERT_TRUE(apart) << FormatError(apart.error());
  ASSERT_EQ(apart->size(), 1u);
  EXPECT_EQ(apart->at(0).name, "b-0");
}

TEST(Lot, GeometriesWithoutSurfacesArePassedOver) {
  for (const char* other : {R"({"type":"MultiPoint","lod":"0","boundaries":[0,1]})",
                            R"({"type":"MultiLineString","lod":"0","boundaries":[[0,1,2]]})",
                            R"({"type":"GeometryInstance","template":0,"boundaries":[0]})"}) {
    const auto lots = LotsIn(fmt::format(
        R"({{"type":"CityJSON","vertices":{},"CityObjects":{{"b":{{"type":"Building","geometry":[
        {},{{"type":"Solid","lod":"1","boundaries":[{}]}}]}}}}}})",
        kBoxVertices, other, kBoxShell));
    ASSERT_TRUE(lots) << other << FormatError(lots.error());
    EXPECT_EQ(lots->size(), 1u) << other;
  }
}

TEST(Lot, FeaturesOfSequencesAreReadLineByLine) {
  const auto feature = [](std::string_view id, int x) {
    return fmt::format(
        R"({{"type":"CityJSONFeature","id":"{0}","CityObjects":{{"{0}":{{"type":"Building",)"
        R"("geometry":[{{"type":"MultiSurface","lod":"0","boundaries":[[[0,1,2]]]}}]}}}},)"
        R"("vertices":[[{1},0,0],[{2},0,0],[{1},80,0]]}})",
        id, x, x + 100);
  };
  const std::string header = R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[],)"
                             R"("transform":{"scale":[0.1,0.1,0.1],"translate":[500,700,0]}})";
  const auto city = LotsIn(header + "\r\n" + feature("a", 0) + "\r\n" + feature("b", 200) + "\n");
  ASSERT_TRUE(city) << FormatError(city.error());
  ASSERT_EQ(city->size(), 2u);
  EXPECT_EQ(city->at(1).name, "b");
  EXPECT_EQ(city->at(1).origin, Vec2(500, 700));
  EXPECT_TRUE(HasCorner(city->at(1), Vec3(30, 0, 0)));
  EXPECT_THAT(ErrorIn(feature("a", 0)), HasSubstr("before any CityJSON object"));

  const std::string square =
      R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9]]]}})";
  for (const std::string& record : {std::string(), std::string("\x1e")}) {
    const auto lots = LotsIn(fmt::format("{0}{1}\n\n{0}{1}\n", record, square));
    ASSERT_TRUE(lots) << FormatError(lots.error());
    EXPECT_EQ(lots->size(), 2u);
  }
  EXPECT_THAT(ErrorIn(square + "\n{\"type\":\"Polygon\",\"coordinates\":[[7]]}\n"),
              HasSubstr("lots.json:2: a ring of lot '0' holds something that is no point"));
}

TEST(Lot, EmptyPolygonsAreNone) {
  const auto lots = LotsIn(R"({"type":"GeometryCollection","geometries":[
    {"type":"Polygon","coordinates":[]},{"type":"MultiPolygon","coordinates":[]},
    {"type":"MultiPolygon","coordinates":[[],[[[0,0],[9,0],[9,9]]]]}]})");
  ASSERT_TRUE(lots) << FormatError(lots.error());
  EXPECT_EQ(lots->size(), 1u);
  EXPECT_THAT(ErrorIn(R"({"type":"MultiPolygon","coordinates":null})"),
              HasSubstr("no list of polygons"));
}

TEST(Lot, DegreesAreToldByTheSizeOfLotsHoweverFarTheyLieApart) {
  const auto far = [](int north) {
    return fmt::format(R"({{"type":"MultiPolygon","coordinates":[
        [[[-70.001,{0}.001],[-70,{0}.001],[-70,{0}.002]]],
        [[[-69.001,{0}.5],[-69,{0}.5],[-69,{0}.501]]]]}})",
                       north);
  };
  EXPECT_THAT(ErrorIn(far(-33)), AllOf(HasSubstr("look like degrees"), HasSubstr("EPSG:32719")));
  EXPECT_THAT(ErrorIn(far(33)), HasSubstr("EPSG:32619"));
}

TEST(Lot, TheStreetIsWhereTheFileSaysItIs) {
  const std::string ring = "[[0,0],[9,0],[9,9]]";
  const std::string feature = R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[)" +
                              ring + R"(]},"properties":{"street_deg":)";
  for (const std::string& text :
       {feature + "-90.5}}", "{\"street_deg\":-90.5,\"rings\":[" + ring + "]}",
        R"({"type":"CityJSON","vertices":[[0,0,0],[9,0,0],[9,9,0]],"CityObjects":{"l":{
            "type":"LandUse","attributes":{"street_deg":-90.5},
            "geometry":[{"type":"MultiSurface","boundaries":[[[0,1,2]]]}]}}})" +
            std::string()}) {
    const auto lots = LotsIn(text);
    ASSERT_TRUE(lots) << FormatError(lots.error());
    EXPECT_EQ(lots->at(0).item.street_deg, -90.5F) << text;
  }
  EXPECT_FALSE(LotsIn(feature + "null}}")->at(0).item.street_deg);
  EXPECT_THAT(ErrorIn(feature + "\"north\"}}"),
              HasSubstr("lots.json:1: street_deg of lot '0' is not a number"));
  EXPECT_THAT(ErrorIn(feature + "400}}"), HasSubstr("street_deg of lot '0' is 400"));
}

TEST(Lot, WhatAFileSaysOfALotIsKeptByName) {
  const std::string ring = "[[0,0],[9,0],[9,9]]";
  const std::string values =
      R"("floors":3,"flat":true,"name":"Hut","none":null,"tags":["a"],"more":{"a":1})";
  const LotProperties expected = {{"flat", true},
                                  {"floors", 3.0},
                                  {"more", std::nullopt},
                                  {"name", "Hut"},
                                  {"tags", std::nullopt}};
  const std::string feature = std::string(R"({"type":"Feature","properties":{)")
                                  .append(values)
                                  .append(R"(},"geometry":{"type":"Polygon","coordinates":[)")
                                  .append(ring)
                                  .append("]}}");
  const std::string land_use =
      std::string(R"({"type":"CityJSON","vertices":[[0,0,0],[9,0,0],[9,9,0]],"CityObjects":{"l":{
          "type":"LandUse","geometry":[{"type":"MultiSurface","boundaries":[[[0,1,2]]]}],
          "attributes":{)")
          .append(values)
          .append("}}}}");
  for (const std::string& text : {feature, land_use}) {
    const auto lots = LotsIn(text);
    ASSERT_TRUE(lots) << FormatError(lots.error());
    EXPECT_EQ(lots->at(0).properties, expected) << text;
  }
  const LotProperties beside = LotsIn("{\"rings\":[" + ring + "],\"floors\":3}")->at(0).properties;
  EXPECT_EQ(beside, (LotProperties{{"floors", 3.0}}));
}

TEST(Lot, APartOfABuildingHasWhatTheFileSaysOfTheBuilding) {
  const auto lots =
      LotsIn(R"({"type":"CityJSON","vertices":[[0,0,0],[9,0,0],[9,9,0]],"CityObjects":{
      "b":{"type":"Building","attributes":{"floors":3,"roof":"flat","street_deg":90}},
      "p":{"type":"BuildingPart","parents":["b","gone"],"attributes":{"floors":2},
           "geometry":[{"type":"MultiSurface","boundaries":[[[0,1,2]]]}]}}})");
  ASSERT_TRUE(lots) << FormatError(lots.error());
  EXPECT_EQ(lots->at(0).properties,
            (LotProperties{{"floors", 2.0}, {"roof", "flat"}, {"street_deg", 90.0}}));
  EXPECT_EQ(lots->at(0).item.street_deg, 90.0F);
}

TEST(Lot, ThoseThatAreRefusedLeaveTheOthersAsIfTheFileHadThemAlone) {
  const std::string good = "{\"id\":\"good\",\"rings\":[[[510,0],[519,0],[519,9]]]}\n";
  const std::string bad =
      "{\"id\":\"street\",\"street_deg\":\"east\",\"rings\":[[[0,0],[9,0],[9,9]]]}\n"
      "{\"id\":\"ring\",\"rings\":[[[0,0],[9,0],[9]]]}\n"
      "{\"id\":\"thin\",\"rings\":[[[-80000000000,0],[-79999999991,0],[-79999999982,0]]]}\n"
      "{\"id\":\"wide\",\"rings\":[[[0,0],[900000,0],[900000,9]]]}\n";
  std::vector<Error> refused;
  const auto lots = LotsIn(bad + good, &refused);
  ASSERT_TRUE(lots) << FormatError(lots.error());
  ASSERT_EQ(lots->size(), 1u);
  EXPECT_EQ(CornersOf(lots->at(0)), CornersOf(LotsIn(good)->at(0)));
  EXPECT_EQ(lots->at(0).origin, Vec2(510, 0));
  ASSERT_EQ(refused.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const char* names[] = {"'street'", "'ring'", "'thin'", "'wide'"};
    EXPECT_THAT(refused[i].message, AllOf(HasSubstr("lots.json"), HasSubstr(names[i])));
  }
  EXPECT_THAT(ErrorIn(bad + good), HasSubstr("lots.json:1: street_deg"));
  EXPECT_FALSE(LotsIn(bad, &refused)) << "none is left";
}

TEST(Lot, DamagedCityJsonIsExplained) {
  EXPECT_THAT(ErrorIn(R"({"type":"CityJSON","vertices":[]})"), HasSubstr("no CityObjects"));
  for (const char* boundaries : {"[[[0,1,99]]]", "[[[0,1,-2]]]", "[[[0,1,\"a\"]]]", "7", "[7]"}) {
    EXPECT_THAT(ErrorIn(std::string(R"({"type":"CityJSON","vertices":[[0,0,0],[1,0,0],[1,1,0]],
      "CityObjects":{"b":{"type":"Building","geometry":[{"boundaries":)") +
                        boundaries + "}]}}}"),
                HasSubstr("boundaries that are not numbers of vertices"))
        << boundaries;
  }
}

TEST(Lot, RealPlotsAndFootprintsAreLots) {
  for (const char* name : {"buildings/footprints-dev.jsonl", "buildings/plots-dev.jsonl"}) {
    PARTI_NEED_DATA(path, name);
    std::vector<Error> refused;
    const auto lots = ParseLots(path, &refused);
    ASSERT_TRUE(lots) << FormatError(lots.error());
    for (const Error& error : refused) ADD_FAILURE() << FormatError(error);
    for (const Lot& lot : *lots) ExpectUp(lot);
  }
}

TEST(Lot, RealCityModelsHaveGrounds) {
  PARTI_NEED_DATA(hague, "buildings/DH_01_subs.city.json");
  PARTI_NEED_DATA(delft, "buildings/delft_1b.json");
  const auto many = ParseLots(hague);
  ASSERT_TRUE(many) << FormatError(many.error());
  EXPECT_GE(many->size(), 5u);
  // One building, open below, its roof in 75 triangles.
  const auto one = ParseLots(delft);
  ASSERT_TRUE(one) << FormatError(one.error());
  ASSERT_EQ(one->size(), 1u);
  EXPECT_GT(grammar::AreaOf(one->at(0).item), 100);
  EXPECT_NEAR(one->at(0).item.scope.origin.y, 0, 1);
}

}  // namespace
}  // namespace parti::app
