#include "sketch/agreement.h"

#include <algorithm>
#include <cmath>

namespace parti::sketch {
namespace {

struct Agreed {
  double value;
  double cost;
};

double Cost(const ValueReading& reading, double value, double scale) {
  const double off = (reading.value - value) / scale;
  return off * off - std::log(std::max(reading.fitness, 1e-12));
}

// Every line's reading nearest to the seed's value, averaged.
Agreed AgreeAround(double seed, const std::vector<std::vector<ValueReading>>& lines, double scale) {
  Agreed agreed{0, 0};
  for (const auto& readings : lines) {
    const auto best = std::min_element(readings.begin(), readings.end(),
                                       [&](const ValueReading& a, const ValueReading& b) {
                                         return Cost(a, seed, scale) < Cost(b, seed, scale);
                                       });
    agreed.value += best->value / static_cast<double>(lines.size());
    agreed.cost += Cost(*best, seed, scale);
  }
  return agreed;
}

}  // namespace

std::vector<double> AgreedValues(const std::vector<std::vector<ValueReading>>& lines, double scale,
                                 int most) {
  // A line without a reading agrees with nothing; look before any line is compared with it.
  if (std::any_of(lines.begin(), lines.end(), [](const auto& l) { return l.empty(); })) return {};
  std::vector<Agreed> found;
  for (const auto& seeds : lines) {
    for (const ValueReading& seed : seeds) {
      const Agreed mean = AgreeAround(seed.value, lines, scale);
      found.push_back(mean);
      // A line that agrees with no other must not spoil the others' value.
      if (std::abs(mean.value - seed.value) > scale) found.push_back({seed.value, mean.cost});
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Agreed& a, const Agreed& b) { return a.cost < b.cost; });
  std::vector<double> values;
  for (const Agreed& agreed : found) {
    const auto alike = [&](double v) { return std::abs(v - agreed.value) < scale / 2; };
    if (std::any_of(values.begin(), values.end(), alike)) continue;
    if (static_cast<int>(values.size()) == most) break;
    values.push_back(agreed.value);
  }
  return values;
}

}  // namespace parti::sketch
