#include "base/text_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

namespace parti {
namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

constexpr size_t kMostBytes = size_t{256} << 20;
constexpr int kMostLinks = 40;  // one after another, as the kernel follows them

// Takes errno as the reason; call it at once.
tl::unexpected<Error> FailWith(const char* verb, const std::string& path, std::string hint) {
  const int reason = errno;
  return Fail(ErrorCode::kFile, fmt::format("can't {} {}: {}", verb, path, std::strerror(reason)),
              std::move(hint));
}

bool IsFolder(const std::string& path) {
  struct stat facts {};
  return ::stat(path.c_str(), &facts) == 0 && S_ISDIR(facts.st_mode);
}

Result<std::string> ReadAll(std::FILE* in, const std::string& name) {
  std::string bytes;
  std::array<char, 1 << 16> buffer;
  while (const size_t got = std::fread(buffer.data(), 1, buffer.size(), in)) {
    bytes.append(buffer.data(), got);
    if (bytes.size() > kMostBytes) return Fail(ErrorCode::kFile, name + " is larger than 256 MiB");
  }
  if (std::ferror(in)) return FailWith("read", name, "");
  return bytes;
}

// All bytes, flushed to the disk where it is one (pipes and terminals refuse fsync).
bool WriteAll(std::FILE* out, std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), out) != bytes.size()) return false;
  if (std::fflush(out) != 0) return false;
  return ::fsync(::fileno(out)) == 0 || errno == EINVAL || errno == EROFS;
}

// Straight into what is no regular file: a device or a pipe must not be replaced by one.
Result<void> WriteInto(const std::string& path, std::string_view bytes) {
  const File out(std::fopen(path.c_str(), "wb"));
  if (!out) return FailWith("write", path, "check that you may write there");
  if (!WriteAll(out.get(), bytes)) return FailWith("write", path, "check that the disk has room");
  return {};
}

Result<void> Replace(const std::string& path, const std::string& target, std::string_view bytes,
                     const struct stat* old) {
  const std::string temporary = fmt::format("{}.{}.tmp", target, ::getpid());
  File out(std::fopen(temporary.c_str(), "wb"));
  if (!out) {
    return FailWith("write", path, "check that the folder exists and that you may write there");
  }
  const auto fail = [&](const char* hint) {
    auto failed = FailWith("write", path, hint);
    std::remove(temporary.c_str());
    return failed;
  };
  if (old && ::fchmod(::fileno(out.get()), old->st_mode & 07777) != 0) {
    return fail("check that you own it");
  }
  if (!WriteAll(out.get(), bytes)) return fail("check that the disk has room");
  if (std::fclose(out.release()) != 0) return fail("check that the disk has room");
  if (std::rename(temporary.c_str(), target.c_str()) != 0) return fail("check the name");
  return {};
}

}  // namespace

std::string BehindLinks(const std::string& path) {
  namespace fs = std::filesystem;
  fs::path at = path;
  std::error_code failed;
  for (int links = 0; links < kMostLinks && fs::is_symlink(at, failed); ++links) {
    const fs::path to = fs::read_symlink(at, failed);
    if (failed) return path;
    at = at.parent_path() / to;  // an absolute one replaces all
  }
  return at.string();
}

Result<std::string> ReadFile(const std::string& path) {
  if (path == "-") return ReadAll(stdin, "standard input");
  if (IsFolder(path)) return Fail(ErrorCode::kFile, path + " is a folder, not a file");
  const File in(std::fopen(path.c_str(), "rb"));
  if (!in) return FailWith("read", path, "check the name and that you may read it");
  return ReadAll(in.get(), path);
}

Result<void> WriteFile(const std::string& path, std::string_view bytes) {
  if (IsFolder(path)) return Fail(ErrorCode::kFile, path + " is a folder, not a file");
  const std::string target = BehindLinks(path);
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (!exists) return Replace(path, target, bytes, nullptr);
  if (!S_ISREG(old.st_mode)) return WriteInto(target, bytes);
  if (::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) {
    return FailWith("write", path, "check that you may write it");
  }
  return Replace(path, target, bytes, &old);
}

}  // namespace parti
