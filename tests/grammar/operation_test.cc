// The table itself: looking up, checking, dials and samples.
#include "grammar/operation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/grammar/geometry_support.h"

namespace parti::grammar::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = Selector::Kind;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ErrorCode CodeOf(const Action& action) {
  const auto checked = Check(action);
  EXPECT_FALSE(checked.has_value());
  if (checked) return ErrorCode::kFile;
  EXPECT_FALSE(checked.error().message.empty());
  return checked.error().code;
}

TEST(OperationTable, NamesAndWordsAreUnique) {
  std::set<std::string_view> names, words;
  for (const Operation& row : Operations()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(words.insert(row.word).second) << row.word;
    EXPECT_EQ(FindOperation(row.name), &row);
    EXPECT_FALSE(row.doc.empty()) << row.name;
    EXPECT_FALSE(row.source.empty()) << row.name;
    EXPECT_NE(row.apply, nullptr) << row.name;
    EXPECT_EQ(row.braces == Braces::kSelectors, !row.selectors.empty()) << row.name;
  }
  EXPECT_GE(names.size(), 8u);
}

TEST(OperationTable, MisspeltNameGetsAHint) {
  const auto row = OperationNamed("extrde");
  ASSERT_FALSE(row.has_value());
  EXPECT_EQ(row.error().code, ErrorCode::kUnknownName);
  EXPECT_THAT(row.error().hint, HasSubstr("'extrude'"));
  EXPECT_THAT(OperationNamed("xyzzy").error().hint, HasSubstr("extrude, split"));
}

TEST(OperationTable, DefaultHasOneArgumentPerParameter) {
  for (const Operation& row : Operations()) {
    const Action action = Default(row);
    EXPECT_EQ(action.operation, &row);
    EXPECT_EQ(action.arguments.size(), row.parameters.size());
    EXPECT_TRUE(action.successors.empty());
    EXPECT_EQ(Check(action).has_value(), row.braces == Braces::kNone) << row.name;
  }
}

TEST(CheckArgument, KnowsSwitchesAndSizes) {
  const Operation& row = *FindOperation("extrude");
  const Parameter on{.name = "on", .kind = ParameterKind::kBool, .default_value = true, .doc = ""};
  EXPECT_TRUE(CheckArgument(row, on, false));
  EXPECT_FALSE(CheckArgument(row, on, 1.0));
  const Parameter move{.name = "x",
                       .kind = ParameterKind::kSize,
                       .low = -10,
                       .high = 10,
                       .default_value = Size{},
                       .doc = ""};
  EXPECT_TRUE(CheckArgument(row, move, Size{Size::Kind::kRelative, 30}));
  EXPECT_TRUE(CheckArgument(row, move, Size{Size::Kind::kAbsolute, -3}));
  EXPECT_FALSE(CheckArgument(row, move, Size{Size::Kind::kAbsolute, 30}));
  EXPECT_FALSE(CheckArgument(row, move, Size{Size::Kind::kRelative, kNaN}));
  EXPECT_FALSE(CheckArgument(row, move, Size{Size::Kind::kFloating, 1}));
  EXPECT_FALSE(CheckArgument(row, move, 3.0));
}

TEST(Check, RefusesWrongArguments) {
  EXPECT_EQ(CodeOf(Action{}), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("extrude", {})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("extrude", {3.0, 2.0})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("extrude", {std::string("3")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("extrude", {kNaN})), ErrorCode::kBadNumber);
  EXPECT_EQ(CodeOf(Make("extrude", {1e300})), ErrorCode::kBadNumber);
  EXPECT_EQ(CodeOf(Make("color", {std::string("reddish")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("color", {std::string("#12345g")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("tag", {std::string()})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("tag", {std::string("a")}, {}, "Symbol")), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("comp", {std::string("x")}, {Selected(Kind::kAll, "A")})),
            ErrorCode::kBadArguments);
}

TEST(Check, RefusesWrongBraces) {
  EXPECT_EQ(CodeOf(Make("extrude", {3.0}, {Metres(1, "A")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Split(Axis::kX, {})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Split(Axis::kX, {Selected(Kind::kAll, "A")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Split(Axis::kX, {Metres(kNaN, "A")})), ErrorCode::kBadNumber);
  EXPECT_EQ(CodeOf(Split(Axis::kX, {Group({Metres(1e300, "A")})})), ErrorCode::kBadNumber);
  EXPECT_EQ(CodeOf(Comp({Metres(1, "A")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Comp({Selected(Kind::kRemainder, "A")})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Comp({Selected(Kind::kIndex, "A", -1)})), ErrorCode::kBadNumber);
  EXPECT_EQ(CodeOf(Comp({Group({Selected(Kind::kAll, "A")})})), ErrorCode::kBadArguments);
  EXPECT_EQ(CodeOf(Make("offset", {-1.0}, {Selected(Kind::kTop, "A")})), ErrorCode::kBadArguments);
  Action with_symbol = Split(Axis::kX, {Metres(1, "A")});
  with_symbol.symbol = "B";
  EXPECT_EQ(CodeOf(with_symbol), ErrorCode::kBadArguments);
}

TEST(Check, OnlyInPlaceActionsStandBeforeASymbol) {
  Successor tagged = Metres(4, "Ground");
  tagged.actions = {Make("tag", {std::string("x")})};
  EXPECT_TRUE(Check(Split(Axis::kY, {tagged})).has_value());
  tagged.actions = {Extrude(3)};
  EXPECT_EQ(CodeOf(Split(Axis::kY, {tagged})), ErrorCode::kBadArguments);
  tagged.actions = {Make("tag", {})};
  EXPECT_EQ(CodeOf(Split(Axis::kY, {tagged})), ErrorCode::kBadArguments);
}

TEST(Check, RefusesRepeatGroupsWithoutEnd) {
  Successor nested = Metres(1, "A");
  for (int i = 0; i < 1000; ++i) nested = Group({nested});
  EXPECT_EQ(CodeOf(Split(Axis::kX, {nested})), ErrorCode::kBadArguments);
}

TEST(Apply, NamesOperationAndTypeOfAWrongItem) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item mass = Apply(Extrude(3), lot)->front().item;
  const auto made = Apply(Extrude(3), mass);
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().code, ErrorCode::kWrongItemType);
  EXPECT_THAT(made.error().message, HasSubstr("extrude"));
  EXPECT_THAT(made.error().message, HasSubstr("VolumetricShape"));
  EXPECT_EQ(Apply(OffsetBy(-1), mass).error().code, ErrorCode::kWrongItemType);
}

TEST(SuccessorAt, CountsDepthFirstThroughGroups) {
  const Action action = Split(
      Axis::kX, {Metres(1, "A"), Group({Metres(1, "B"), Group({Metres(1, "C")}), Metres(1, "D")}),
                 Metres(1, "E")});
  std::string symbols;
  for (int i = 0; i < 5; ++i) symbols += SuccessorAt(action, i).symbol;
  EXPECT_EQ(symbols, "ABCDE");
}

TEST(Dials, AreArgumentsThenSizesInReadingOrder) {
  Action action = Split(Axis::kX, {Metres(4, "A"), Group({Share(0.25, "B"), Floating(3, "C")})});
  const auto dials = Dials(&action);
  std::vector<std::string> names;
  for (const Dial& dial : dials) names.push_back(dial.name);
  EXPECT_THAT(names, ElementsAre("sizes[0]", "sizes[1]", "sizes[2]"));
  *dials[2].value = 5;
  EXPECT_EQ(std::get<Size>(SuccessorAt(action, 2).key).value, 5);
  EXPECT_EQ(dials[1].high, 1);
  Action extrude = Extrude(7);
  EXPECT_EQ(*Dials(&extrude).at(0).value, 7);
  Action tag = Make("tag", {std::string("x")});
  EXPECT_TRUE(Dials(&tag).empty());
}

TEST(Samples, AllPassCheckAndApply) {
  const Item lot = Lot("0,0 10,0 10,8 0,8");
  const Item mass = Apply(Extrude(6), lot)->front().item;
  const std::vector<double> lengths = {1, 2.5, 7};
  std::map<std::string_view, size_t> count;
  for (const Item& item : {lot, mass}) {
    for (const Operation& row : Operations()) {
      for (const Action& sample : Samples(row, item, lengths)) {
        ASSERT_TRUE(Check(sample).has_value()) << row.name;
        const auto products = Apply(sample, item);
        ASSERT_TRUE(products.has_value()) << row.name << ": " << products.error().message;
        EXPECT_FALSE(products->empty()) << row.name;
        ++count[row.name];
      }
    }
  }
  EXPECT_EQ(count["extrude"], 6u);
  EXPECT_EQ(count["offset"], 6u);
  EXPECT_EQ(count["split"], 6u + 8u);  // 7 m fit neither the mass's 6 m …
  EXPECT_EQ(count["repeat"], 6u + 8u);
  EXPECT_EQ(count["comp"], 1u);
  for (const char* roof : {"roofHip", "roofGable", "roofPyramid", "roofShed"}) {
    EXPECT_EQ(count[roof], 3u) << roof;  // of the lot
  }
  EXPECT_EQ(count.size(), 9u);
}

TEST(Action, EqualityLooksIntoGroups) {
  const auto action = [](double size) {
    return Split(Axis::kX, {Group({Group({Metres(size, "A")})})});
  };
  EXPECT_EQ(action(3), action(3));
  EXPECT_NE(action(3), action(4));
  EXPECT_NE(Split(Axis::kX, {Metres(3, "A")}), Split(Axis::kY, {Metres(3, "A")}));
}

TEST(Selector, NamesReadBack) {
  for (int i = 0; i <= static_cast<int>(Kind::kRemainder); ++i) {
    const auto kind = static_cast<Kind>(i);
    if (kind == Kind::kIndex) continue;
    EXPECT_EQ(SelectorNamed(NameOf(kind)), kind);
  }
  EXPECT_EQ(SelectorNamed("index"), std::nullopt);
  EXPECT_EQ(SelectorNamed("sideways"), std::nullopt);
  EXPECT_EQ(NameOf(Axis::kZ), "z");
}

}  // namespace
}  // namespace parti::grammar::tests
