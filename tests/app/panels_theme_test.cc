// Colours that can be read, words that say what is meant, layouts for any window.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "app/panels/cards.h"
#include "app/panels/drafts.h"
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
  const Box cards = CardsBeside({{x - 60, y - 40, x, y}, 264, 200, room, pen, left, 1, {}});
  RC_ASSERT(cards.x0 >= room.x0 && cards.x1 <= room.x1);
  RC_ASSERT(cards.y0 >= room.y0 && cards.y1 <= room.y1);
  RC_ASSERT(!cards.Overlaps(HandAt(pen, left, 1)));
}

TEST(PanelLayoutTest, CardsAreOnTheSideOfTheOtherHand) {
  const Box stroke{780, 480, 820, 520}, room{0, 0, 1600, 1000};
  EXPECT_LT(CardsBeside({stroke, 264, 200, room, Vec2(820, 520), false, 1, {}}).x1, stroke.x0);
  const Box up{800, 380, 800, 580};  // as a line up from the lot, that the pen has ended above
  const Box beside = CardsBeside({up, 264, 100, room, Vec2(800, 380), false, 1, {}});
  EXPECT_EQ(beside.y1, up.y0 - 60) << "above it, and no farther than it must be";
  EXPECT_EQ(beside.middle_x(), up.middle_x());
  EXPECT_GT(CardsBeside({stroke, 264, 200, room, Vec2(780, 520), true, 1, {}}).x0, stroke.x1);
}

TEST(PanelLayoutTest, CardsStayWhereTheyCameUpWhileThePenComesNear) {
  const Box stroke{780, 480, 820, 520}, room{0, 0, 1600, 1000};
  StandingCards cards;
  CardNeeds needs{stroke, 264, 200, room, Vec2(820, 520), false, 1, {}};
  const Box at = cards.Stand(needs);
  needs.pen_px = Vec2(at.x1 + 5, 500);
  EXPECT_EQ(cards.Stand(needs), at);
  needs.clear_of = {{at.x1 + 10, at.y0, at.x1 + 20, at.y1}};
  EXPECT_EQ(cards.Stand(needs), at) << "that is beside it";
  needs.clear_of = {at.Inset(20)};
  EXPECT_FALSE(cards.Stand(needs).Overlaps(at.Inset(20)));
  needs.stroke = {80, 80, 120, 120};
  needs.pen_px.reset();
  EXPECT_FALSE(cards.Stand(needs) == at);
}

TEST(PanelLayoutTest, CardsLeaveAsMuchClearAsTheyCan) {
  const Box stroke{780, 480, 820, 520}, room{0, 0, 1600, 1000};
  CardNeeds needs{stroke, 264, 200, room, std::nullopt, false, 1, {}};
  needs.clear_of = {{400, 300, 760, 700}, {700, 0, 830, 390}};
  EXPECT_GE(CardsBeside(needs).x0, stroke.x1) << "left and above something lies";
  needs.clear_of.push_back({0, 0, 1600, 1000});
  EXPECT_GE(CardsBeside(needs).x0, stroke.x1) << "one thing is better than two";
}

RC_GTEST_PROP(PanelLayout, AWordBesideThePenIsInTheWindowAndNeverUnderTheTip, ()) {
  const Vec2 pen(*rc::gen::inRange(0, 1600), *rc::gen::inRange(0, 1000));
  const bool left = *rc::gen::arbitrary<bool>();
  const auto width = static_cast<float>(*rc::gen::inRange(40, 400));
  const Box room{4, 4, 1596, 996};
  const Box word = WordBeside(pen, width, 28, room, left, 1);
  RC_ASSERT(word.x0 >= room.x0 && word.y0 >= room.y0 && word.x1 <= room.x1 && word.y1 <= room.y1);
  RC_ASSERT(word.DistanceTo(pen) > 5);
}

TEST(PanelLayoutTest, AWordCoversNoControl) {
  const Box room{0, 0, 1600, 1000};
  const Vec2 pen(800, 500);
  const Box wanted = WordBeside(pen, 120, 28, room, false, 1);
  std::vector<Box> controls = {{wanted.x0 + 5, wanted.y0 + 20, wanted.x0 + 49, wanted.y0 + 64}};
  const Box other = WordBeside(pen, 120, 28, room, false, 1, controls);
  EXPECT_FALSE(other.Overlaps(controls[0]));
  EXPECT_GT(other.DistanceTo(pen), 5);
  controls.push_back({0, 400, 1600, 600});  // a row of the window's width, the pen over it
  const Box beyond = WordBeside(pen, 120, 28, room, false, 1, controls);
  for (const Box& control : controls) EXPECT_FALSE(beyond.Overlaps(control));
  controls.push_back(room);
  EXPECT_FALSE(WordBeside(pen, 120, 28, room, false, 1, controls).Overlaps(controls[1]))
      << "where something is covered anyway, as little as can be";
}

TEST(PanelLayoutTest, AWordIsOutOfTheWayOfTheHand) {
  const Box room{0, 0, 1600, 1000};
  for (const bool left : {false, true}) {
    const Vec2 pen(800, 500);
    EXPECT_FALSE(WordBeside(pen, 120, 28, room, left, 1).Overlaps(HandAt(pen, left, 1)));
  }
}

TEST(PanelWordsTest, ADraftIsNamedByItsTime) {
  EXPECT_EQ(WordsOfDraft("/x/drafts/2026-11-22 09.30.05.parti"), "22 November 2026, 09:30");
  EXPECT_EQ(WordsOfDraft("/x/drafts/mine.parti"), "mine.parti");
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
  EXPECT_EQ(Words("split(x) { ~1: A | ~1: B | ~1: A | ~1: B }"), "Split across: 4 equal parts");
  EXPECT_EQ(Words("split(x) { ~2: A | ~4: B | ~2: A }"), "Split across: 1 : 2 : 1");
  EXPECT_EQ(Words("split(x) { ~1: A | 1.3: B | ~1: A }"), "Split across: 1.3 m in the middle");
  EXPECT_EQ(Words("split(y) { 1: A | ~3: B }"), "Split upward: 1 m, rest");
  EXPECT_EQ(Words("split(y) { ~1: A | ~2: B | 1: C }"), "Split upward: 1 × rest, 2 × rest, 1 m");
  EXPECT_EQ(Words("split(y) { 4: A | { ~3: B }* | 1: C }"),
            "Split upward: 4 m, repeated (about 3 m), 1 m");
  EXPECT_EQ(Words("comp(f) { side: A | top: B }"), "Take faces: side, top");
  EXPECT_EQ(Words("comp(fe) { all: A }"), "Take face edges: all");
  EXPECT_EQ(Words("roofGable(35)"), "Gable roof 35°");
  EXPECT_EQ(Words("roofHip(byHeight, 4)"), "Hip roof 4 m high");
  EXPECT_EQ(Words("shapeL(3, 4.5) { shape: A | remainder: B }"), "L shape: 3 m, 4.5 m");
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
  EXPECT_EQ(KeptTogether("{ … }* repeats"), "{\u00a0…\u00a0}* repeats");
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
