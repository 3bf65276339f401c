// `parti record`: a drawing from a pen or touch screen, written while it is drawn.
#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/file_ending.h"
#include "input/drawing_recorder.h"
#include "input/libinput_source.h"

namespace parti::app {
namespace {

using Clock = std::chrono::steady_clock;
using input::DrawingRecorder;
using input::LibinputSource;

struct Options {
  std::string out;
  std::string node;  // "" for all of the seat
  std::optional<double> seconds;
};

// The only thing that a signal may do is say that it came.
volatile std::sig_atomic_t stop_asked = 0;
void AskToStop(int) { stop_asked = 1; }

void StopOnSignals() {
  struct sigaction action {};
  action.sa_handler = AskToStop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
}

bool TimeIsOver(const Options& options, Clock::time_point start) {
  if (!options.seconds) return false;
  return std::chrono::duration<double>(Clock::now() - start).count() >= *options.seconds;
}

/// Until a signal, the time is over, or the one device that was asked for is gone.
Result<void> RecordEvents(const Options& options, LibinputSource& source,
                          DrawingRecorder& recorder) {
  constexpr double kLookUp_s = 0.1;  // how long a signal or the end of the time may go unseen
  const auto start = Clock::now();
  while (true) {
    const bool last = stop_asked != 0 || TimeIsOver(options, start);
    const auto events = source.Dispatch();
    if (!events) return Fail(events);
    if (auto fine = recorder.Add(*events); !fine) return fine;
    if (last) return {};
    if (!options.node.empty() && source.present() == 0) return {};
    source.Wait(kLookUp_s);
  }
}

Result<std::string> Record(const Options& options) {
  if (const auto fine = CheckEnding(options.out, ".pen"); !fine) return Fail(fine);
  auto source = options.node.empty() ? LibinputSource::OpenSeat()
                                     : LibinputSource::OpenDevices({options.node});
  if (!source) return Fail(source);
  const auto first = source->Dispatch();
  if (!first) return Fail(first);
  if (first->empty()) return tl::unexpected(source->WhyNothing());
  auto recorder = DrawingRecorder::Create(options.out);
  if (!recorder) return Fail(recorder);
  StopOnSignals();
  if (::isatty(STDERR_FILENO) != 0) {
    Say(fmt::format("recording to {}; Ctrl-C ends it", options.out));
  }
  auto fine = recorder->Add(*first);
  if (fine) fine = RecordEvents(options, *source, *recorder);
  // Whatever happened, what was drawn is worth a proper end.
  auto finished = recorder->Finish();
  if (!fine) return Fail(fine);
  if (!finished) return Fail(finished);
  if (recorder->reports() == 0) {
    return Fail(ErrorCode::kNothingMade, "no pen and no finger touched anything while recording",
                "draw on the device; `--seconds` gives more time");
  }
  return fmt::format("{}: {} strokes, {} events\n", options.out, recorder->strokes(),
                     recorder->reports());
}

}  // namespace

void AddRecordCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("record", "Record a drawing from a pen");
  command->footer("Example: parti record hut.pen --device /dev/input/event5 --seconds 60");
  command->add_option("out", options->out, "The drawing to write")->required();
  command->add_option("--device", options->node, "Only this node, as `parti devices` lists them");
  command->add_option("--seconds", options->seconds, "How long; without it until Ctrl-C")
      ->check(CLI::PositiveNumber);
  command->callback([options, run] {
    *run = [options] {
      const auto recorded = Record(*options);
      return recorded ? PrintAnswer(*recorded) : Report(recorded.error());
    };
  });
}

}  // namespace parti::app
