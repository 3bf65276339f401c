#include "sketch/speed_curvature.h"

#include <algorithm>
#include <cmath>

namespace parti::sketch {
namespace {

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// How far the speed of a stroke tells its corners, [0, 1]. The ends don't count: every pen starts
// and stops.
double TrustInSpeed(const StrokePath& path, const std::vector<double>& slowness,
                    const SegmentationParameters& p) {
  const int margin = path.Steps(p.near_span);
  double slowest = 0;
  for (int i = margin; i < path.size() - margin; ++i) slowest = std::max(slowest, slowness[i]);
  return std::min(1.0, slowest / p.telling_slowness);
}

double ExpectedSlowness(double turn, const SegmentationParameters& p) {
  return std::clamp(p.slowness_per_turn * (turn - p.free_turn), 0.0, p.usual_slowness);
}

bool IsCheapestAround(const std::vector<double>& price, int at, int steps) {
  const int last = static_cast<int>(price.size()) - 1;
  for (int i = std::max(0, at - steps); i < at; ++i) {
    if (price[i] < price[at]) return false;
  }
  for (int i = at + 1; i <= std::min(last, at + steps); ++i) {
    if (price[i] <= price[at]) return false;  // of equals the last, so that one is left
  }
  return true;
}

// Sparse recordings have several points of the path at one sample; the cheapest stands for it.
void KeepOnePerSample(const StrokePath& path, const std::vector<double>& price,
                      std::vector<int>* candidates) {
  std::vector<int> kept;
  for (const int at : *candidates) {
    const int sample = path.sample[at];
    if (sample == path.sample.front() || sample == path.sample.back()) continue;
    if (!kept.empty() && path.sample[kept.back()] == sample) {
      if (price[at] < price[kept.back()]) kept.back() = at;
    } else {
      kept.push_back(at);
    }
  }
  *candidates = std::move(kept);
}

void KeepCheapest(const std::vector<double>& price, int most, std::vector<int>* candidates) {
  if (static_cast<int>(candidates->size()) <= most) return;
  const auto cheaper = [&](int a, int b) { return price[a] < price[b]; };
  std::stable_sort(candidates->begin(), candidates->end(), cheaper);
  candidates->resize(static_cast<size_t>(most));
  std::sort(candidates->begin(), candidates->end());
}

}  // namespace

double TurnAt(const StrokePath& path, int at, int steps) {
  const int last = path.size() - 1;
  const Vec2 in = path.position[at] - path.position[std::max(0, at - steps)];
  const Vec2 out = path.position[std::min(last, at + steps)] - path.position[at];
  return std::atan2(std::abs(Cross(in, out)), glm::dot(in, out));  // 0 for a chord without length
}

std::vector<double> Slowness(const StrokePath& path, const SegmentationParameters& parameters) {
  const int last = path.size() - 1;
  const int steps = path.Steps(parameters.speed_span);
  std::vector<double> slowness(path.position.size(), 0.0);
  const double duration = path.t_s.back() - path.t_s.front();
  if (!(duration > 0)) return slowness;
  for (int i = 0; i <= last; ++i) {
    const int from = std::max(0, i - steps), to = std::min(last, i + steps);
    slowness[i] = (path.t_s[to] - path.t_s[from]) / (to - from);
  }
  // More than half of a path without any time leaves the mean as the only measure.
  double usual = Median(slowness);
  if (!(usual > 0)) usual = duration / last;
  const double least = std::exp(parameters.least_slowness);
  const double most = std::exp(parameters.most_slowness);
  for (double& s : slowness) s = std::log(std::clamp(s / usual, least, most));
  return slowness;
}

CornerEvidence EvidenceOf(const StrokePath& path, const SegmentationParameters& parameters) {
  const int near = path.Steps(parameters.near_span);
  const int far = path.Steps(parameters.far_span);
  const std::vector<double> slowness = Slowness(path, parameters);
  const double trust = TrustInSpeed(path, slowness, parameters);
  CornerEvidence evidence;
  evidence.near_turn.resize(slowness.size());
  evidence.price.resize(slowness.size());
  for (int i = 0; i < path.size(); ++i) {
    evidence.near_turn[i] = TurnAt(path, i, near);
    const double turn = 0.5 * (evidence.near_turn[i] + TurnAt(path, i, far));
    const double slow = std::lerp(ExpectedSlowness(turn, parameters), slowness[i], trust);
    evidence.price[i] =
        parameters.corner_price - parameters.turn_weight * turn - parameters.slowness_weight * slow;
  }
  return evidence;
}

std::vector<int> CornerCandidates(const StrokePath& path, const CornerEvidence& evidence,
                                  const SegmentationParameters& parameters) {
  const int steps = path.Steps(parameters.candidate_span);
  std::vector<int> candidates;
  const int hook = path.Steps(parameters.hook_length);
  for (int i = hook; i < path.size() - hook; ++i) {
    if (evidence.near_turn[i] < parameters.least_turn) continue;
    if (IsCheapestAround(evidence.price, i, steps)) candidates.push_back(i);
  }
  KeepOnePerSample(path, evidence.price, &candidates);
  KeepCheapest(evidence.price, parameters.most_candidates, &candidates);
  return candidates;
}

}  // namespace parti::sketch
