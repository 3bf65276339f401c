#include "tests/support/data.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace parti::tests {
namespace fs = std::filesystem;

std::string DataFile(const std::string& name) {
  const char* folder = std::getenv("PARTI_DATA");
  const fs::path path = folder ? fs::path(folder) / name
                               : fs::path(PARTI_SOURCE_DIR) / ".." / "shared" / "data" / name;
  if (fs::exists(path)) return path.lexically_normal().string();
  const char* ci = std::getenv("CI");
  if (ci && std::string_view(ci) == "true") {
    ADD_FAILURE() << "CI=true, and there is no " << path;
  }
  return "";
}

std::string SourceFile(const std::string& name) {
  return (fs::path(PARTI_SOURCE_DIR) / name).string();
}

}  // namespace parti::tests
