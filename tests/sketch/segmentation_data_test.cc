// What segmentation is worth on real pens: the figures of docs/segmentation.md, with room for
// change. All-or-nothing counts as segbench.py does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "sketch/segmentation.h"
#include "tests/sketch/labelled_strokes.h"
#include "tests/support/data.h"

namespace parti::sketch {
namespace {

const std::vector<LabelledStroke>& Gestures(const std::string& path) {
  static const std::vector<LabelledStroke> strokes = ReadLabelledStrokes(path);
  return strokes;
}

using Scores = std::map<std::string, SegmentationScore>;

// Scores per gesture, per subject, and "" for all, after `change` was made to every stroke.
template <typename Change>
Scores ScoresAfter(const std::vector<LabelledStroke>& strokes, Change change) {
  Scores scores;
  for (const LabelledStroke& truth : strokes) {
    Stroke stroke = truth.stroke;
    change(&stroke);
    const auto answer = SegmentStroke(stroke);
    if (!answer) {
      ADD_FAILURE() << truth.id << ": " << FormatError(answer.error());
      continue;
    }
    for (const std::string& key : {truth.gesture, truth.subject, std::string()}) {
      scores[key].Add(truth, *answer);
    }
  }
  return scores;
}

const auto kAsDrawn = [](Stroke*) {};

TEST(RealStrokes, NearlyAllCountsAreRightForEveryGestureAndPerson) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  Scores scores = ScoresAfter(Gestures(path), kAsDrawn);
  EXPECT_GE(scores[""].RightRate(), 0.98);
  for (const auto& [key, score] : scores) {
    if (score.straight > 0) {
      EXPECT_GE(score.RightRate(), 0.93) << key;
    }
  }
}

TEST(RealStrokes, CurvesAreToldFromLines) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  Scores scores = ScoresAfter(Gestures(path), kAsDrawn);
  EXPECT_LE(scores[""].FalseCurveRate(), 0.03);
  EXPECT_GE(scores[""].FoundCurveRate(), 0.95);
  for (const auto& [key, score] : scores) {
    if (score.curved > 0) {
      EXPECT_GE(score.FoundCurveRate(), 0.9) << key;
    }
  }
}

TEST(RealStrokes, CornersLieWhereTheNearestPolylineHasThem) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  std::vector<double> off;
  int number = 0;
  for (const LabelledStroke& truth : Gestures(path)) {
    if (truth.segments == 0 || ++number % 4 != 0) continue;
    const auto answer = SegmentStroke(truth.stroke);
    if (!answer || static_cast<int>(answer->segments.size()) != truth.segments) continue;
    const std::vector<Vec2> best = BestCorners(truth.stroke, truth.segments);
    for (size_t i = 0; i < best.size(); ++i) {
      const Vec2 corner = truth.stroke[answer->corners[i + 1]].position;
      off.push_back(glm::distance(corner, best[i]) / Diagonal(truth.stroke));
    }
  }
  std::sort(off.begin(), off.end());
  ASSERT_GT(off.size(), 500u);
  EXPECT_LE(off[off.size() / 2], 0.03);
  EXPECT_LE(off[off.size() * 95 / 100], 0.10);
}

TEST(RealStrokes, WithoutTimesTheCountsStayRight) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  Scores scores = ScoresAfter(Gestures(path), [](Stroke* stroke) {
    for (auto& sample : *stroke) sample.t_s = 0;
  });
  EXPECT_GE(scores[""].RightRate(), 0.97);
  EXPECT_LE(scores[""].FalseCurveRate(), 0.05);
}

TEST(RealStrokes, BatchedTimesTheCountsStayRight) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  Scores scores = ScoresAfter(Gestures(path), [](Stroke* stroke) {
    for (size_t i = 0; i < stroke->size(); ++i) {
      (*stroke)[i].t_s = (*stroke)[std::min(stroke->size() - 1, i / 4 * 4 + 3)].t_s;
    }
  });
  EXPECT_GE(scores[""].RightRate(), 0.97);
}

TEST(RealStrokes, ReversalMirrorsThem) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  int mirrored = 0, all = 0;
  for (const LabelledStroke& truth : Gestures(path)) {
    Stroke reversed(truth.stroke.rbegin(), truth.stroke.rend());
    for (auto& sample : reversed) sample.t_s = truth.stroke.back().t_s - sample.t_s;
    const auto forth = SegmentStroke(truth.stroke), back = SegmentStroke(reversed);
    ASSERT_TRUE(forth && back) << truth.id;
    const int last = static_cast<int>(reversed.size()) - 1;
    ++all;
    mirrored += std::equal(forth->corners.begin(), forth->corners.end(), back->corners.rbegin(),
                           back->corners.rend(),
                           [&](int a, int b) { return std::abs(a - (last - b)) <= 1; });
  }
  EXPECT_GE(mirrored, 0.99 * all);  // rounding tips a few even choices
}

TEST(RealStrokes, HandwritingOfAnotherPenSegmentsOrIsATap) {
  PARTI_NEED_DATA(path, "strokes/wacom-ink-dev.jsonl");
  int lines = 0, curves = 0, taps = 0;
  for (const LabelledStroke& ink : ReadLabelledStrokes(path)) {
    const auto answer = SegmentStroke(ink.stroke);
    if (!answer) {
      EXPECT_EQ(Diagonal(ink.stroke), 0) << ink.id;
      ++taps;
      continue;
    }
    EXPECT_LE(answer->segments.size(), 12u) << ink.id;
    for (const auto& s : answer->segments) ++(s.kind == SegmentKind::kLine ? lines : curves);
  }
  EXPECT_EQ(taps, 16);
  EXPECT_GT(lines, 1000);  // print: strokes of letters
  EXPECT_GT(curves, 500);  // and round letters
}

}  // namespace
}  // namespace parti::sketch
