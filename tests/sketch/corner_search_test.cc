#include "sketch/corner_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace parti::sketch {
namespace {

const SegmentationParameters kDefaults;

std::vector<int> Points(const std::vector<ChosenCorner>& corners) {
  std::vector<int> points;
  for (const ChosenCorner& corner : corners) points.push_back(corner.at);
  return points;
}

TEST(LineFits, BowIsTheDistanceFromTheBestLine) {
  const StrokePath path = *FilterStroke(StrokeFrom("0,0 100,0 100,100"), kDefaults);
  const LineFits fits(path);
  const int last = path.size() - 1;
  EXPECT_NEAR(fits.Bow(0, last / 2), 0, 1e-6);
  EXPECT_NEAR(fits.Bow(last / 2, last), 0, 1e-6);
  // Legs of length 1 about the line through their middles: sqrt(1/24) of a leg, in diagonals.
  EXPECT_NEAR(fits.Bow(0, last), std::sqrt(1.0 / 24 / 2), 2e-3) << "81 points stand for the legs";
}

TEST(LineFits, IsAsExactFarFromTheOrigin) {
  const StrokePath near = *FilterStroke(StrokeFrom("0,0 100,3 200,0"), kDefaults);
  const StrokePath far =
      *FilterStroke(StrokeFrom("1e9,1e9 1000000100,1000000003 1000000200,1e9"), kDefaults);
  const int last = near.size() - 1;
  EXPECT_NEAR(LineFits(far).Bow(0, last), LineFits(near).Bow(0, last), 1e-6);
}

TEST(ChooseCorners, WithoutCandidatesTheEndsRemain) {
  const StrokePath path = *FilterStroke(StrokeFrom("0,0 100,0"), kDefaults);
  const std::vector<double> price(path.position.size(), 0);
  const auto corners = ChooseCorners(path, {}, price, kDefaults);
  EXPECT_THAT(Points(corners), testing::ElementsAre(0, path.size() - 1));
  EXPECT_FALSE(corners.back().after_curve);
}

TEST(ChooseCorners, ACornerIsTakenWhenItsPriceIsLessThanTheBowItSaves) {
  const StrokePath path = *FilterStroke(StrokeFrom("0,0 100,0 200,12"), kDefaults);
  const int middle = path.size() / 2, last = path.size() - 1;
  const double bow = LineFits(path).Bow(0, last) / kDefaults.usual_bow;
  const double saved = kDefaults.bow_weight * std::log1p(bow * bow);
  std::vector<double> price(path.position.size(), 0.9 * saved);
  EXPECT_THAT(Points(ChooseCorners(path, {middle}, price, kDefaults)),
              testing::ElementsAre(0, middle, last));
  price.assign(price.size(), 1.1 * saved);
  EXPECT_THAT(Points(ChooseCorners(path, {middle}, price, kDefaults)),
              testing::ElementsAre(0, last));
}

// What the dynamic programme minimises, for one combination and one choice of kinds.
double CostOf(const StrokePath& path, const std::vector<double>& price,
              const std::vector<ChosenCorner>& corners) {
  const LineFits fits(path);
  double cost = 0;
  bool has_curve = false;
  for (size_t i = 1; i < corners.size(); ++i) {
    const int from = corners[i - 1].at, to = corners[i].at;
    if (i > 1) cost += price[from];
    const double length = (to - from) * path.step / path.diagonal;
    cost += kDefaults.short_weight * std::max(0.0, std::log(kDefaults.short_length / length));
    if (corners[i].after_curve) {
      cost += has_curve ? kDefaults.further_curve_price : kDefaults.curve_price;
      has_curve = true;
    } else {
      const double bow = fits.Bow(from, to) / kDefaults.usual_bow;
      cost += kDefaults.bow_weight * std::log1p(bow * bow);
    }
  }
  return cost;
}

RC_GTEST_PROP(ChooseCorners, NoCombinationIsCheaper, ()) {
  Stroke stroke;
  const int samples = *rc::gen::inRange(3, 12);
  for (int i = 0; i < samples; ++i) {
    const Vec2 p(*rc::gen::inRange(0, 200), *rc::gen::inRange(0, 200));
    stroke.push_back({p, 0.01 * i});
  }
  const auto path = FilterStroke(stroke, kDefaults);
  RC_PRE(path.has_value());
  const int last = path->size() - 1;
  const std::vector<int> candidates = {last / 5, last / 3, last / 2, 2 * last / 3};
  std::vector<double> price(path->position.size(), 0);
  for (double& p : price) p = 0.1 * *rc::gen::inRange(-50, 60);
  const double best = CostOf(*path, price, ChooseCorners(*path, candidates, price, kDefaults));
  for (int taken = 0; taken < 16; ++taken) {
    for (int curved = 0; curved < 32; ++curved) {
      std::vector<ChosenCorner> corners = {{0, false}};
      for (int c = 0; c < 4; ++c) {
        if (taken >> c & 1) corners.push_back({candidates[c], (curved >> c & 1) != 0});
      }
      corners.push_back({last, (curved >> 4 & 1) != 0});
      RC_ASSERT(best <= CostOf(*path, price, corners) + 1e-9);
    }
  }
}

}  // namespace
}  // namespace parti::sketch
