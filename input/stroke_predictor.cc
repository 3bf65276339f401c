#include "input/stroke_predictor.h"

#include <algorithm>
#include <cmath>

namespace parti::input {

void StrokePredictor::Begin() { *this = StrokePredictor(params_); }

void StrokePredictor::Add(const Vec2& position_mm, double t_s) {
  if (!IsFinite(position_mm) || !std::isfinite(t_s)) return;
  const Sample sample{position_mm, t_s};
  if (count_ > 0 && !(t_s > Back(0).t_s)) {
    samples_[newest_].position_mm = position_mm;
    Fit();
    return;
  }
  if (count_ > 0 && t_s - Back(0).t_s > params_.pause_s) count_ = 0;
  if (count_ > 0) Correct(sample);
  newest_ = (newest_ + 1) % kWindow;
  samples_[newest_] = sample;
  count_ = std::min(count_ + 1, kWindow);
  Fit();
}

void StrokePredictor::Correct(const Sample& sample) {
  const double step_s = sample.t_s - Back(0).t_s;
  const Vec2 foretold = WayAhead_mm(step_s), gone = sample.position_mm - Back(0).position_mm;
  const double kept = std::exp(-step_s / params_.memory_s);
  agreed_mm2_ = agreed_mm2_ * kept + glm::dot(foretold, gone);
  foretold_mm2_ = foretold_mm2_ * kept + glm::dot(foretold, foretold);
}

// Least squares of v t + b t^2 through the newest sample, a ridge on b: normal equations
// [s2 s3; s3 s4 + ridge] [v; b] = [m1; m2].
void StrokePredictor::Fit() {
  velocity_ = bend_ = Vec2(0, 0);
  if (count_ < 2) return;
  double s2 = 0, s3 = 0, s4 = 0;
  Vec2 m1(0, 0), m2(0, 0);
  for (size_t age = 1; age < count_; ++age) {
    const double t = Back(age).t_s - Back(0).t_s;
    const double weight = std::exp(t / params_.recency_s);
    const Vec2 way = Back(age).position_mm - Back(0).position_mm;
    s2 += weight * t * t;
    s3 += weight * t * t * t;
    s4 += weight * t * t * t * t;
    m1 += weight * t * way;
    m2 += weight * t * t * way;
  }
  s4 += params_.curb * std::pow(params_.recency_s, 4);
  const double determinant = s2 * s4 - s3 * s3;
  if (!(determinant > 0)) return;
  velocity_ = (m1 * s4 - m2 * s3) / determinant;
  bend_ = (m2 * s2 - m1 * s3) / determinant;
}

Vec2 StrokePredictor::WayAhead_mm(double ahead_s) const {
  const Vec2 way_mm = velocity_ * ahead_s + bend_ * (ahead_s * ahead_s);
  if (count_ < 2) return way_mm;
  return glm::dot(way_mm, Back(0).position_mm - Back(1).position_mm) > 0 ? way_mm : Vec2(0, 0);
}

std::optional<Vec2> StrokePredictor::Predict(double ahead_s) const {
  if (count_ == 0) return std::nullopt;
  const Vec2 last_mm = Back(0).position_mm;
  if (!(ahead_s > 0)) return last_mm;
  const double gain =
      (agreed_mm2_ + params_.doubt_mm2 * params_.gain) / (foretold_mm2_ + params_.doubt_mm2);
  const Vec2 predicted_mm =
      last_mm + std::clamp(gain, 0.0, 1.0) * WayAhead_mm(std::min(ahead_s, kFarthest_s));
  return IsFinite(predicted_mm) ? predicted_mm : last_mm;
}

}  // namespace parti::input
