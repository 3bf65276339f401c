// What it costs until a command is on the disk, and until a request is taken from the pen's thread.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "app/document_file.h"
#include "app/replay.h"
#include "app/session_thread.h"
#include "base/text_file.h"
#include "tests/support/data.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The demo house.
Session House() {
  Session session;
  ReplayReport report;
  const auto text = ReadFile(tests::SourceFile("assets/drawings/house.pen"));
  if (text) static_cast<void>(Replay(input::ReadDrawing(*text).drawing, &session, &report));
  return session;
}

/// Median and 99th percentile as counters, in milliseconds.
void Report(benchmark::State& state, std::vector<double> times_ms) {
  if (times_ms.empty()) return;
  std::sort(times_ms.begin(), times_ms.end());
  state.counters["median_ms"] = times_ms[times_ms.size() / 2];
  state.counters["p99_ms"] = times_ms[times_ms.size() * 99 / 100];
}

double Since_ms(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One command of the finished house, flushed: its history, a stroke, its state.
void BenchCommit(benchmark::State& state) {
  const Session house = House();
  const fs::path folder = fs::temp_directory_path() / "parti_document_bench";
  fs::create_directories(folder);
  const std::string path = (folder / "house.parti").string();
  if (!SaveDocument(DocumentOf(house), path)) return state.SkipWithError("can't be saved");
  auto file = DocumentFile::Open(path);
  if (!file) return state.SkipWithError(file.error().message.c_str());
  Document document = DocumentOf(house);
  DocumentChange change{1, nullptr, "", PresentOf(document), document.span};
  DrawnStroke drawn = *document.strokes.back();
  std::vector<double> times_ms;
  for (auto _ : state) {
    ++drawn.number;
    change.stroke = std::make_shared<const DrawnStroke>(drawn);
    change.span.last = ++change.span.now;
    const auto start = Clock::now();
    if (!file->Apply({&change, 1})) return state.SkipWithError("can't be written");
    times_ms.push_back(Since_ms(start));
    if (!file->Tidy()) return state.SkipWithError("the log can't be emptied");
  }
  Report(state, std::move(times_ms));
  fs::remove_all(folder);
}
BENCHMARK(BenchCommit)->Unit(benchmark::kMillisecond)->Iterations(2000)->UseRealTime();

/// What the pen's thread spends on a stroke of 240 samples, while the session is at work.
void BenchPost(benchmark::State& state) {
  const fs::path folder = fs::temp_directory_path() / "parti_post_bench";
  SessionThread thread({.folders = {(folder / "data").string(), (folder / "state").string()}});
  thread.Post(*ParseCommand("lot rect(20,14)"));
  Stroke stroke;
  for (int i = 0; i < 240; ++i) stroke.push_back({Vec2(i, 2 * i), 0.004 * i, 0.5});
  std::vector<double> times_ms;
  for (auto _ : state) {
    const auto start = Clock::now();
    thread.Post(stroke);
    times_ms.push_back(Since_ms(start));
  }
  thread.Stop();
  Report(state, std::move(times_ms));
  fs::remove_all(folder);
}
BENCHMARK(BenchPost)->Unit(benchmark::kMillisecond)->Iterations(500)->UseRealTime();

}  // namespace
}  // namespace parti::app
