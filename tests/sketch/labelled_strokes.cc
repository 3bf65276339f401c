#include "tests/sketch/labelled_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "base/json.h"
#include "sketch/stroke_path.h"

namespace parti::sketch {
namespace {

constexpr int kPoints = 48;  // as many as segbench.py takes

double SquaredDistance(const Vec2& p, const Segment2& chord) {
  const Vec2 along = chord.b - chord.a;
  const double squared = glm::dot(along, along);
  const double u = squared > 0 ? std::clamp(glm::dot(p - chord.a, along) / squared, 0.0, 1.0) : 0.0;
  const Vec2 off = p - chord.a - u * along;
  return glm::dot(off, off);
}

std::vector<Vec2> EvenPoints(const Stroke& stroke) {
  SegmentationParameters parameters;
  parameters.most_steps = kPoints - 1;
  return FilterStroke(stroke, parameters)->position;
}

}  // namespace

std::vector<LabelledStroke> ReadLabelledStrokes(const std::string& path) {
  std::vector<LabelledStroke> strokes;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const auto json = ParseJson(line, path);
    const auto stroke = StrokeFrom(json ? (*json)["points"] : Json(), "points");
    if (!json || !stroke) {
      ADD_FAILURE() << path << ": " << line.substr(0, 60);
      continue;
    }
    strokes.push_back({(*json)["id"], json->value("class", ""), json->value("subject", ""),
                       json->value("segments", 0), *stroke});
  }
  return strokes;
}

void SegmentationScore::Add(const LabelledStroke& truth, const Segmentation& answer) {
  const bool has_curve = std::any_of(answer.segments.begin(), answer.segments.end(),
                                     [](const auto& s) { return s.kind == SegmentKind::kCurve; });
  if (truth.segments == 0) {
    ++curved;
    found_curves += has_curve;
  } else {
    ++straight;
    right += static_cast<int>(answer.segments.size()) == truth.segments;
    false_curves += has_curve;
  }
}

std::vector<Vec2> BestCorners(const Stroke& stroke, int segments) {
  const std::vector<Vec2> p = EvenPoints(stroke);
  const int n = static_cast<int>(p.size());
  std::vector<std::vector<double>> error(n, std::vector<double>(n, 0));
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = i + 1; k < j; ++k) error[i][j] += SquaredDistance(p[k], {p[i], p[j]});
    }
  }
  std::vector<double> best = error[0];
  std::vector<std::vector<int>> back;
  for (int round = 1; round < segments; ++round) {
    std::vector<double> next(n, 1e300);
    std::vector<int> from(n, 0);
    for (int j = 2; j < n; ++j) {
      for (int i = 1; i < j; ++i) {
        if (best[i] + error[i][j] < next[j]) next[j] = best[i] + error[i][j], from[j] = i;
      }
    }
    best = next;
    back.push_back(from);
  }
  std::vector<Vec2> corners;
  int at = n - 1;
  for (auto from = back.rbegin(); from != back.rend(); ++from)
    corners.push_back(p[at = (*from)[at]]);
  std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace parti::sketch
