#include "grammar/rules/built_ins.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grammar/rules/situation.h"

namespace parti::grammar {
namespace {

/// A wall of 10 by 3 m that looks south-east, on a lot that begins at (1, 0, 2).
struct Wall {
  Item lot, item;
  Random random{7};

  Wall() {
    lot.scope.origin = Vec3(1, 0, 2);
    lot.scope.size = Vec3(20, 10, 0);
    const double diagonal = std::sqrt(0.5);
    item.scope = {Vec3(4, 3, 2), Vec3(diagonal, 0, -diagonal), Vec3(0, 1, 0),
                  Vec3(diagonal, 0, diagonal), Vec3(10, 3, 0)};
    item.facing = item.scope.z;
  }

  Value Of(std::string_view name, const std::vector<Value>& operands = {}) {
    const BuiltIn* row = FindBuiltIn(name, operands.size());
    if (row == nullptr) {
      ADD_FAILURE() << "there is no " << name;
      return 0.0;
    }
    Situation situation;
    situation.item = &item;
    situation.lot = &lot;
    situation.split = {2, 5};
    situation.random = &random;
    return row->evaluate(operands, situation);
  }
  double Number(std::string_view name, const std::vector<Value>& operands = {}) {
    return NumberOf(Of(name, operands));
  }
  std::string Text(std::string_view name, const std::vector<Value>& operands) {
    return TextOf(Of(name, operands));
  }
};

using T = std::string;

TEST(BuiltIns, AreSortedAndEachIsThereOnce) {
  const auto rows = BuiltIns();
  for (size_t i = 1; i < rows.size(); ++i) {
    const bool ordered =
        rows[i - 1].name < rows[i].name ||
        (rows[i - 1].name == rows[i].name && rows[i - 1].operands.size() < rows[i].operands.size());
    EXPECT_TRUE(ordered) << rows[i].name;
  }
}

TEST(BuiltIns, AnglesAreDegrees) {
  Wall wall;
  EXPECT_NEAR(wall.Number("sin", {30.0}), 0.5, 1e-12);
  EXPECT_NEAR(wall.Number("atan2", {1.0, 1.0}), 45, 1e-12);
  EXPECT_NEAR(wall.Number("acos", {0.5}), 60, 1e-12);
}

TEST(BuiltIns, TextsAreCountedFoundCutAndReplaced) {
  Wall wall;
  EXPECT_EQ(wall.Number("len", {T("tower")}), 5);
  EXPECT_EQ(wall.Number("count", {T("abcabc"), T("bc")}), 2);
  EXPECT_EQ(wall.Number("find", {T("abcabc"), T("bc")}), 1);
  EXPECT_EQ(wall.Number("find", {T("abcabc"), T("bc"), 1.0}), 4);
  EXPECT_EQ(wall.Number("find", {T("abcabc"), T("bc"), -1.0}), 4);
  EXPECT_EQ(wall.Number("find", {T("abcabc"), T("x")}), -1);
  EXPECT_EQ(wall.Text("substring", {T("facade"), 1.0, 4.0}), "aca");
  EXPECT_EQ(wall.Text("substring", {T("facade"), 4.0, 1.0}), "");
  EXPECT_EQ(wall.Text("substring", {T("facade"), NAN, 99.0}), "facade");
  EXPECT_EQ(wall.Text("replace", {T("a-b-c"), T("-"), T("..")}), "a..b..c");
  EXPECT_EQ(wall.Text("replace", {T("abc"), T(""), T("x")}), "abc");
}

TEST(BuiltIns, ListsAreTextsWithSemicolons) {
  Wall wall;
  EXPECT_EQ(wall.Number("listSize", {T("a;b;c;")}), 3);
  EXPECT_EQ(wall.Number("listSize", {T("")}), 0);
  EXPECT_EQ(wall.Text("listItem", {T("a;b;c"), 1.0}), "b");
  EXPECT_EQ(wall.Text("listItem", {T("a;b;c"), 9.0}), "");
  EXPECT_EQ(wall.Number("listIndex", {T("a;b;c"), T("c")}), 2);
  EXPECT_EQ(wall.Text("listAdd", {T("a"), T("b")}), "a;b;");
}

TEST(BuiltIns, AShapeKnowsItsScopeAndWhichOfSeveralItIs) {
  Wall wall;
  EXPECT_EQ(wall.Number("scope.sx"), 10);
  EXPECT_EQ(wall.Number("scope.sz"), 0);
  EXPECT_EQ(wall.Number("scope.tx"), 3);
  EXPECT_EQ(wall.Number("scope.elevation"), 3);
  EXPECT_NEAR(wall.Number("scope.ry"), 45, 1e-9);
  EXPECT_NEAR(wall.Number("scope.rx"), 0, 1e-9);
  EXPECT_EQ(wall.Number("split.index"), 2);
  EXPECT_EQ(wall.Number("split.total"), 5);
  EXPECT_EQ(wall.Number("comp.total"), 0);
  EXPECT_EQ(wall.Number("initialShape.area"), 200);
}

TEST(BuiltIns, GeometryOfARectangleABoxAndACutCorner) {
  Wall wall;
  EXPECT_EQ(wall.Number("geometry.area"), 30);
  EXPECT_EQ(wall.Number("geometry.nEdges"), 4);
  EXPECT_NEAR(wall.Number("geometry.height"), 3, 1e-12);
  EXPECT_NEAR(wall.Number("geometry.boundaryLength"), 26, 1e-12);
  EXPECT_NEAR(wall.Number("geometry.angle", {T("zenith")}), 90, 1e-9);
  EXPECT_NEAR(wall.Number("geometry.angle", {T("azimuth")}), 45, 1e-9);
  EXPECT_TRUE(TruthOf(wall.Of("geometry.isRectangular")));
  wall.item.polygon = std::make_shared<const Polygon>(
      Polygon{{Vec2(0, 0), Vec2(10, 0), Vec2(10, 2), Vec2(9, 3), Vec2(0, 3)}, {}});
  EXPECT_FALSE(TruthOf(wall.Of("geometry.isRectangular")));
  EXPECT_FALSE(TruthOf(wall.Of("geometry.isConcave")));
  EXPECT_EQ(wall.Number("geometry.nVertices"), 5);
  wall.item.polygon = nullptr;
  wall.item.type = ItemType::kVolume;
  wall.item.scope.size.z = 2;
  EXPECT_EQ(wall.Number("geometry.nFaces"), 6);
  EXPECT_EQ(wall.Number("geometry.volume"), 60);
  EXPECT_TRUE(TruthOf(wall.Of("geometry.isClosedSurface")));
}

TEST(BuiltIns, RandomNumbersStayBetweenTheirBoundsAndRepeatWithTheStream) {
  Wall wall, same;
  for (int i = 0; i < 100; ++i) {
    const double number = wall.Number("rand", {2.0, 3.0});
    EXPECT_TRUE(number >= 2 && number < 3) << number;
    EXPECT_EQ(number, same.Number("rand", {2.0, 3.0}));
  }
}

TEST(BuiltIns, ConversionsTakeWhatIsThere) {
  Wall wall;
  EXPECT_EQ(wall.Number("float", {T(" 3.5m")}), 3.5);
  EXPECT_EQ(wall.Number("float", {T("none")}), 0);
  EXPECT_EQ(wall.Number("num", {true}), 1);
  EXPECT_EQ(wall.Text("str", {0.1}), "0.1");
  EXPECT_FALSE(TruthOf(wall.Of("bool", {T("false")})));
}

TEST(BuiltIns, ColorsGoThroughTheirText) {
  Wall wall;
  EXPECT_EQ(wall.Text("colorRGBToHex", {1.0, 0.5, 0.0}), "#ff8000");
  EXPECT_EQ(wall.Text("colorHSVToHex", {120.0, 1.0, 1.0}), "#00ff00");
  EXPECT_EQ(wall.Number("colorHexToB", {T("#0000ff")}), 1);
}

}  // namespace
}  // namespace parti::grammar
