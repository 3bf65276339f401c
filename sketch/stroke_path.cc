#include "sketch/stroke_path.h"

#include <algorithm>
#include <cmath>

namespace parti::sketch {
namespace {

Result<void> Check(const Stroke& stroke) {
  for (const StrokeSample& s : stroke) {
    if (!IsFinite(s.position) || !std::isfinite(s.t_s)) {
      return Fail(ErrorCode::kBadNumber, "a sample of the stroke is not finite");
    }
  }
  if (!(Diagonal(stroke) > 0)) {
    return Fail(ErrorCode::kTooShort, "the stroke has fewer than 2 distinct positions",
                "draw a line, a tap has no segments");
  }
  return {};
}

// A run of samples with one time, seen as a knot at its middle.
struct Batch {
  double middle;  // index
  double t_s;
  size_t end;  // index after the last
};

Batch BatchAt(const Stroke& stroke, size_t from) {
  size_t end = from + 1;
  while (end < stroke.size() && stroke[end].t_s <= stroke[from].t_s) ++end;
  return {0.5 * static_cast<double>(from + end - 1), stroke[from].t_s, end};
}

// Walks along a stroke in steps of path length.
class Walker {
 public:
  explicit Walker(const Stroke& stroke) : stroke_(stroke), times_(SpreadTimes(stroke)) {}

  void AppendPointAt(double distance, StrokePath* path) {
    while (at_ + 2 < stroke_.size() && passed_ + Leg() < distance) {
      passed_ += Leg();
      ++at_;
    }
    const double leg = Leg();
    const double u = leg > 0 ? std::clamp((distance - passed_) / leg, 0.0, 1.0) : 0.0;
    path->position.push_back(glm::mix(stroke_[at_].position, stroke_[at_ + 1].position, u));
    path->t_s.push_back(std::lerp(times_[at_], times_[at_ + 1], u));
    path->sample.push_back(static_cast<int>(u < 0.5 ? at_ : at_ + 1));
  }
  void AppendLastPoint(StrokePath* path) const {
    path->position.push_back(stroke_.back().position);
    path->t_s.push_back(times_.back());
    path->sample.push_back(static_cast<int>(stroke_.size()) - 1);
  }

 private:
  double Leg() const { return glm::distance(stroke_[at_].position, stroke_[at_ + 1].position); }

  const Stroke& stroke_;
  std::vector<double> times_;
  size_t at_ = 0;      // the leg from sample at_ to the next
  double passed_ = 0;  // path length up to sample at_
};

int StepsOf(double length, double diagonal, const SegmentationParameters& p) {
  const double wanted = std::ceil(length / diagonal * p.steps_per_diagonal);
  return static_cast<int>(std::min<double>(wanted, p.most_steps));
}

}  // namespace

int StrokePath::Steps(double diagonals) const {
  const double steps = std::round(diagonals * diagonal / step);
  return static_cast<int>(std::clamp<double>(steps, 1, size()));
}

std::vector<double> SpreadTimes(const Stroke& stroke) {
  std::vector<double> times(stroke.size());
  if (stroke.empty()) return times;
  Batch batch = BatchAt(stroke, 0);
  size_t i = 0;
  for (; static_cast<double>(i) <= batch.middle; ++i) times[i] = batch.t_s;
  while (batch.end < stroke.size()) {
    const Batch next = BatchAt(stroke, batch.end);
    const double rate = (next.t_s - batch.t_s) / (next.middle - batch.middle);
    for (; static_cast<double>(i) <= next.middle; ++i) {
      times[i] = batch.t_s + rate * (static_cast<double>(i) - batch.middle);
    }
    batch = next;
  }
  for (; i < stroke.size(); ++i) times[i] = batch.t_s;
  return times;
}

Result<StrokePath> FilterStroke(const Stroke& stroke, const SegmentationParameters& parameters) {
  const Result<void> checked = Check(stroke);
  if (!checked) return Fail(checked);
  StrokePath path;
  path.diagonal = Diagonal(stroke);
  const double length = PathLength(stroke);
  const int steps = StepsOf(length, path.diagonal, parameters);
  path.step = length / steps;
  const auto points = static_cast<size_t>(steps) + 1;
  path.position.reserve(points);
  path.t_s.reserve(points);
  path.sample.reserve(points);
  Walker walker(stroke);
  for (int i = 0; i < steps; ++i) walker.AppendPointAt(i * path.step, &path);
  walker.AppendLastPoint(&path);
  return path;
}

}  // namespace parti::sketch
