#include "tests/pen/pen_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"

namespace parti::tests {
namespace {

/// One aimed movement: from its start it covers `reach` along a slightly bowed line.
struct Movement {
  Vec2 reach;
  double sagitta = 0;  ///< mm, to the left of reach
  double start_s = 0;
  double mu = 0;  ///< of the lognormal, ln s
  double sigma = 0;
};

/// Share of the movement covered at time t: the lognormal's distribution function.
double Progress(const Movement& m, double t) {
  if (t <= m.start_s) return 0;
  return 0.5 * std::erfc(-(std::log(t - m.start_s) - m.mu) / (m.sigma * std::sqrt(2.0)));
}

Vec2 Displacement(const Movement& m, double t) {
  const double s = Progress(m, t);
  const Vec2 left = Vec2(m.reach.y, -m.reach.x) / std::max(1e-9, glm::length(m.reach));
  return m.reach * s + left * (4 * m.sagitta * s * (1 - s));
}

/// The time at which a share of the movement is covered, by the normal quantile of that share.
double TimeAt(const Movement& m, double normal_quantile) {
  return m.start_s + std::exp(m.mu + m.sigma * normal_quantile);
}

constexpr double kQuantile999 = 3.09;  // 99.9 % of the way: the hand has arrived

Movement Aim(const Vec2& from, const Vec2& to, double earliest_s, const PenModelParameters& p,
             Random* random) {
  Movement m;
  const double length = glm::distance(from, to);
  const double scatter = p.scatter_mm + p.scatter_ratio * length;
  m.reach = to - from + Vec2(random->Normal(), random->Normal()) * scatter;
  m.sagitta = p.bow_ratio * length * random->Normal();
  m.sigma = p.sigma * (1 + 0.1 * random->Normal());
  const double duration = p.duration_s *
                          std::pow(std::max(length, 0.5) / p.reference_mm, p.duration_exponent) *
                          (1 + 0.08 * random->Normal());
  m.mu = std::log(duration) - m.sigma * kQuantile999;
  m.start_s = earliest_s;
  return m;
}

/// Sum of a few sinusoids in the tremor band with random phases: stationary, band limited.
class Tremor {
 public:
  Tremor(const PenModelParameters& p, Random* random) {
    for (Wave& wave : waves_) {
      wave.omega = 2 * kPi * random->Uniform(p.tremor_low_hz, p.tremor_high_hz);
      wave.phase_x = random->Uniform(0, 2 * kPi);
      wave.phase_y = random->Uniform(0, 2 * kPi);
    }
    amplitude_ = p.tremor_mm * std::sqrt(2.0 / static_cast<double>(waves_.size()));
  }
  Vec2 At(double t) const {
    Vec2 sum(0, 0);
    for (const Wave& wave : waves_) {
      sum += Vec2(std::sin(wave.omega * t + wave.phase_x), std::sin(wave.omega * t + wave.phase_y));
    }
    return sum * amplitude_;
  }

 private:
  struct Wave {
    double omega, phase_x, phase_y;
  };
  std::array<Wave, 4> waves_;
  double amplitude_;
};

/// The movements of a stroke: maybe a hook, then one to each point of the path, maybe a hook.
std::vector<Movement> Plan(const std::vector<Vec2>& path, const PenModelParameters& p,
                           Random* random, Vec2* start) {
  std::vector<Vec2> aims = path;
  const auto hook = [&] {
    const double angle = random->Uniform(0, 2 * kPi);
    return Vec2(std::cos(angle), std::sin(angle)) * (p.hook_mm * random->Uniform(0.5, 1.5));
  };
  if (random->Uniform() < p.hook_probability) aims.insert(aims.begin(), aims.front() + hook());
  if (random->Uniform() < 0.5 * p.hook_probability) aims.push_back(aims.back() + hook());
  *start = aims.front() + Vec2(random->Normal(), random->Normal()) * p.scatter_mm;

  std::vector<Movement> movements;
  Vec2 at = *start;
  double earliest = 0;
  for (size_t i = 1; i < aims.size(); ++i) {
    movements.push_back(Aim(at, aims[i], earliest, p, random));
    // The next movement starts when this one still has `overlap` of its time to go: the eye
    // corrects for the scatter of where the hand has got to, so aim from there.
    const Movement& m = movements.back();
    earliest = m.start_s + (TimeAt(m, kQuantile999) - m.start_s) * (1 - p.overlap);
    at += m.reach;
  }
  return movements;
}

double PressureAt(double t, double end, const PenModelParameters& p, double slow_phase) {
  const double rise = 1 - std::exp(-t / 0.03), fall = 1 - std::exp(-(end - t) / 0.02);
  const double wave = 1 + 0.08 * std::sin(2 * kPi * 0.9 * t + slow_phase);
  return std::clamp(p.pressure * rise * std::max(0.0, fall) * wave, 1.0 / p.pressure_levels, 1.0);
}

double OnGrid(double value, double steps) { return std::round(value * steps) / steps; }

}  // namespace

std::vector<PenEvent> DrawStroke(const std::vector<Vec2>& path, const Vec2& size_mm, double start_s,
                                 const PenModelParameters& p, Random* random) {
  CHECK(path.size() >= 2, "a stroke aims at two points or more");
  Vec2 start;
  const std::vector<Movement> movements = Plan(path, p, random, &start);
  const Tremor tremor(p, random);
  const double slow_phase = random->Uniform(0, 2 * kPi);
  const Vec2 tilt(random->Uniform(18, 26), random->Uniform(22, 34));
  const double end = TimeAt(movements.back(), kQuantile999);
  constexpr int kApproach = 6;  // reports that hover before the pen touches

  const auto event = [&](PenEvent::Kind kind, int sample, double along_s, double distance) {
    Vec2 at = start + tremor.At(along_s);
    for (const Movement& m : movements) at += Displacement(m, along_s);
    PenEvent e;
    e.kind = kind;
    // Microseconds, and never backwards: jitter stays below half a report.
    const double jitter = std::clamp(random->Normal() * p.jitter_s, -0.002, 0.002);
    e.t_s = OnGrid(start_s + sample * p.sample_s + jitter, 1e6);
    e.position_mm = Vec2(OnGrid(std::clamp(at.x, 0.0, size_mm.x), p.units_per_mm),
                         OnGrid(std::clamp(at.y, 0.0, size_mm.y), p.units_per_mm));
    e.pressure = distance > 0 ? 0.0
                              : OnGrid(PressureAt(along_s, end + 0.01, p, slow_phase),
                                       p.pressure_levels - 1);
    e.distance = OnGrid(distance, 63);
    e.tilt_deg = Vec2(std::round(tilt.x + 2 * std::sin(along_s)), std::round(tilt.y - along_s));
    return e;
  };

  std::vector<PenEvent> events;
  int sample = 0;
  for (int i = 0; i < kApproach; ++i, ++sample) {
    const auto kind = i == 0 ? PenEvent::Kind::kProximityIn : PenEvent::Kind::kMotion;
    events.push_back(event(kind, sample, 0, 0.5 - 0.08 * i));
  }
  const int contact = sample;
  const int last = contact + static_cast<int>(std::ceil(end / p.sample_s));
  for (; sample <= last; ++sample) {
    const auto kind = sample == contact ? PenEvent::Kind::kDown : PenEvent::Kind::kMotion;
    events.push_back(event(kind, sample, (sample - contact) * p.sample_s, 0));
  }
  events.push_back(event(PenEvent::Kind::kUp, sample, end, 0.1));
  events.push_back(event(PenEvent::Kind::kMotion, sample + 2, end, 0.4));
  events.push_back(event(PenEvent::Kind::kProximityOut, sample + 6, end, 0.6));
  return events;
}

}  // namespace parti::tests
