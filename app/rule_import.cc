#include "app/rule_import.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "base/text_file.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

constexpr int kFoldersAbove = 4;

Result<grammar::RuleFile> Import(const std::string& path, const std::string& importing) {
  const fs::path wanted = fs::path(path).relative_path();
  fs::path folder = importing == "-" ? fs::path() : fs::path(importing).parent_path();
  for (int above = 0; above <= kFoldersAbove; ++above) {
    const fs::path file = (folder / wanted).lexically_normal();
    std::error_code error;
    if (fs::is_regular_file(file, error)) {
      auto text = ReadFile(file.string());
      if (!text) return Fail(text);
      return grammar::RuleFile{file.string(), std::move(*text)};
    }
    folder /= "..";
  }
  return Fail(ErrorCode::kFile, fmt::format("there is no file '{}'", path),
              "it is looked for beside this file and in the folders above");
}

}  // namespace

grammar::RuleImporter FileImporter() { return Import; }

}  // namespace parti::app
