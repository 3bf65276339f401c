// Seeded random numbers, the same on every machine (std::distributions are not).
// Good enough for sampling and noise; not for secrets.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/math.h"

namespace parti {

/// SplitMix64 (Steele, Lea, Flood 2014). Value type; equal seeds give equal streams.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// Uniform over all 2^64 values.
  uint64_t Next() {
    uint64_t z = (state_ += 0x9e3779b97f4a7c15ull);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
    return z ^ (z >> 31);
  }
  /// Uniform in [0, 1).
  double Uniform() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }
  double Uniform(double low, double high) { return low + (high - low) * Uniform(); }
  /// Normal with mean 0 and deviation 1 (Box and Muller; one of each pair is dropped).
  double Normal() {
    const double radius = std::sqrt(-2 * std::log(1 - Uniform()));
    return radius * std::cos(2 * kPi * Uniform());
  }

 private:
  uint64_t state_;
};

}  // namespace parti
