#include "input/line_scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace parti::input {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\t'; }

std::string Shown(const Word& word) {
  constexpr size_t kLongest = 40;
  return Quoted(word.text.substr(0, kLongest)) + (word.text.size() > kLongest ? "…" : "");
}

template <typename Integer>
std::optional<Integer> WholeInteger(std::string_view text, int base) {
  Integer value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value, base);
  if (problem != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// The byte that an escape at `text[i]` (a backslash) stands for, and the escape's length.
std::optional<std::pair<char, size_t>> Escape(std::string_view text, size_t i) {
  if (i + 1 >= text.size()) return std::nullopt;
  if (text[i + 1] == '"' || text[i + 1] == '\\') return std::pair(text[i + 1], size_t{2});
  if (text[i + 1] != 'x' || i + 4 > text.size()) return std::nullopt;
  const auto byte = WholeInteger<uint8_t>(text.substr(i + 2, 2), 16);
  if (!byte) return std::nullopt;
  return std::pair(static_cast<char>(*byte), size_t{4});
}

}  // namespace

bool LineScanner::AtEnd() {
  while (at_ < line_.size() && IsBlank(line_[at_])) ++at_;
  return at_ == line_.size();
}

Result<Word> LineScanner::Next(std::string_view what) {
  if (AtEnd()) return FailAt({"", column()}, fmt::format("{} is missing", what));
  const size_t start = at_;
  while (at_ < line_.size() && !IsBlank(line_[at_])) ++at_;
  return Word{line_.substr(start, at_ - start), static_cast<int>(start) + 1};
}

Result<Attribute> LineScanner::NextAttribute() {
  if (AtEnd()) return FailAt({"", column()}, "an attribute is missing");
  Attribute attribute;
  size_t start = at_;
  while (at_ < line_.size() && !IsBlank(line_[at_]) && line_[at_] != '=') ++at_;
  attribute.key = {line_.substr(start, at_ - start), static_cast<int>(start) + 1};
  if (at_ == line_.size() || line_[at_] != '=') return attribute;
  attribute.has_value = true;
  start = ++at_;
  const bool quoted = at_ < line_.size() && line_[at_] == '"';
  if (quoted) {
    for (++at_; at_ < line_.size() && line_[at_] != '"'; ++at_) {
      if (line_[at_] == '\\' && at_ + 1 < line_.size()) ++at_;
    }
    if (at_ < line_.size()) ++at_;
  }
  while (at_ < line_.size() && !IsBlank(line_[at_])) ++at_;
  attribute.value = {line_.substr(start, at_ - start), static_cast<int>(start) + 1};
  return attribute;
}

Word LineScanner::Rest() {
  AtEnd();
  const Word rest{line_.substr(at_), column()};
  at_ = line_.size();
  return rest;
}

tl::unexpected<Error> LineScanner::FailAt(const Word& word, std::string message,
                                          std::string hint) const {
  Error error{ErrorCode::kDamagedFile, std::move(message), std::move(hint), std::nullopt};
  error.place = PlaceIn(line_, {}, static_cast<size_t>(word.column - 1), word.text.size());
  return tl::unexpected<Error>(std::move(error));
}

Result<double> NumberIn(const LineScanner& line, const Word& word) {
  double value = 0;
  const char* end = word.text.data() + word.text.size();
  const auto [stop, problem] = std::from_chars(word.text.data(), end, value);
  if (problem == std::errc::invalid_argument || stop != end) {
    return line.FailAt(word, fmt::format("{} is not a number", Shown(word)));
  }
  if (problem != std::errc() || !std::isfinite(value)) {
    return line.FailAt(word, fmt::format("{} is not a finite number", Shown(word)));
  }
  return value;
}

Result<Vec2> PairIn(const LineScanner& line, const Word& word) {
  const size_t comma = word.text.find(',');
  if (comma == std::string_view::npos) {
    return line.FailAt(word, fmt::format("{} is not two numbers with a comma", Shown(word)));
  }
  const auto x = NumberIn(line, {word.text.substr(0, comma), word.column});
  if (!x) return Fail(x);
  const auto y =
      NumberIn(line, {word.text.substr(comma + 1), word.column + static_cast<int>(comma) + 1});
  if (!y) return Fail(y);
  return Vec2(*x, *y);
}

Result<int> IntegerIn(const LineScanner& line, const Word& word, int low, int high) {
  const auto value = WholeInteger<int>(word.text, 10);
  if (value && *value >= low && *value <= high) return *value;
  return line.FailAt(word,
                     fmt::format("{} is not a whole number of [{}, {}]", Shown(word), low, high));
}

Result<uint32_t> HexIn(const LineScanner& line, const Word& word) {
  const auto value = WholeInteger<uint32_t>(word.text, 16);
  if (value) return *value;
  return line.FailAt(word, fmt::format("{} is not a hexadecimal number", Shown(word)));
}

std::string Quoted(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 32 || byte == 127) {
      quoted += fmt::format("\\x{:02x}", byte);
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

Result<std::string> UnquotedIn(const LineScanner& line, const Word& word) {
  const std::string_view text = word.text;
  std::string plain;
  size_t i = 1;
  while (i + 1 < text.size() && text[i] != '"') {
    if (text[i] != '\\') {
      plain += text[i++];
      continue;
    }
    const auto escape = Escape(text, i);
    if (!escape) break;
    plain += escape->first;
    i += escape->second;
  }
  const bool closed =
      text.size() >= 2 && text.front() == '"' && i + 1 == text.size() && text.back() == '"';
  if (closed) return plain;
  return line.FailAt(word, fmt::format("{} is not a text in double quotes", Shown(word)),
                     R"(inside it, write \" for a quote and \\ for a backslash)");
}

}  // namespace parti::input
