// Which stream of random numbers a shape draws from: its path from the lot and the seed say it, so
// that an edit elsewhere in the rules never changes it. The stream itself is base/random.h's.
#pragma once

#include <cstdint>
#include <string_view>

namespace parti::grammar {

/// Mixes two numbers into one (SplitMix64's finish); order matters.
constexpr uint64_t StreamOf(uint64_t path, uint64_t number) {
  uint64_t z = path ^ (number + 1) * 0x9e3779b97f4a7c15ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// The path of a lot's root.
constexpr uint64_t LotPath(uint64_t seed, uint32_t lot_number) {
  return StreamOf(StreamOf(0x7061727469ull, seed), lot_number);
}

/// A name as a number (FNV-1a).
constexpr uint64_t NumberOfName(std::string_view name) {
  uint64_t number = 0xcbf29ce484222325ull;
  for (const char c : name) {
    number = (number ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  }
  return number;
}

}  // namespace parti::grammar
