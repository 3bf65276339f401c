// How much of the numbers marked "fitted" in SegmentationParameters carries over to a person who
// took no part in the fit: a search from plain numbers, judged on the person left out. Takes
// minutes, so it runs only on demand: PARTI_FIT=1 parti_sketch_tests
// --gtest_filter='SegmentationFit*'
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include "base/random.h"
#include "sketch/segmentation.h"
#include "tests/sketch/labelled_strokes.h"
#include "tests/support/data.h"

namespace parti::sketch {
namespace {

using P = SegmentationParameters;

constexpr std::array kFitted = {&P::corner_price, &P::turn_weight, &P::slowness_weight,
                                &P::bow_weight,   &P::usual_bow,   &P::curve_price,
                                &P::short_weight};
constexpr int kTries = 350;
constexpr int kDraws = 3;
constexpr double kDrawSpread = 0.08;      // of the logarithm of each number
constexpr double kWrongKindWeight = 0.3;  // against a wrong count
constexpr double kShortestSingle = 0.3;   // diagonals of its stroke
constexpr int kEveryNthSingle = 25;       // so that single lines weigh as much as a gesture

// Gestures have two lines or more; most lines of a sketch are drawn alone. So some lines of rightly
// segmented gestures are added as strokes of their own.
std::vector<LabelledStroke> SingleLines(const std::vector<LabelledStroke>& strokes) {
  std::vector<LabelledStroke> singles;
  int number = 0;
  for (const LabelledStroke& truth : strokes) {
    const auto answer = SegmentStroke(truth.stroke);
    if (!answer || static_cast<int>(answer->segments.size()) != truth.segments) continue;
    for (const StrokeSegment& s : answer->segments) {
      const Stroke line(truth.stroke.begin() + s.from, truth.stroke.begin() + s.to + 1);
      if (Diagonal(line) < kShortestSingle * Diagonal(truth.stroke)) continue;
      if (++number % kEveryNthSingle == 0) {
        singles.push_back({truth.id, "single line", truth.subject, 1, line});
      }
    }
  }
  return singles;
}

SegmentationScore ScoreOf(const std::vector<LabelledStroke>& strokes, const P& parameters,
                          const auto& takes_part) {
  SegmentationScore score;
  for (const LabelledStroke& truth : strokes) {
    if (!takes_part(truth.subject)) continue;
    const auto answer = SegmentStroke(truth.stroke, parameters);
    if (answer) score.Add(truth, *answer);
  }
  return score;
}

double Loss(const SegmentationScore& score) {
  const int wrong = score.straight - score.right;
  const int wrong_kind = score.curved - score.found_curves;
  return (wrong + wrong_kind + kWrongKindWeight * score.false_curves) /
         (score.straight + score.curved);
}

// The loss is a step function; averaged over draws about the parameters it has a slope, and its
// minimum is one that holds for its neighbours too. The draws are the same for all.
double SmoothLoss(const std::vector<LabelledStroke>& strokes, const P& parameters,
                  const auto& takes_part) {
  Random random(11);
  double loss = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    P drawn = parameters;
    for (const auto field : kFitted) drawn.*field *= std::exp(kDrawSpread * random.Normal());
    loss += Loss(ScoreOf(strokes, drawn, takes_part)) / kDraws;
  }
  return loss;
}

// Coordinate search with steps that grow on success and shrink on failure. Starts away from the
// defaults, at plain numbers, so that these don't hand down what they know of the person left out.
P Fit(const std::vector<LabelledStroke>& strokes, const auto& takes_part) {
  P best;
  for (const auto field : kFitted) best.*field = 4;
  best.turn_weight = 1;
  best.usual_bow = 0.03;
  double least = SmoothLoss(strokes, best, takes_part);
  std::array<double, kFitted.size()> step;
  step.fill(0.3);
  Random random(5);
  for (int i = 0; i < kTries; ++i) {
    const size_t which = i % kFitted.size();
    P tried = best;
    tried.*kFitted[which] *= std::exp(step[which] * random.Normal());
    const double loss = SmoothLoss(strokes, tried, takes_part);
    step[which] *= loss < least ? 1.5 : 0.9;
    if (loss < least) least = loss, best = tried;
  }
  return best;
}

std::string Row(const std::string& name, const SegmentationScore& score, const P& parameters) {
  std::string row = fmt::format("| {} | {:.1f} | {:.1f} | {:.1f} |", name, 100 * score.RightRate(),
                                100 * score.FalseCurveRate(), 100 * score.FoundCurveRate());
  for (const auto field : kFitted) row += fmt::format(" {:.3g} |", parameters.*field);
  return row;
}

TEST(SegmentationFit, LeaveOnePersonOut) {
  if (!std::getenv("PARTI_FIT")) GTEST_SKIP() << "takes minutes: set PARTI_FIT=1 to fit";
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  const std::vector<LabelledStroke> gestures = ReadLabelledStrokes(path);
  std::vector<LabelledStroke> training = gestures;
  for (const LabelledStroke& line : SingleLines(gestures)) training.push_back(line);
  std::set<std::string> people;
  for (const LabelledStroke& stroke : gestures) people.insert(stroke.subject);
  SegmentationScore held_out;
  for (const std::string& person : people) {
    const P fitted = Fit(training, [&](const std::string& who) { return who != person; });
    const auto is_left_out = [&](const std::string& who) { return who == person; };
    fmt::print("{}\n", Row(person, ScoreOf(gestures, fitted, is_left_out), fitted));
    for (const LabelledStroke& truth : gestures) {
      if (truth.subject == person) held_out.Add(truth, *SegmentStroke(truth.stroke, fitted));
    }
  }
  const auto everyone = [](const std::string&) { return true; };
  const P fitted = Fit(training, everyone);
  fmt::print("{}\n", Row("fitted to all", ScoreOf(gestures, fitted, everyone), fitted));
  fmt::print("{}\n", Row("defaults", ScoreOf(gestures, {}, everyone), {}));
  EXPECT_GE(held_out.RightRate(), 0.95);
  EXPECT_LE(held_out.FalseCurveRate(), 0.05);
  EXPECT_GE(held_out.FoundCurveRate(), 0.90);
}

}  // namespace
}  // namespace parti::sketch
