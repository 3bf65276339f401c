#include "sketch/descent.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using tests::At;
using tests::Drawn;

Result<Adjusted> AdjustTo(const std::vector<Segment3>& lines, const Hypothesis& hypothesis,
                          const grammar::Item& item) {
  const SketchParameters parameters;
  const SketchedLines sketched(Drawn(lines, tests::HouseCamera()), parameters.noise);
  return Adjust(hypothesis, MadeEdges(item), sketched, parameters);
}

double Number(const Adjusted& adjusted) {
  return std::get<double>(adjusted.hypothesis.action.arguments[0]);
}

TEST(Descent, FindsTheHeightOfAnExtrusion) {
  const auto lot = tests::Lot();
  const auto extrude = grammar::FindOperation("extrude");
  const auto adjusted =
      AdjustTo({{At(lot, 20, 0), At(lot, 20, 0, 7)}}, {ActionOfLength(*extrude, 4.5)}, lot);
  ASSERT_TRUE(adjusted);
  EXPECT_NEAR(Number(*adjusted), 7, 0.01);
}

TEST(Descent, FindsTheDistanceOfAnOffset) {
  const auto lot = tests::Lot();
  const auto offset = grammar::FindOperation("offset");
  const auto adjusted = AdjustTo({{At(lot, 2, 2), At(lot, 18, 2)}, {At(lot, 2, 2), At(lot, 2, 10)}},
                                 {OffsetAction(*offset, -1.2)}, lot);
  ASSERT_TRUE(adjusted);
  EXPECT_NEAR(Number(*adjusted), -2, 0.01);
}

TEST(Descent, RefusesWhatTheOperationRefuses) {
  const auto lot = tests::Lot();
  const auto extrude = grammar::FindOperation("extrude");
  EXPECT_FALSE(AdjustTo({{At(lot, 20, 0), At(lot, 20, 0, 7)}}, {ActionOfLength(*extrude, 0)}, lot));
}

TEST(Descent, OneSlipDoesNotPullTheOthersAway) {
  const auto facade = tests::Facade();
  const auto split = grammar::FindOperation("split");
  const auto adjusted =
      AdjustTo({{At(facade, 0, 3), At(facade, 16, 3)}, {At(facade, 9, 1), At(facade, 12, 8)}},
               {SplitAction(*split, grammar::Axis::kY, {2.6, 6.4}, {0, 1})}, facade);
  ASSERT_TRUE(adjusted);
  EXPECT_NEAR(std::get<grammar::Size>(adjusted->hypothesis.action.successors[0].key).value, 3, 0.1);
}

// Lines across the façade at random places, and a split that starts somewhere else.
struct SplitCase {
  std::vector<Segment3> lines;
  std::vector<double> sizes;
};

SplitCase RandomCase(Random* random, const grammar::Item& facade) {
  SplitCase c;
  double last = 0;
  for (int i = 1; i <= 3; ++i) {
    const double at = 4.0 * i + random->Uniform(-1, 1);
    c.lines.push_back({At(facade, at, random->Uniform(-0.3, 0.3)),
                       At(facade, at + random->Uniform(-0.3, 0.3), 9)});
    const double start = at + random->Uniform(-0.8, 0.8);
    c.sizes.push_back(start - last);
    last = start;
  }
  c.sizes.push_back(16 - last);
  return c;
}

RC_GTEST_PROP(Descent, ErrorNeverGrows, ()) {  // property 1
  Random random(*rc::gen::arbitrary<uint64_t>());
  const auto facade = tests::Facade();
  const SplitCase c = RandomCase(&random, facade);
  const auto split = grammar::FindOperation("split");
  const auto adjusted =
      AdjustTo(c.lines, {SplitAction(*split, grammar::Axis::kX, c.sizes, {0, 1, 2, 3})}, facade);
  RC_ASSERT(adjusted.has_value());
  RC_ASSERT(adjusted->match.error <= adjusted->first_error);
  const auto again = AdjustTo(c.lines, adjusted->hypothesis, facade);  // property 3
  RC_ASSERT(again.has_value());
  RC_ASSERT(again->match.error >= adjusted->match.error * 0.98 - 1e-9);
}

RC_GTEST_PROP(Descent, TiedSizesStayEqual, ()) {  // property 2
  Random random(*rc::gen::arbitrary<uint64_t>());
  const auto facade = tests::Facade();
  const SplitCase c = RandomCase(&random, facade);
  const auto split = grammar::FindOperation("split");
  Hypothesis tied{SplitAction(*split, grammar::Axis::kX, {3.9, 5, 3.9, 3.2}, {0, 1, 0, 2})};
  tied.equal = {{0, 2}};
  const auto adjusted = AdjustTo(c.lines, tied, facade);
  RC_ASSERT(adjusted.has_value());
  const auto& sizes = adjusted->hypothesis.action.successors;
  RC_ASSERT(sizes[0].key == sizes[2].key);
  RC_ASSERT(adjusted->match.error <= adjusted->first_error);
}

}  // namespace
}  // namespace parti::sketch
