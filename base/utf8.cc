#include "base/utf8.h"

#include <cstdint>

namespace parti {

CodePoint CodePointAt(std::string_view text, size_t offset) {
  if (offset >= text.size()) return {};
  const auto byte = [&](size_t i) {
    return offset + i < text.size() ? static_cast<uint8_t>(text[offset + i]) : uint8_t{0};
  };
  const uint8_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return {};
  char32_t value = lead & (0x7f >> length);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return {};
    value = value << 6 | (byte(i) & 0x3f);
  }
  const char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (value < smallest[length] || value > 0x10ffff) return {};
  if (value >= 0xd800 && value <= 0xdfff) return {};
  return {value, length};
}

std::string Utf8Of(char32_t value) {
  const bool is_none = value > 0x10ffff || (value >= 0xd800 && value <= 0xdfff);
  if (is_none) return {};
  if (value < 0x80) return std::string(1, static_cast<char>(value));
  const int more = value < 0x800 ? 1 : value < 0x10000 ? 2 : 3;
  const unsigned leads[] = {0, 0xc0, 0xe0, 0xf0};
  std::string bytes(1, static_cast<char>(leads[more] | value >> (6 * more)));
  for (int i = more - 1; i >= 0; --i) {
    bytes += static_cast<char>(0x80 | (value >> (6 * i) & 0x3f));
  }
  return bytes;
}

bool IsUtf8(std::string_view text) {
  for (size_t i = 0; i < text.size();) {
    const CodePoint c = CodePointAt(text, i);
    if (c.length == 0) return false;
    i += c.length;
  }
  return true;
}

bool IsLetter(char32_t c) {
  if (c < 0x80) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  if (c < 0xc0) return c == 0xaa || c == 0xb5 || c == 0xba;  // Latin-1 signs but for ª µ º
  if (c == 0xd7 || c == 0xf7) return false;                  // × ÷
  if (c == 0x1680 || (c >= 0x3000 && c <= 0x303f)) return false;
  if (c >= 0x2000 && c <= 0x2bff) return false;  // punctuation, arrows, mathematical signs
  if (c >= 0xe000 && c <= 0xf8ff) return false;
  if (c >= 0xfe00 && c <= 0xfe6f) return false;  // selectors, marks, small forms
  return c != 0xfeff && c < 0xf0000 && (c < 0xfff0 || c > 0xffff);
}

}  // namespace parti
