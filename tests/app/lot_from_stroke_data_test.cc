// What drawing a lot is worth with real hands: gestures of 15 people, laid on the ground and seen
// in perspective.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "app/lot.h"
#include "app/lot_from_stroke.h"
#include "base/random.h"
#include "tests/app/ground_strokes.h"
#include "tests/support/data.h"

namespace parti::app {
namespace {

using Corners = std::vector<Vec2>;

Corners Path(const Stroke& stroke) {
  Corners path;
  for (const StrokeSample& sample : stroke) path.push_back(sample.position);
  return path;
}

/// The cosine of the angle at corner i.
double CosineAt(const Corners& ring, size_t i) {
  const size_t n = ring.size();
  const Vec2 u = ring[(i + n - 1) % n] - ring[i], v = ring[(i + 1) % n] - ring[i];
  return glm::dot(glm::normalize(u), glm::normalize(v));
}

bool IsRectangle(const Corners& ring) {
  if (ring.size() != 4) return false;
  for (size_t i = 0; i < 4; ++i) {
    if (std::abs(CosineAt(ring, i)) > 1e-3) return false;
  }
  return true;
}

bool IsRound(const Corners& ring) {
  return ring.size() >= 12 && std::all_of(ring.begin(), ring.end(), [&](const Vec2& p) {
           const size_t i = static_cast<size_t>(&p - ring.data());
           return CosineAt(ring, i) < -0.6;  // no corner sharper than 127 degrees
         });
}

bool IsAsMeant(const std::string& gesture, const Corners& ring) {
  if (gesture == "rectangle") return IsRectangle(ring);
  if (gesture == "triangle") return ring.size() == 3;
  return IsRound(ring);
}

struct Rates {
  int all = 0;
  int made = 0;      ///< became a lot
  int lots = 0;      ///< became a lot that covers what was drawn
  int as_meant = 0;  ///< and has the corners of its class
  double Lots() const { return static_cast<double>(lots) / all; }
  double AsMeant() const { return static_cast<double>(as_meant) / all; }
};

template <typename Change>
std::map<std::string, Rates> RatesAfter(const std::string& path,
                                        const std::vector<std::string>& names, Change change) {
  std::map<std::string, Rates> rates;
  for (const Gesture& gesture : ReadGestures(path, names)) {
    Rates& r = rates[gesture.name];
    ++r.all;
    Stroke laid = LaidOut(gesture.stroke, 16);
    change(&laid);
    const std::vector strokes = {SeenFrom(GroundView(), laid)};
    const auto lot = LotFromStrokes(strokes);
    if (!lot) continue;
    EXPECT_TRUE(ParseLots(*lot)) << gesture.id << ": " << *lot;  // (2)
    ++r.made;
    const Corners ring = CornersOf(*lot);
    const bool covers = Overlap(ring, Path(laid)) > 0.6;
    r.lots += covers;
    r.as_meant += covers && IsAsMeant(gesture.name, ring);
  }
  return rates;
}

/// Shares of the lots and of those as meant, for every closed class.
void ExpectRates(const std::map<std::string, Rates>& rates, double lots, double as_meant) {
  ASSERT_EQ(rates.size(), 3u);
  for (const auto& [name, r] : rates) {
    EXPECT_EQ(r.all, 150) << name;
    EXPECT_GE(r.Lots(), lots) << name;
    EXPECT_GE(r.AsMeant(), as_meant) << name;
    ::testing::Test::RecordProperty(name, fmt::format("{} {} {}", r.all, r.lots, r.as_meant));
  }
}

const std::vector<std::string> kClosed = {"rectangle", "circle", "triangle"};

TEST(DrawnLotDataTest, NearlyAllOutlinesBecomeTheLotsThatWereMeant) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  ExpectRates(RatesAfter(path, kClosed, [](Stroke*) {}), 0.97, 0.96);
}

TEST(DrawnLotDataTest, TheDirectionDrawnInDoesNotMatter) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  ExpectRates(RatesAfter(path, kClosed,
                         [](Stroke* stroke) {
                           const double end_s = stroke->back().t_s;
                           std::reverse(stroke->begin(), stroke->end());
                           for (StrokeSample& sample : *stroke) sample.t_s = end_s - sample.t_s;
                         }),
              0.97, 0.96);
}

TEST(DrawnLotDataTest, ATremblingPenAndNoTimesCostLittle) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  Random random(5);
  ExpectRates(RatesAfter(path, kClosed,
                         [&](Stroke* stroke) {
                           for (StrokeSample& sample : *stroke) {
                             sample.position += 0.08 * Vec2(random.Normal(), random.Normal());
                             sample.t_s = 0;
                           }
                         }),
              0.95, 0.90);
}

TEST(DrawnLotDataTest, WhatEnclosesNothingIsNoLot) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  const std::vector<std::string> open = {"arrow", "caret", "check", "left_sq_bracket",
                                         "v",     "star",  "x"};
  const auto rates = RatesAfter(path, open, [](Stroke*) {});
  ASSERT_EQ(rates.size(), open.size());
  for (const auto& [name, r] : rates) EXPECT_LE(r.made, name == "x" ? 20 : 3) << name;
}

}  // namespace
}  // namespace parti::app
