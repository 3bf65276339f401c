#include "input/unsmoothed.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace parti::input {
namespace fs = std::filesystem;
namespace {

constexpr const char* kVariable = "LIBINPUT_QUIRKS_DIR";
constexpr const char* kSystemFolder = "/usr/share/libinput";
constexpr const char* kOverrides = "/etc/libinput/local-overrides.quirks";
// Files are read in the order of their names, and of equal quirks the last counts.
constexpr const char* kOwnFile = "99-parti.quirks";
constexpr const char* kOwnQuirks =
    "[Parti takes pens unsmoothed]\n"
    "MatchUdevType=tablet\n"
    "AttrTabletSmoothing=0\n";

void LinkQuirks(const fs::path& from, const fs::path& folder) {
  std::error_code ignored;  // a file less is a quirk less; libinput says what it can't do without
  for (const auto& entry : fs::directory_iterator(from, ignored)) {
    if (entry.path().extension() != ".quirks") continue;
    fs::create_symlink(fs::absolute(entry.path()), folder / entry.path().filename(), ignored);
  }
}

}  // namespace

Result<Unsmoothed> Unsmoothed::Make() {
  std::error_code problem;
  std::string name = (fs::temp_directory_path(problem) / "parti-quirks-XXXXXX").string();
  if (problem || ::mkdtemp(name.data()) == nullptr) {
    return Fail(ErrorCode::kFile,
                fmt::format("can't make a folder for libinput's settings: {}",
                            problem ? problem.message() : std::strerror(errno)),
                "set TMPDIR to a folder that you may write");
  }
  Unsmoothed made;
  made.folder_ = name;
  if (const char* previous = std::getenv(kVariable)) made.previous_ = previous;
  LinkQuirks(made.previous_.value_or(kSystemFolder), made.folder_);
  if (!made.previous_ && fs::exists(kOverrides, problem)) {
    fs::create_symlink(kOverrides, made.folder_ / "98-local-overrides.quirks", problem);
  }
  std::ofstream own(made.folder_ / kOwnFile);
  own << kOwnQuirks << std::flush;
  if (!own) {
    return Fail(ErrorCode::kFile, fmt::format("can't write in {}", made.folder_.string()),
                "check that the disk has room");
  }
  ::setenv(kVariable, made.folder_.c_str(), 1);
  return made;
}

Unsmoothed::Unsmoothed(Unsmoothed&& other) noexcept
    : folder_(std::exchange(other.folder_, fs::path())), previous_(std::move(other.previous_)) {}

Unsmoothed::~Unsmoothed() {
  if (folder_.empty()) return;
  if (previous_) {
    ::setenv(kVariable, previous_->c_str(), 1);
  } else {
    ::unsetenv(kVariable);
  }
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

}  // namespace parti::input
