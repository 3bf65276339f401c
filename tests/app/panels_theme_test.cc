// Colours that can be read, words that say what is meant, layouts for any window.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "app/panels/layout.h"
#include "app/panels/letters.h"
#include "app/panels/theme.h"
#include "app/panels/tree_rows.h"
#include "app/panels/words.h"
#include "grammar/selection_action.h"

namespace parti::app::panels {
namespace {

constexpr Theme kThemes[] = {Theme::kLight, Theme::kDark};
constexpr Ground kGrounds[] = {Ground::kPanel,  Ground::kRaised, Ground::kHover,
                               Ground::kChosen, Ground::kAccent, Ground::kNote};
constexpr Tone kTones[] = {Tone::kText, Tone::kQuiet, Tone::kAccent, Tone::kWarning, Tone::kOff};

TEST(PanelThemeTest, EveryToneCanBeReadOnEveryGround) {
  for (const Theme theme : kThemes) {
    const Palette& palette = PaletteOf(theme);
    for (const Ground ground : kGrounds) {
      for (const Tone tone : kTones) {
        EXPECT_GE(Contrast(ColorOf(palette, tone, ground), ColorOf(palette, ground)),
                  kLeastContrast)
            << "theme " << static_cast<int>(theme) << ", tone " << static_cast<int>(tone)
            << " on ground " << static_cast<int>(ground);
      }
    }
  }
}

TEST(PanelThemeTest, ContrastIsThatOfTheWebsGuidelines) {
  EXPECT_NEAR(Contrast(0xff000000, 0xffffffff), 21, 1e-9);
  EXPECT_NEAR(Contrast(0xff777777, 0xffffffff), 4.48, 0.01);  // WebAIM's example of just too pale
  EXPECT_DOUBLE_EQ(Contrast(0xff123456, 0xff123456), 1);
}

TEST(PanelThemeTest, SmallWindowsLowerTheScale) {
  EXPECT_EQ(UsedScale(1, {800, 600}), 1);
  EXPECT_EQ(UsedScale(2, {1600, 1000}), 2);
  EXPECT_LT(UsedScale(3, {1080, 1920}), 2.3);
  EXPECT_GT(UsedScale(3, {1, 1}), 0);
}

TEST(PanelLettersTest, AFamilyThatIsNotThereHasAnotherInItsPlace) {
  const auto files = FindFont("No Such Family Of Letters");
  ASSERT_TRUE(files) << files.error().message;
  EXPECT_FALSE(files->regular.empty());
}

TEST(PanelLettersTest, LatinLettersOfAllEuropeAreThere) {
  const auto files = FindFont();
  ASSERT_TRUE(files);
  const auto letters = DrawLetters(*files, 1);
  ASSERT_TRUE(letters);
  for (const ImWchar letter : {u'A', u'ž', u'ő', u'ß', u'Ł', u'ı', u'×', u'°', u'…', u'—'}) {
    EXPECT_NE(letters->body->FindGlyphNoFallback(letter), nullptr) << letter;
  }
}

RC_GTEST_PROP(PanelLayout, EverythingLiesInTheWindowAndNothingOverlaps, ()) {
  const Vec2 size(*rc::gen::inRange(600, 4000), *rc::gen::inRange(600, 4000));
  LayoutNeeds needs{size, UsedScale(*rc::gen::element(1.0, 1.5, 2.0, 3.0), size)};
  needs.left_handed = *rc::gen::arbitrary<bool>();
  needs.bottom_px = static_cast<float>(44 * needs.scale);
  const Layout layout = LayoutOf(needs);
  const Box window{0, 0, static_cast<float>(size.x), static_cast<float>(size.y)};
  const Box boxes[] = {layout.title, layout.menu, layout.tools, layout.bottom};
  for (const Box& box : boxes) {
    RC_ASSERT(box.x0 >= 0 && box.y0 >= 0 && box.x1 <= window.x1 && box.y1 <= window.y1);
    for (const Box& other : boxes) RC_ASSERT(&box == &other || !box.Overlaps(other));
  }
  RC_ASSERT(!layout.rules.Overlaps(layout.tools) && !layout.rules.Overlaps(layout.menu));
  RC_ASSERT(!layout.free.Overlaps(layout.tools));
}

RC_GTEST_PROP(PanelLayout, CardsLieInTheirRoomAndNeverUnderTheHand, ()) {
  const auto x = static_cast<float>(*rc::gen::inRange(0, 1600));
  const auto y = static_cast<float>(*rc::gen::inRange(0, 1000));
  const bool left = *rc::gen::arbitrary<bool>();
  const Box room{80, 80, 1520, 920};
  const Vec2 pen(x, y);
  const Box cards = CardsBeside({x - 60, y - 40, x, y}, pen, 264, 200, room, left, 1);
  RC_ASSERT(cards.x0 >= room.x0 && cards.x1 <= room.x1);
  RC_ASSERT(cards.y0 >= room.y0 && cards.y1 <= room.y1);
  RC_ASSERT(!cards.Overlaps(HandAt(pen, left, 1)));
}

TEST(PanelLayoutTest, CardsAreOnTheSideOfTheOtherHand) {
  const Box stroke{780, 480, 820, 520}, room{0, 0, 1600, 1000};
  EXPECT_LT(CardsBeside(stroke, Vec2(820, 520), 264, 200, room, false, 1).x1, stroke.x0);
  EXPECT_GT(CardsBeside(stroke, Vec2(780, 520), 264, 200, room, true, 1).x0, stroke.x1);
}

std::string Words(const std::string& rule) {
  const auto trees = grammar::ParseTrees("tree t { .Lot --> " + rule + " }");
  EXPECT_TRUE(trees) << rule;
  return trees ? WordsOf((*trees)[0].nodes[0].action) : "";
}

TEST(PanelWordsTest, OperationsAreSaidPlainly) {
  EXPECT_EQ(Words("extrude(19) Mass"), "Extrude 19 m");
  EXPECT_EQ(Words("extrude(-0.5) Niche"), "Push in 0.5 m");
  EXPECT_EQ(Words("offset(-0.5) { inside: A | border: B }"), "Offset 0.5 m inward");
  EXPECT_EQ(Words("split(y) { 4: A | ~1: B | '0.25: C }"), "Split upward: 4 m, rest, 25 %");
  EXPECT_EQ(Words("split(x) { ~2.5: A }*"), "Repeat across every 2.5 m");
  EXPECT_EQ(Words("comp(f) { side: A | top: B }"), "Take faces: side, top");
  EXPECT_EQ(Words("color(\"#7e98a8\")"), "Color #7e98a8");
}

TEST(PanelWordsTest, NumbersAreShort) {
  EXPECT_EQ(PlainNumber(3), "3");
  EXPECT_EQ(PlainNumber(-0.0001), "0");
  EXPECT_EQ(PlainNumber(2.50), "2.5");
  EXPECT_EQ(PlainNumber(1.0 / 3), "0.333");
}

TEST(PanelWordsTest, ANumberAndItsUnitStayOnOneLine) {
  EXPECT_EQ(KeptTogether("every 2.5 m"), "every 2.5\u00a0m");
  EXPECT_EQ(KeptTogether("from 3 4"), "from 3 4");
}

TreeRow RowAt(const NodePath& path, int children = 0) {
  TreeRow row;
  row.path = path;
  row.children = children;
  return row;
}

TEST(PanelDropTest, PathsAreThoseAfterTheNodeWasTakenOut) {
  EXPECT_EQ(DropPath(RowAt({0, 3}), Drop::kAfter, {0, 1}), (NodePath{0, 3}));
  EXPECT_EQ(DropPath(RowAt({0, 3}), Drop::kBefore, {0, 1}), (NodePath{0, 2}));
  EXPECT_EQ(DropPath(RowAt({0, 3}, 2), Drop::kInto, {0, 1}), (NodePath{0, 2, 2}));
  EXPECT_EQ(DropPath(RowAt({0, 0}), Drop::kBefore, {0, 1}), (NodePath{0, 0}));
}

TEST(PanelDropTest, NothingIsDroppedIntoItselfOrWhereItIs) {
  EXPECT_EQ(DropPath(RowAt({0, 1, 0}), Drop::kInto, {0, 1}), std::nullopt);
  EXPECT_EQ(DropPath(RowAt({0, 0}), Drop::kAfter, {0, 1}), std::nullopt);
  EXPECT_EQ(DropPath(RowAt({0, 2}), Drop::kBefore, {0, 1}), std::nullopt);
}

TEST(PanelDropTest, TreesAndNodesDontMix) {
  EXPECT_EQ(DropPath(RowAt({0}), Drop::kAfter, {1, 0}), std::nullopt);
  EXPECT_EQ(DropPath(RowAt({0, 0}), Drop::kAfter, {1}), std::nullopt);
}

}  // namespace
}  // namespace parti::app::panels
