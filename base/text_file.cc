#include "base/text_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <system_error>

namespace parti {
namespace fs = std::filesystem;

Result<std::string> ReadFile(const std::string& path) {
  if (path == "-") {
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
  }
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return Fail(ErrorCode::kFile, fmt::format("{} is a folder, not a file", path));
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    return Fail(ErrorCode::kFile, fmt::format("can't read {}: {}", path, std::strerror(errno)),
                "check the name and that you may read it");
  }
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) {
    return Fail(ErrorCode::kFile, fmt::format("can't read {}: {}", path, std::strerror(errno)));
  }
  return bytes;
}

Result<void> WriteFile(const std::string& path, std::string_view bytes) {
  const std::string temporary = fmt::format("{}.{}.tmp", path, ::getpid());
  std::FILE* out = std::fopen(temporary.c_str(), "wb");
  const auto fail = [&](const char* hint) {
    const int reason = errno;
    std::remove(temporary.c_str());
    return Fail(ErrorCode::kFile, fmt::format("can't write {}: {}", path, std::strerror(reason)),
                hint);
  };
  if (!out) return fail("check that the folder exists and that you may write there");
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size();
  const bool flushed = std::fflush(out) == 0 && ::fsync(::fileno(out)) == 0;
  const bool closed = std::fclose(out) == 0;
  if (!written || !flushed || !closed) return fail("check that the disk has room");
  if (std::rename(temporary.c_str(), path.c_str()) != 0) {
    return fail("check that the name is not a folder's");
  }
  return {};
}

}  // namespace parti
