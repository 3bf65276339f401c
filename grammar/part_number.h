// Words that may also be numbers: "longest", or 2 for the third edge. A parameter that takes either
// lists kAnyNumber among its words, and its argument is a text: "longest", "2".
#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string_view>

namespace parti::grammar {

inline constexpr std::string_view kAnyNumber = "0";

/// The whole number that a text is; nothing for all else.
inline std::optional<int> PartNumber(std::string_view text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool is_all = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return is_all ? std::optional(number) : std::nullopt;
}

/// Whether the words leave room for numbers.
inline bool TakesNumbers(std::span<const std::string_view> words) {
  return std::find(words.begin(), words.end(), kAnyNumber) != words.end();
}

/// Number `part` of `count` > 0, counted round and round: -1 is the last.
inline size_t RoundAndRound(int part, size_t count) {
  const auto n = static_cast<int>(count);
  return static_cast<size_t>(((part % n) + n) % n);
}

}  // namespace parti::grammar
