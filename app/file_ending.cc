#include "app/file_ending.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace parti::app {

std::string EndingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  for (char& c : ending) c = is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
  return ending;
}

Result<void> CheckEnding(const std::string& path, std::string_view ending) {
  const std::string given = EndingOf(path);
  if (given.empty() || given == ending) return {};
  const auto fitting = std::filesystem::path(path).replace_extension(ending);
  return Fail(ErrorCode::kUnknownName,
              fmt::format("what is written to '{}' is {}, not {}", path, ending, given),
              fmt::format("name it {}", fitting.string()));
}

}  // namespace parti::app
