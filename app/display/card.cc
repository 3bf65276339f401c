#include "app/display/card.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <vector>

#include "base/check.h"
#include "render/kms_output.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

/// An error, or whether a screen is plugged in.
Result<bool> HasScreen(const Card& card) {
  const auto outputs = render::ReadKmsOutputs(card.fd());
  if (!outputs) return Fail(outputs);
  return render::ChooseOutput(*outputs, "", {}).has_value();
}

}  // namespace

Result<std::vector<std::string>> CardPaths() {
  std::vector<std::string> paths;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator("/dev/dri", ignored)) {
    if (entry.path().filename().string().starts_with("card")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  if (!paths.empty()) return paths;
  return Fail(ErrorCode::kDevice, "the kernel knows no screen: there is no /dev/dri/card0",
              "install the driver of the graphics card; over ssh or in a container there is none: "
              "use `--display x11` there");
}

Result<std::unique_ptr<Card>> OpenCard(Seat* seat, const std::string& path) {
  const auto paths = path.empty() ? CardPaths() : std::vector{path};
  if (!paths) return Fail(paths);
  std::optional<Error> problem;
  std::unique_ptr<Card> dark;
  for (const std::string& candidate : *paths) {
    const int fd = seat->Open(candidate);
    if (fd < 0) {
      if (!problem) problem = CannotOpenScreen(candidate, -fd);
      continue;
    }
    auto card = std::make_unique<Card>(seat, fd, candidate);
    const auto lit = HasScreen(*card);
    if (lit && *lit) return card;
    if (lit && !dark) dark = std::move(card);
    if (!lit && !problem) problem = lit.error();
  }
  if (dark) return dark;
  CHECK(problem.has_value(), "a card that is not used has a reason");
  return tl::unexpected(*problem);
}

}  // namespace parti::app
