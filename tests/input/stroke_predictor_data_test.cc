// How well prediction does for people that it was not fitted to. The figures that it prints are
// those of docs/input.md.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <functional>

#include "base/json.h"
#include "base/text_file.h"
#include "input/stroke_predictor.h"
#include "tests/support/data.h"
#include "tests/support/evdev_recording.h"

namespace parti::input {
namespace {

struct Point {
  Vec2 position_mm{0, 0};
  double t_s = 0;
};
using Strokes = std::vector<std::vector<Point>>;

/// Strokes of a data file that `wanted` takes, scaled to millimetres; times that stand still are
/// left out.
Strokes Recorded(const std::string& path, double mm_per_unit,
                 const std::function<bool(const Json&)>& wanted) {
  Strokes strokes;
  const std::string text = *ReadFile(path);
  for (size_t at = 0; at < text.size();) {
    const size_t stop = std::min(text.find('\n', at), text.size());
    const Json line = *ParseJson(text.substr(at, stop - at));
    at = stop + 1;
    if (!wanted(line)) continue;
    auto& stroke = strokes.emplace_back();
    for (const Json& p : line.at("points")) {
      const Point point{Vec2(p[0], p[1]) * mm_per_unit, p[2].get<double>() * 1e-3};
      if (stroke.empty() || point.t_s > stroke.back().t_s) stroke.push_back(point);
    }
  }
  return strokes;
}

/// What a tablet's driver reported while its pen touched.
Strokes Reported(const std::string& path) {
  auto recording = *tests::ReadEvemu(*ReadFile(path), path);
  tests::AssumeResolution(200, &recording);
  Strokes strokes;
  Vec2 units(0, 0);
  bool touches = false;
  for (const auto& event : recording.events) {
    if (event.type == EV_ABS && event.code == ABS_X) units.x = event.value;
    if (event.type == EV_ABS && event.code == ABS_Y) units.y = event.value;
    if (event.type == EV_KEY && event.code == BTN_TOUCH) {
      touches = event.value != 0;
      if (touches) strokes.emplace_back();
    }
    if (event.type != EV_SYN || !touches) continue;
    const double t_s = static_cast<double>(event.t_us) * 1e-6;
    const Point point{units / double(recording.axes.at(ABS_X).resolution), t_s};
    if (strokes.back().empty() || t_s > strokes.back().back().t_s) strokes.back().push_back(point);
  }
  return strokes;
}

/// Where the pen was: on the straight line between two reports, at the end after the last.
Vec2 Truth(const std::vector<Point>& stroke, double t_s) {
  const auto after =
      std::find_if(stroke.begin(), stroke.end(), [&](const Point& p) { return p.t_s >= t_s; });
  if (after == stroke.end()) return stroke.back().position_mm;
  if (after == stroke.begin()) return after->position_mm;
  const Point& before = *std::prev(after);
  const double part = (t_s - before.t_s) / (after->t_s - before.t_s);
  return before.position_mm + (after->position_mm - before.position_mm) * part;
}

struct Errors {
  double mean_mm = 0;
  double p95_mm = 0;
};

Errors Summary(std::vector<double> errors_mm) {
  std::sort(errors_mm.begin(), errors_mm.end());
  Errors errors;
  for (const double error_mm : errors_mm) errors.mean_mm += error_mm;
  errors.mean_mm /= static_cast<double>(errors_mm.size());
  errors.p95_mm = errors_mm[errors_mm.size() * 95 / 100];
  return errors;
}

/// The mean error after every sample over that of standing still; both are printed.
double ErrorLeft(const char* name, const Strokes& strokes, double ahead_s) {
  std::vector<double> predicted_mm, still_mm;
  StrokePredictor predictor;
  for (const auto& stroke : strokes) {
    predictor.Begin();
    for (const Point& point : stroke) {
      predictor.Add(point.position_mm, point.t_s);
      const Vec2 truth = Truth(stroke, point.t_s + ahead_s);
      predicted_mm.push_back(glm::distance(*predictor.Predict(ahead_s), truth));
      still_mm.push_back(glm::distance(point.position_mm, truth));
    }
  }
  const Errors with = Summary(predicted_mm), without = Summary(still_mm);
  const double left = with.mean_mm / without.mean_mm;
  fmt::print("{}, {:.0f} ms ahead: mean {:.2f} mm instead of {:.2f} ({:.2f} left), ", name,
             ahead_s * 1e3, with.mean_mm, without.mean_mm, left);
  fmt::print("p95 {:.2f} instead of {:.2f}\n", with.p95_mm, without.p95_mm);
  EXPECT_LT(with.p95_mm, without.p95_mm * 0.62) << name;
  return left;
}

// Sizes: the PDA's 240 pixels are 57.6 mm; digital ink is in 1/96 inch.
constexpr double kPdaPixel_mm = 0.24, kInkUnit_mm = 25.4 / 96;

TEST(StrokePredictorData, HalvesTheErrorForPeopleItWasNotFittedTo) {
  PARTI_NEED_DATA(path, "strokes/unistrokes-dev.jsonl");
  const Strokes strokes = Recorded(path, kPdaPixel_mm, [](const Json& line) {
    return line.at("subject") == "s04" || line.at("subject") == "s05";
  });
  EXPECT_LT(ErrorLeft("unistrokes, 2 people", strokes, 0.008), 0.53);
  EXPECT_LT(ErrorLeft("unistrokes, 2 people", strokes, 0.016), 0.51);
}

TEST(StrokePredictorData, TakesAThirdOfTheErrorFromWritingAt25ReportsASecond) {
  PARTI_NEED_DATA(path, "strokes/wacom-ink-dev.jsonl");
  const Strokes strokes = Recorded(path, kInkUnit_mm, [](const Json& line) {
    return line.at("drawing").get<std::string>().starts_with("3)");
  });
  EXPECT_LT(ErrorLeft("writing at 25 Hz", strokes, 0.008), 0.72);
  EXPECT_LT(ErrorLeft("writing at 25 Hz", strokes, 0.016), 0.72);
}

TEST(StrokePredictorData, TakesMoreThanHalfOfTheErrorFromRealTablets) {
  PARTI_NEED_DATA(old_cintiq, "tablets/Wacom Cintiq 12WX.events");
  PARTI_NEED_DATA(cintiq, "tablets/Wacom Cintiq 13HD.events");
  PARTI_NEED_DATA(canvas, "tablets/dell_canvas_pen.evemu");
  Strokes strokes;
  for (const std::string& path : {old_cintiq, cintiq, canvas}) {
    const Strokes more = Reported(path);
    strokes.insert(strokes.end(), more.begin(), more.end());
  }
  EXPECT_LT(ErrorLeft("tablets at 140-170 Hz", strokes, 0.008), 0.45);
  EXPECT_LT(ErrorLeft("tablets at 140-170 Hz", strokes, 0.016), 0.45);
}

}  // namespace
}  // namespace parti::input
