// Outlines on which roofs are measured: random polygons, and letters with corners as surveys leave
// them. All simple; deterministic in their seed.
#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "base/random.h"
#include "grammar/polygon.h"

namespace parti::grammar::tests {

/// Corners at random angles and radii of 4 to 20 m about the middle: spikes and deep notches.
inline Ring RandomStar(int corners, Random* random) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + random->Uniform(-0.45, 0.45)) / corners;
    ring.push_back(Vec2(std::cos(angle), std::sin(angle)) * random->Uniform(4, 20));
  }
  return ring;
}

/// Random points on 40 x 40 m, joined in random order and untangled: crossing edges are swapped
/// until none is left, which ends as every swap makes the ring shorter.
inline Ring RandomTangle(int corners, Random* random) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    ring.emplace_back(random->Uniform(0, 40), random->Uniform(0, 40));
  }
  const auto crosses = [](const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    return (Cross(b - a, c - a) > 0) != (Cross(b - a, d - a) > 0) &&
           (Cross(d - c, a - c) > 0) != (Cross(d - c, b - c) > 0);
  };
  const int n = corners;
  for (bool tangled = true; tangled;) {
    tangled = false;
    for (int i = 0; i + 2 < n; ++i) {
      for (int j = i + 2; j < n; ++j) {
        const bool neighbours = i == 0 && j == n - 1;
        if (neighbours || !crosses(ring[i], ring[i + 1], ring[j], ring[(j + 1) % n])) continue;
        std::reverse(ring.begin() + i + 1, ring.begin() + j + 1);
        tangled = true;
      }
    }
  }
  if (SignedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

enum class Letter { kL, kU, kT, kPlus, kComb };
inline constexpr std::pair<Letter, std::string_view> kLetters[] = {{Letter::kL, "L"},
                                                                   {Letter::kU, "U"},
                                                                   {Letter::kT, "T"},
                                                                   {Letter::kPlus, "plus"},
                                                                   {Letter::kComb, "comb"}};

/// The letter, about 30 m wide, its measures and turn drawn at random, its corners square.
inline Ring LetterRing(Letter letter, Random* random) {
  const auto draw = [&](double low, double high) { return random->Uniform(low, high); };
  const double w = draw(24, 36), h = draw(18, 30), a = draw(4, 8), b = draw(4, 8);
  switch (letter) {
    case Letter::kL:
      return {{0, 0}, {w, 0}, {w, a}, {b, a}, {b, h}, {0, h}};
    case Letter::kU:
      return {{0, 0}, {w, 0}, {w, h}, {w - b, h}, {w - b, a}, {b, a}, {b, h}, {0, h}};
    case Letter::kT: {
      const double x = draw(6, w - 6 - b);
      return {{x, 0}, {x + b, 0}, {x + b, h - a}, {w, h - a},
              {w, h}, {0, h},     {0, h - a},     {x, h - a}};
    }
    case Letter::kPlus: {
      const double x = (w - a) / 2, y = (h - b) / 2;
      return {{x, 0},     {x + a, 0}, {x + a, y}, {w, y},     {w, y + b}, {x + a, y + b},
              {x + a, h}, {x, h},     {x, y + b}, {0, y + b}, {0, y},     {x, y}};
    }
    case Letter::kComb:
      break;
  }
  Ring comb = {{0, 0}, {w, 0}};
  const double tooth = w / 9;
  for (int i = 4; i >= 0; --i) {
    const double left = 2 * i * tooth, right = left + tooth;
    comb.emplace_back(right, h);
    comb.emplace_back(left, h);
    if (i == 0) break;
    comb.emplace_back(left, a);
    comb.emplace_back(left - tooth, a);
  }
  return comb;
}

/// Each edge in `pieces`, every corner moved by up to jitter_m in x and y.
inline Ring Surveyed(const Ring& ring, int pieces, double jitter_m, Random* random) {
  Ring result;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    for (int k = 0; k < pieces; ++k) {
      const Vec2 off(random->Uniform(-jitter_m, jitter_m), random->Uniform(-jitter_m, jitter_m));
      result.push_back(a + (b - a) * (static_cast<double>(k) / pieces) + off);
    }
  }
  return result;
}

inline Ring Turned(Ring ring, double degrees) {
  const double s = std::sin(degrees * kPi / 180), c = std::cos(degrees * kPi / 180);
  for (Vec2& p : ring) p = Vec2(c * p.x - s * p.y, s * p.x + c * p.y);
  return ring;
}

}  // namespace parti::grammar::tests
