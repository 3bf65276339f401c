#include "grammar/layers/path_rings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parti::grammar {
namespace {

constexpr size_t kSteps = 32;  // in which the length of a curve is measured

/// The length of a curve up to each of its steps.
using Lengths = std::array<double, kSteps + 1>;

bool IsCurve(const PathSegment& segment) { return segment.kind != PathSegment::Kind::kLine; }

Lengths LengthsOf(const PathSegment& curve, const Vec2& size) {
  Lengths lengths{};
  Vec2 before = curve.start() * size;
  for (size_t i = 1; i <= kSteps; ++i) {
    const Vec2 here = curve.At(static_cast<double>(i) / kSteps) * size;
    lengths[i] = lengths[i - 1] + glm::distance(before, here);
    before = here;
  }
  return lengths;
}

/// Where on the curve this much of its length is done.
double ParameterAt(const Lengths& lengths, double length) {
  const auto after = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const auto i = static_cast<size_t>(after - lengths.begin());
  const double step = lengths[i] - lengths[i - 1];
  const double part = step > 0 ? (length - lengths[i - 1]) / step : 0;
  return (static_cast<double>(i) - 1 + part) / kSteps;
}

void AddCurve(const PathSegment& curve, const Vec2& size, double per_metre, Ring* ring) {
  const Lengths lengths = LengthsOf(curve, size);
  const double whole = lengths[kSteps];
  const int count = std::max(1, static_cast<int>(std::lround(whole * per_metre)));
  for (int i = 1; i <= count; ++i) {
    ring->push_back(curve.At(ParameterAt(lengths, whole * i / (count + 1))) * size);
  }
}

}  // namespace

std::vector<Ring> RingsOf(const SvgPath& path, int samples, const Vec2& size) {
  double curved = 0;
  for (const auto& loop : path) {
    for (const PathSegment& segment : loop) {
      if (IsCurve(segment)) curved += LengthsOf(segment, size)[kSteps];
    }
  }
  const double per_metre = curved > 0 ? samples / curved : 0;
  std::vector<Ring> rings;
  for (const auto& loop : path) {
    Ring& ring = rings.emplace_back();
    for (const PathSegment& segment : loop) {
      ring.push_back(segment.start() * size);
      if (IsCurve(segment)) AddCurve(segment, size, per_metre, &ring);
    }
  }
  return rings;
}

}  // namespace parti::grammar
