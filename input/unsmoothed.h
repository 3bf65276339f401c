// Switches libinput's smoothing of pen positions off, so that ink is what the pen did.
// Not responsible for any other setting of libinput.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.h"

namespace parti::input {

/// libinput 1.22 averages the last four reports of every tablet but AES displays: 15 ms of lag at
/// 200 Hz, and rounded corners, which is what segmentation looks for. There is no call for it, only
/// the quirk AttrTabletSmoothing. Quirks are read from the folder LIBINPUT_QUIRKS_DIR when a
/// context gets its first device; the folder takes the place of the system's and of
/// /etc/libinput/local-overrides.quirks, so ours holds links to those and one more file, read last.
///
/// While it lives, contexts that get their first device read quirks with smoothing off. It changes
/// the environment: make it before threads are started that read the environment.
class Unsmoothed {
 public:
  /// errors  kFile  no folder for temporary files can be written.
  static Result<Unsmoothed> Make();

  ~Unsmoothed();
  Unsmoothed(Unsmoothed&& other) noexcept;
  Unsmoothed& operator=(Unsmoothed&&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  Unsmoothed() = default;

  std::filesystem::path folder_;         // empty once moved from
  std::optional<std::string> previous_;  // of LIBINPUT_QUIRKS_DIR
};

}  // namespace parti::input
