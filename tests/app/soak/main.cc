// parti_soak [HOURS [SEED [application]]]: plays hours of use as fast as it goes into the session,
// or into the whole application, and fails where memory or the document grows past what undo may
// keep. Meant to be run under the sanitizers.
#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <memory>
#include <random>
#include <vector>

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
// Levels of 36 runs lay between 62 and 68 MB, at once and after hours alike.
constexpr size_t kSlack = size_t{8} << 20;
// Of those that were noted: the newest, and what pictures and workers were last made of. What is
// kept by mistake is kept each time.
constexpr size_t kStates = 8;

size_t BytesInUse() {
#if defined(__SANITIZE_ADDRESS__)
  return __sanitizer_get_current_allocated_bytes();
#else
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
#endif
}

/// Grows by a document's worth at most; an empty document is as small as it was before, and nothing
/// of the states before it is kept.
class Watch {
 public:
  /// Notes a state, to see later whether it went. Most moments leave the one before.
  void See(const std::shared_ptr<const app::SessionState>& state) {
    if (seen_.empty() || seen_.back().lock() != state) seen_.emplace_back(state);
  }

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
    const size_t empty = BytesWhenEmpty(target);
    if (first_ == 0) first_ = empty;
    const size_t states = StatesAlive();
    good = good && empty <= first_ + kSlack && states <= kStates;
    fmt::print(
        "{:6.2f} h  {:4} strokes, {:4} done, {:5.1f} MB in use, {:5.1f} MB and {} states when "
        "empty{}\n",
        clock_s / 3600, strokes, done, static_cast<double>(full) / 1e6,
        static_cast<double>(empty) / 1e6, states, good ? "" : "  GROWN");
    std::fflush(stdout);
    return good;
  }

 private:
  /// The least of several times, each after other pictures: GL's software driver keeps what it drew
  /// with until its next frames, longer on a busy machine. What leaks is there each time.
  size_t BytesWhenEmpty(SoakTarget* target) const {
    constexpr int kTimes = 5;
    size_t least = std::numeric_limits<size_t>::max();
    for (int i = 0; i < kTimes; ++i) {
      const auto view = fmt::format("view eye 42 {} 47 target 10 8.5 7 fov 36 size 1600 1000", i);
      target->Send(*app::ParseCommand(view));
      target->Settle();
      target->Send(app::DocumentRequest{app::DocumentRequest::Kind::kNew});
      target->Settle();
      least = std::min(least, BytesInUse());
    }
    return least;
  }

  size_t StatesAlive() {
    std::erase_if(seen_, [](const auto& state) { return state.expired(); });
    return seen_.size();
  }

  size_t first_ = 0;
  std::vector<std::weak_ptr<const app::SessionState>> seen_;
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
  mix.WarmUp(target.get());
  bool good = watch.Check(target.get(), mix.clock_s());  // what the others grow from
  const double end_s = mix.clock_s() + hours * 3600;
  double next_check_s = mix.clock_s() + kCheckEvery_s;
  while (mix.clock_s() < end_s) {
    mix.Moment(target.get());
    watch.See(target->Newest()->state);
    if (mix.clock_s() < next_check_s) continue;
    good = watch.Check(target.get(), mix.clock_s()) && good;
    next_check_s += kCheckEvery_s;
  }
  if (next_check_s - mix.clock_s() < kCheckEvery_s / 2) {
    good = watch.Check(target.get(), mix.clock_s()) && good;
  }
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
