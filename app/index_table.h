// Numbers 0, 1, 2, … found again by the hash of what they stand for, which the caller keeps.
// Two flat arrays that are used again and again: no allocation for each entry.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parti::app {

/// Numbers whose hashes agree in the bits that matter form a chain, the latest first; the caller
/// tells those apart.
class IndexTable {
 public:
  static constexpr uint32_t kNone = ~uint32_t{0};

  /// Forgets all. Lookups are fast up to about `expected` numbers, and work beyond.
  void Reset(size_t expected) {
    const size_t slots = std::bit_ceil(std::max<size_t>(expected, 16));
    shift_ = 64 - std::countr_zero(slots);
    heads_.assign(slots, kNone);
    next_.clear();
  }

  /// Takes in the next number.
  void Add(uint64_t hash) {
    uint32_t& head = heads_[hash >> shift_];
    next_.push_back(head);
    head = static_cast<uint32_t>(next_.size() - 1);
  }

  uint32_t First(uint64_t hash) const { return heads_[hash >> shift_]; }  ///< or kNone
  uint32_t Next(uint32_t number) const { return next_[number]; }          ///< or kNone

  /// `hash` with one more value in it; its upper bits depend on all of them.
  static uint64_t Mixed(uint64_t hash, uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15ull;
    return hash ^ hash >> 29;
  }

 private:
  int shift_ = 60;
  std::vector<uint32_t> heads_ = std::vector<uint32_t>(16, kNone);
  std::vector<uint32_t> next_;
};

}  // namespace parti::app
