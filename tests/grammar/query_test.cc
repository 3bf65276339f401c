#include "grammar/query.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "grammar/query_filter.h"
#include "tests/grammar/derived.h"
#include "tests/grammar/random_trees.h"

namespace parti::grammar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string ReadBack(std::string_view text) {
  const auto query = ParseQuery(text);
  return query ? TextOf(*query) : FormatError(query.error());
}

std::string ErrorOf(std::string_view text) {
  const auto query = ParseQuery(text);
  return query ? "no error: " + TextOf(*query) : FormatError(query.error());
}

/// 20 by 10 by 9: top, then the south side (z = 10), the east, the north and the west. Each side
/// has three floors, each floor two tiles but the middle one, which has a tile and a door.
ShapeTree House() {
  return Derived(R"(
    .Lot --> extrude(9) Mass
    .Mass --> comp(f) { side: Facade | top: tag("flat") Roof }
    .Facade --> split(y) { ~3: Floor }*
    .Floor:odd --> split(x) { ~1: Tile | ~1: Tile }
    .Floor:even --> split(x) { ~1: Tile | 1: tag("way") tag("in") Door }
  )")
      .tree;
}

TEST(QueryText, Listing5_3_To_5_6AndTheLimitationsExample) {
  EXPECT_EQ(ReadBack("Split.Window#small:north"), "Split.Window#small:north");
  EXPECT_EQ(ReadBack("#wall:inside(sphere(3,1,5,5))"), "#wall:inside(sphere(3, 1, 5, 5))");
  EXPECT_EQ(ReadBack(".Facade:north / .Floor:even > #Window"),
            ".Facade:north / .Floor:even > #Window");
  EXPECT_EQ(ReadBack(".Floor:even:north>#Window"), ".Floor:even:north > #Window");
  EXPECT_EQ(ReadBack("#Window:facing(#Road):within(#Door, 5)"),
            "#Window:facing(#Road):within(#Door, 5)");
}

TEST(QueryText, TheOtherFormsReadBackToo) {
  EXPECT_EQ(ReadBack("*"), "*");
  EXPECT_EQ(ReadBack(" * > *:leaf ~ Extrude "), "* > :leaf ~ Extrude");
  EXPECT_EQ(ReadBack(":nth(2,3)"), ":nth(2, 3)");
  EXPECT_EQ(ReadBack(".A:inside(.B > .C)"), ".A:inside((.B > .C))");
  EXPECT_EQ(ReadBack(".A:inside((.B))"), ".A:inside((.B))");
  EXPECT_EQ(ReadBack(":intersects(box(-1,0,-.5,2,3,4))"), ":intersects(box(-1, 0, -0.5, 2, 3, 4))");
  EXPECT_EQ(ReadBack("/* any */ .A // leaf"), ".A");
  EXPECT_EQ(ReadBack(".\"two words\"#\"a tag\""), ".\"two words\"#\"a tag\"");
}

TEST(QueryText, MisspeltNamesAreExplained) {
  EXPECT_EQ(ErrorOf(".Floor:evn > .Tile"),
            "<text>:1:8: error: there is no filter 'evn'\n"
            "    1 | .Floor:evn > .Tile\n"
            "      |        ^~~  hint: did you mean 'even'?");
  EXPECT_THAT(ErrorOf("Splt.A"), HasSubstr("did you mean 'Split'?"));
  EXPECT_THAT(ErrorOf("Facade"), HasSubstr("a symbol is written with a dot: .Facade"));
  EXPECT_THAT(ErrorOf(".A:inside(spere(1,2,3,4))"), HasSubstr("did you mean 'sphere'?"));
}

TEST(QueryText, EveryKindOfMistakeHasItsMessage) {
  EXPECT_THAT(ErrorOf(""), HasSubstr("expected a selector, got the end of the text"));
  EXPECT_THAT(ErrorOf(".A >"), HasSubstr("expected a selector, got the end of the text"));
  EXPECT_THAT(ErrorOf("> .A"), HasSubstr("expected a selector, got '>'"));
  EXPECT_THAT(ErrorOf("."), HasSubstr("a symbol after '.'"));
  EXPECT_THAT(ErrorOf("#"), HasSubstr("a tag after '#'"));
  EXPECT_THAT(ErrorOf(".A:"), HasSubstr("a filter's name after ':'"));
  EXPECT_THAT(ErrorOf(".A.B"), HasSubstr("at most one symbol"));
  EXPECT_THAT(ErrorOf("#a.B"), HasSubstr("the order is"));
  EXPECT_THAT(ErrorOf(".A #b"), HasSubstr("stand without blanks"));
  EXPECT_THAT(ErrorOf(".A:north(3)"), HasSubstr("takes no arguments"));
  EXPECT_THAT(ErrorOf(".A:nth"), HasSubstr("'(' and the arguments of 'nth'"));
  EXPECT_THAT(ErrorOf(".A:nth(0)"), HasSubstr("whole numbers from 1"));
  EXPECT_THAT(ErrorOf(".A:nth(2,0)"), HasSubstr("whole numbers from 1"));
  EXPECT_THAT(ErrorOf(".A:nth(1.5)"), HasSubstr("whole numbers from 1"));
  EXPECT_THAT(ErrorOf(".A:larger(x)"), HasSubstr("expected a number, got 'x'"));
  EXPECT_THAT(ErrorOf(".A:larger(nan)"), HasSubstr("expected a number, got 'nan'"));
  EXPECT_THAT(ErrorOf(".A:larger(1e999)"), HasSubstr("too large"));
  EXPECT_THAT(ErrorOf(".A:inside(sphere(1,2,3))"), HasSubstr("sphere(x,y,z,r)"));
  EXPECT_THAT(ErrorOf(".A:inside(sphere(1,2,3,-4))"), HasSubstr("not negative"));
  EXPECT_THAT(ErrorOf(".A:within(.B)"), HasSubstr("a distance in metres"));
  EXPECT_THAT(ErrorOf(".A:within(.B, -1)"), HasSubstr("not negative"));
  EXPECT_THAT(ErrorOf(".A:facing(.B"), HasSubstr("expected ')'"));
  EXPECT_THAT(ErrorOf(".A\xff"), HasSubstr("UTF-8"));
  EXPECT_THAT(ErrorOf(".\"A"), HasSubstr("not closed"));
}

TEST(QueryText, DeepQueriesAreRefusedNotFollowed) {
  std::string text;
  for (int i = 0; i < 100'000; ++i) text += ".A:facing(";
  EXPECT_THAT(ErrorOf(text), HasSubstr("nested more than 16 deep"));
}

RC_GTEST_PROP(QueryText, EveryQueryReadsBack, ()) {
  const Query query = RandomQuery();
  const auto read = ParseQuery(TextOf(query));
  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == query);
}

TEST(Query, SymbolsTagsAndOperations) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected(".Lot", house), ElementsAre("."));
  EXPECT_THAT(Selected("Extrude", house), ElementsAre("0"));
  EXPECT_THAT(Selected("Comp.Roof", house), ElementsAre("0/0"));
  EXPECT_THAT(Selected("#flat", house), ElementsAre("0/0"));
  EXPECT_THAT(Selected("#way#in", house), ElementsAre("0/1/1/1", "0/2/1/1", "0/3/1/1", "0/4/1/1"));
  EXPECT_EQ(Selected("Repeat.Floor", house).size(), 12u);
  EXPECT_THAT(Selected("Split.Floor", house), IsEmpty());
  EXPECT_THAT(Selected(".Nothing", house), IsEmpty());
  EXPECT_THAT(Selected("#nothing", house), IsEmpty());
  EXPECT_EQ(Selected("*", house).size(), house.size());
}

TEST(Query, Directions) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected(".Facade:south", house), ElementsAre("0/1"));
  EXPECT_THAT(Selected(".Facade:east", house), ElementsAre("0/2"));
  EXPECT_THAT(Selected(".Facade:north", house), ElementsAre("0/3"));
  EXPECT_THAT(Selected(".Facade:west", house), ElementsAre("0/4"));
  EXPECT_THAT(Selected("Comp:up", house), ElementsAre("0/0"));
  EXPECT_THAT(Selected(":down", house), IsEmpty());
  // The lot faces up, and the mass was extruded from it.
  EXPECT_THAT(Selected(":up", house), ElementsAre(".", "0", "0/0"));
}

TEST(Query, EveryNormalHasOneDirection) {
  const auto direction = [](double x, double y, double z) {
    return DirectionOf(glm::normalize(Vec3(x, y, z)));
  };
  EXPECT_EQ(direction(0, 0, -1), "north");
  EXPECT_EQ(direction(1, 0, 0), "east");
  EXPECT_EQ(direction(0, 0, 1), "south");
  EXPECT_EQ(direction(-1, 0, 0), "west");
  // Borders belong to the sector that follows clockwise, with or without rounding.
  for (const double off : {0.0, 1e-12, -1e-12}) {
    EXPECT_EQ(direction(1 + off, 0, -1), "east");
    EXPECT_EQ(direction(1 + off, 0, 1), "south");
    EXPECT_EQ(direction(-1 + off, 0, 1), "west");
    EXPECT_EQ(direction(-1 + off, 0, -1), "north");
    EXPECT_EQ(direction(0, 1 + off, 1), "up");
    EXPECT_EQ(direction(0, -1 + off, 1), "down");
  }
  EXPECT_EQ(direction(0, 0.99, 1), "south");
  EXPECT_EQ(DirectionOf(Vec3(0)), "");
  EXPECT_EQ(DirectionOf(Vec3(std::nan(""), 0, 0)), "");
}

TEST(Query, PositionsCountFromOneAmongSiblingsWithTheSameSymbol) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected(".Facade:first > .Floor:odd", house), ElementsAre("0/1/0", "0/1/2"));
  EXPECT_THAT(Selected(".Facade:first > .Floor:even", house), ElementsAre("0/1/1"));
  EXPECT_THAT(Selected(".Facade:first > .Floor:first", house), ElementsAre("0/1/0"));
  EXPECT_THAT(Selected(".Facade:first > .Floor:last", house), ElementsAre("0/1/2"));
  EXPECT_THAT(Selected(".Facade:first > .Floor:middle", house), ElementsAre("0/1/1"));
  EXPECT_THAT(Selected(".Facade:first > .Floor:ends", house), ElementsAre("0/1/0", "0/1/2"));
  EXPECT_THAT(Selected(".Facade:nth(2)", house), ElementsAre("0/2"));
  EXPECT_THAT(Selected(".Facade:nth(2,2)", house), ElementsAre("0/2", "0/4"));
  EXPECT_THAT(Selected(".Facade:nth(1,3)", house), ElementsAre("0/1", "0/4"));
  // The roof is a face among five and the first Roof; the only one of a kind is first and last.
  EXPECT_THAT(Selected(".Roof:first:last:odd", house), ElementsAre("0/0"));
  EXPECT_THAT(Selected(".Roof:middle", house), IsEmpty());
  EXPECT_THAT(Selected(".Door:first", house).size(), 4u);
  EXPECT_THAT(Selected(".Lot:first", house), ElementsAre("."));
}

TEST(Query, Relations) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected(".Facade:north / .Floor:even > .Door", house), ElementsAre("0/3/1/1"));
  EXPECT_THAT(Selected(".Facade:north / .Door", house), IsEmpty());
  EXPECT_THAT(Selected(".Facade:north > .Door", house), ElementsAre("0/3/1/1"));
  // Siblings of doors that are no doors themselves (5.11).
  EXPECT_THAT(Selected(".Door ~ *", house),
              ElementsAre("0/1/1/0", "0/2/1/0", "0/3/1/0", "0/4/1/0"));
  EXPECT_THAT(Selected(".Facade ~ *", house), ElementsAre("0/0"));
  EXPECT_THAT(Selected(".Facade ~ .Facade", house), IsEmpty());
  EXPECT_THAT(Selected(".Facade:first ~ .Facade", house), ElementsAre("0/2", "0/3", "0/4"));
  EXPECT_THAT(Selected(".Lot ~ *", house), IsEmpty());
  EXPECT_THAT(Selected("* / *", house).size(), house.size() - 1);
}

TEST(Query, DescendantsOfNestedShapesComeOnceAndInCreationOrder) {
  const ShapeTree house = House();
  EXPECT_EQ(Selected("* > *", house).size(), house.size() - 1);
  EXPECT_THAT(Selected(".Facade > .Tile", house), testing::Eq(Selected(".Tile", house)));
}

TEST(Query, LeavesAreWhatHasNoChildren) {
  const ShapeTree house = House();
  EXPECT_EQ(Selected(":leaf", house).size(), house.Leaves().size());
  EXPECT_THAT(Selected(".Floor:leaf", house), IsEmpty());
}

TEST(Query, WithinSeesOnlyWhatIsBelow) {
  const ShapeTree house = House();
  const std::vector<ShapeIndex> north = {*house.AtId("0/3")};
  const auto below = [&](std::string_view query) {
    return IdsOf(house, *ProductOf(*ParseQuery(query), house, &north));
  };
  EXPECT_THAT(below(".Door"), ElementsAre("0/3/1/1"));
  EXPECT_THAT(below(".Facade"), IsEmpty());
  // (5.14): the product over the whole tree, cut down; the facade itself is outside.
  EXPECT_THAT(below(".Mass > .Door"), ElementsAre("0/3/1/1"));
  EXPECT_THAT(below(".Facade / .Floor:last"), ElementsAre("0/3/2"));
}

TEST(Query, InsideAndIntersectsOfVolumes) {
  const ShapeTree house = House();
  // The south facade is the plane z = 10; its first floor is 3 m high.
  EXPECT_THAT(Selected(".Floor:inside(box(-1,-1,9,22,4.5,2))", house), ElementsAre("0/1/0"));
  EXPECT_THAT(Selected(".Floor:south:intersects(box(-1,-1,9,22,4.5,2))", house),
              ElementsAre("0/1/0", "0/1/1"));
  EXPECT_THAT(Selected(".Floor:intersects(sphere(10,4.5,12,2.1))", house), ElementsAre("0/1/1"));
  EXPECT_THAT(Selected(".Floor:intersects(sphere(10,4.5,12,1.9))", house), IsEmpty());
  EXPECT_THAT(Selected(".Floor:inside(sphere(10,4.5,10,10.3))", house), ElementsAre("0/1/1"));
  EXPECT_THAT(Selected(".Facade:intersects(cylinder(20,2,5,1,3))", house), ElementsAre("0/2"));
  EXPECT_THAT(Selected(".Facade:intersects(cylinder(22,2,5,1,3))", house), IsEmpty());
  EXPECT_THAT(Selected(".Facade:intersects(cylinder(20,10,5,1,3))", house), IsEmpty());
  EXPECT_THAT(Selected(".Roof:inside(cylinder(10,8,5,11.3,2))", house), ElementsAre("0/0"));
  // A solid that encloses the volume meets it though its surface does not.
  EXPECT_THAT(Selected("*:intersects(sphere(10,4,5,1))", house), ElementsAre("0"));
}

TEST(Query, InsideAndIntersectsOfShapes) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected(".Facade:inside((.Mass))", house).size(), 4u);
  EXPECT_THAT(Selected(".Lot:inside((.Facade))", house), IsEmpty());
  EXPECT_THAT(Selected(".Door:inside((.Facade:north))", house), ElementsAre("0/3/1/1"));
  EXPECT_THAT(Selected(".Facade:intersects((.Facade:north))", house), ElementsAre("0/2", "0/4"));
  EXPECT_THAT(Selected(".Mass:inside((.Mass))", house), IsEmpty());  // never with itself
}

TEST(Query, FacingAndWithin) {
  const ShapeTree street = Derived(R"(
    .Lot --> split(x) { 10: House | ~1: Garden | 3: Road }
    .House --> extrude(6) Mass
    .Mass --> comp(f) { side: Facade }
  )")
                               .tree;
  EXPECT_THAT(Selected(".Facade:facing(.Road)", street),
              testing::Eq(Selected(".Facade:east", street)));
  EXPECT_THAT(Selected(".Facade:facing(.Nothing)", street), IsEmpty());
  // The nearest corners of the north and south sides are those of the east side.
  EXPECT_EQ(Selected(".Facade:within(.Road, 7)", street).size(), 3u);
  EXPECT_THAT(Selected(".Facade:within(.Road, 6.99)", street), IsEmpty());
  EXPECT_EQ(Selected(".Facade:within(.Road, 17)", street).size(), 4u);
  EXPECT_THAT(Selected(".Road:within(.Garden, 0)", street), ElementsAre("2"));
}

TEST(Query, Areas) {
  const ShapeTree house = House();
  EXPECT_THAT(Selected("Comp:larger(150)", house), ElementsAre("0/0", "0/1", "0/3"));
  EXPECT_THAT(Selected("Comp:smaller(100)", house), ElementsAre("0/2", "0/4"));
  EXPECT_THAT(Selected(".Mass:larger(939):smaller(941)", house), ElementsAre("0"));
}

TEST(Query, ValuesThatNoTextGivesAreRefusedToo) {
  const ShapeTree lot = LotOf(2, 2);
  Query query{{QuerySelector{"Nonsense", "", {}, {}}}, {}};
  EXPECT_EQ(ProductOf(query, lot).error().code, ErrorCode::kUnknownName);
  query.selectors[0] = {"", "", {}, {Filter{"nonsense", {}, "", {}}}};
  EXPECT_EQ(ProductOf(query, lot).error().code, ErrorCode::kUnknownName);
  query.selectors[0] = {"", "", {}, {Filter{"nth", {}, "", {}}}};
  EXPECT_EQ(ProductOf(query, lot).error().code, ErrorCode::kBadArguments);
  query.selectors[0] = {"", "", {}, {Filter{"inside", {}, "sphere", {}}}};
  EXPECT_EQ(ProductOf(query, lot).error().code, ErrorCode::kBadArguments);
}

/// (5.1) by brute force, for one relation: what the passes over the tree must come to.
bool IsRelated(const ShapeTree& tree, Query::Relation relation, ShapeIndex a, ShapeIndex b) {
  if (relation == Query::Relation::kChildren) return tree.node(b).parent == a;
  if (relation == Query::Relation::kDescendants) return tree.IsAncestor(a, b);
  return tree.node(a).parent == tree.node(b).parent && tree.node(b).parent != kNoShape;
}

RC_GTEST_PROP(Query, RelationsAreAsDefined, (const std::vector<uint32_t>& parents)) {
  ShapeTree tree = LotOf(1, 1);
  const NameId symbols[] = {tree.Intern("A"), tree.Intern("B")};
  for (const uint32_t p : parents) {
    tree.Append(p % tree.size(), tree[0].item, symbols[p / 7 % 2], nullptr);
  }
  for (const char mark : {'>', '/', '~'}) {
    const auto relation = static_cast<Query::Relation>(mark);
    const Query query{{QuerySelector{"", "A", {}, {}}, QuerySelector{}}, {relation}};
    const auto found = *ProductOf(query, tree);
    std::vector<ShapeIndex> expected;
    for (ShapeIndex b = 0; b < tree.size(); ++b) {
      bool related = false;
      for (ShapeIndex a = 0; a < tree.size() && !related; ++a) {
        related = tree[a].symbol == symbols[0] && IsRelated(tree, relation, a, b);
      }
      if (mark == '~' && tree[b].symbol == symbols[0]) related = false;
      if (related) expected.push_back(b);
    }
    RC_ASSERT(found == expected);
  }
}

}  // namespace
}  // namespace parti::grammar
