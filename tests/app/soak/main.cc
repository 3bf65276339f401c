// parti_soak [HOURS [SEED [application]]]: plays hours of use as fast as it goes into the session,
// or into the whole application, and fails where memory or the document grows past what undo may
// keep. Meant to be run under the sanitizers.
#include <fmt/format.h>
#include <malloc.h>

#include <cstdlib>
#include <filesystem>
#include <random>

#include "app/document.h"
#include "base/check.h"
#include "tests/app/soak/application_target.h"
#include "tests/app/soak/session_target.h"
#include "tests/app/soak/soak_mix.h"

#if defined(__SANITIZE_ADDRESS__)
// The sanitizer's own; g++ comes without the header that declares it.
extern "C" size_t __sanitizer_get_current_allocated_bytes();
#endif

namespace parti::tests {
namespace {

// Few steps, so that the limit is reached soon and growth past it would show.
constexpr size_t kUndoSteps = 60;
constexpr double kCheckEvery_s = 360;
// Bytes that an empty session may take more than the first one did: caches, not the work of hours.
constexpr size_t kSlack = size_t{4} << 20;

size_t BytesInUse() {
#if defined(__SANITIZE_ADDRESS__)
  return __sanitizer_get_current_allocated_bytes();
#else
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

/// Grows by a document's worth at most; an empty document is as small as it was before.
class Watch {
 public:
  /// The document that is open, then a new one. Returns whether all is well.
  bool Check(SoakTarget* target, double clock_s) {
    const auto now = target->Settle();
    CHECK(!now->document.trouble, "the disk is fine");
    const size_t full = BytesInUse();
    bool good = true;
    size_t done = 0, strokes = 0;
    if (!now->document.path.empty()) {
      const auto document = app::OpenDocument(now->document.path);
      CHECK(document.has_value(), "the document opens while it is written");
      done = document->history.size();
      strokes = document->strokes.size();
      good = document->states.size() <= kUndoSteps + 1 + document->span.last - document->span.now;
    }
    target->Send(app::DocumentRequest{app::DocumentRequest::Kind::kNew});
    target->Settle();
    const size_t empty = BytesInUse();
    if (first_ == 0) first_ = empty;
    good = good && empty <= first_ + kSlack;
    fmt::print("{:6.2f} h  {:4} strokes, {:4} done, {:5.1f} MB in use, {:5.1f} MB when empty{}\n",
               clock_s / 3600, strokes, done, static_cast<double>(full) / 1e6,
               static_cast<double>(empty) / 1e6, good ? "" : "  GROWN");
    std::fflush(stdout);
    return good;
  }

 private:
  size_t first_ = 0;
};

std::unique_ptr<SoakTarget> TargetFor(const app::SessionThreadOptions& options, bool application) {
  if (application) return std::make_unique<ApplicationTarget>(options);
  return std::make_unique<SessionTarget>(options);
}

bool Soak(double hours, uint64_t seed, bool application, const std::string& folder) {
  app::SessionThreadOptions options;
  options.folders = {folder + "/data", folder + "/state"};
  options.session.undo.steps = kUndoSteps;
  const auto target = TargetFor(options, application);
  SoakMix mix(seed, folder);
  Watch watch;
  double next_check_s = kCheckEvery_s / 4;  // the first one soon: it is what the others grow from
  bool good = true;
  while (mix.clock_s() < hours * 3600) {
    mix.Moment(target.get());
    if (mix.clock_s() < next_check_s) continue;
    good = watch.Check(target.get(), mix.clock_s()) && good;
    next_check_s += kCheckEvery_s;
  }
  good = watch.Check(target.get(), mix.clock_s()) && good;
  fmt::print("{} moments, {:.1f} h of use: {}\n", mix.moments(), mix.clock_s() / 3600,
             good ? "sound" : "GROWN");
  return good;
}

}  // namespace
}  // namespace parti::tests

int main(int argc, char** argv) {
  const double hours = argc > 1 ? std::atof(argv[1]) : 4;
  const uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const bool application = argc > 3 && std::string(argv[3]) == "application";
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("parti_soak.{}", std::random_device()());
  std::filesystem::create_directories(folder);
  const bool good = parti::tests::Soak(hours, seed, application, folder.string());
  std::filesystem::remove_all(folder);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
