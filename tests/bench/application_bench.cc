// From an event of a device to the finished frame, through the whole application: hands, panels,
// hovering, ink and composing, off screen at 1600 x 1000 with 10,000 strokes and 100,000 shapes.
// CPU of the thread that draws ink; and the same beside derivations in the session's thread.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <thread>

#include "app/application.h"
#include "app/display/offscreen_display.h"
#include "app/document.h"
#include "app/play.h"
#include "base/check.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;

/// As ink_latency_bench.cc says.
[[maybe_unused]] const int kFixed = setenv("LP_NUM_THREADS", "0", 0);

constexpr int kStrokes = 10000, kSide = 316;  // 316 x 316 boxes
constexpr int kSamplesPerFrame = 4;           // a pen of 240 Hz on a display of 60 Hz
constexpr int kFrames = 500;
constexpr Vec2 kView_px{1600, 1000};

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string TownRules(int height_m) {
  return "tree town { .Lot --> split(x) { ~1: Row }* .Row --> split(y) { ~1: Cell }* "
         ".Cell --> extrude(" +
         std::to_string(height_m) + ") Box }";
}

/// A town of boxes, seen whole.
Session Town() {
  auto lots = ParseLots("rect(316,316)");
  auto trees = grammar::ParseTrees(TownRules(2));
  CHECK(lots && trees, "the town is well written");
  auto model = BuiltOn(std::move(*lots), std::move(*trees));
  CHECK(model && VisibleShapes(*model).size() == size_t{kSide} * kSide, "the town is built");
  Camera camera;
  camera.eye = {450, 260, 480};
  camera.target = {150, 0, 150};
  camera.width_px = kView_px.x;
  camera.height_px = kView_px.y;
  return Session(std::move(*model), camera);
}

/// The same with a sheet full of ink that means nothing.
Document SketchedOver(const Session& town) {
  Document document = DocumentOf(town);
  SessionRecord& state = document.states.back();
  for (uint32_t i = 0; i < kStrokes; ++i) {
    DrawnStroke drawn{{}, state.camera, i};
    const double at = 0.37 * i;
    for (int k = 0; k < 40; ++k) {
      const double t = at + k / 240.0;
      drawn.stroke.push_back({Vec2(800 + 600 * std::sin(1.1 * t) + 25 * std::sin(19 * t),
                                   500 + 350 * std::sin(0.7 * t + 1) + 25 * std::cos(23 * t)),
                              t, 0.5});
    }
    document.strokes.push_back(std::make_shared<const DrawnStroke>(std::move(drawn)));
  }
  state.unread = document.strokes;
  return document;
}

/// The application on that document, at rest, with a pen tablet of the view's shape.
class Desk {
 public:
  Desk() {
    fs::create_directories(folder_);
    const std::string path = (folder_ / "town.parti").string();
    CHECK(SaveDocument(SketchedOver(Town()), path).has_value(), "the town is saved");
    display_ = std::move(*OffscreenDisplay::Create());
    session_ = std::make_unique<SessionThread>(SessionThreadOptions{
        .path = path, .folders = {(folder_ / "data").string(), (folder_ / "state").string()}});
    application_ = std::move(*Application::Create(display_.get(), session_.get(), {}));
    DeviceFacts pen;
    pen.has_pen = true;
    pen.size_mm = kView_px / 10.0;
    display_->Inject(DeviceEvent{DeviceEvent::Kind::kAdded, 0, 0, pen});
    // The document is opened beside the display.
    while (application_->snapshot().state->sketch.unread.size() < kStrokes) Turn(0.1);
    Rest();
  }
  ~Desk() {
    application_.reset();
    session_.reset();
    fs::remove_all(folder_);
  }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  void Send(PenEvent::Kind kind) {
    t_s_ += 1 / 240.0;
    PenEvent event;
    event.kind = kind;
    event.t_s = t_s_;
    event.position_mm = Vec2(80 + 60 * std::sin(1.1 * t_s_) + 2.5 * std::sin(19 * t_s_),
                             50 + 25 * std::sin(0.7 * t_s_ + 1) + 2.5 * std::cos(23 * t_s_));
    event.pressure = 0.5 + 0.3 * std::sin(3 * t_s_);
    display_->Inject(event);
  }
  /// A typed node that makes too many shapes: two million are derived and then refused, so that
  /// nothing changes.
  void DeriveTooMuch() {
    posted_ = session_->Post(*ParseCommand("node .Box --> split(y) { ~0.02: Slice }*"));
  }
  /// Other heights for all boxes: another model, another scene, another picture.
  void DeriveOther() {
    height_m_ = height_m_ == 2 ? 3 : 2;
    posted_ = session_->Post(*ParseCommand("rewrite " + TownRules(height_m_)));
  }
  bool Derives() const { return session_->Newest()->executed < posted_; }
  int frames() const { return display_->frames(); }
  void Turn(double wait_s = 0) {
    CHECK(application_->Turn(wait_s).has_value(), "the display stays");
  }
  void Rest() { CHECK(Settle(application_.get(), 300).has_value(), "it comes to rest"); }

 private:
  const fs::path folder_ = fs::temp_directory_path() /
                           ("parti_application_bench." + std::to_string(std::random_device()()));
  std::unique_ptr<OffscreenDisplay> display_;
  std::unique_ptr<SessionThread> session_;
  std::unique_ptr<Application> application_;
  double t_s_ = 1;
  int height_m_ = 2;
  uint64_t posted_ = 0;
};

struct Times {
  std::vector<double> cpu_ms, wall_ms;

  static double At(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(part * static_cast<double>(values.size() - 1))];
  }
};

/// Frames of some samples each, until GL has finished them; turns of which nothing is seen, as
/// where a pen hovers on over the same face, count for nothing.
void Move(Desk* desk, int frames, Times* times) {
  for (int frame = 0; frame < frames; ++frame) {
    const double cpu = Seconds(CLOCK_THREAD_CPUTIME_ID), wall = Seconds(CLOCK_MONOTONIC);
    const int drawn = desk->frames();
    for (int i = 0; i < kSamplesPerFrame; ++i) desk->Send(PenEvent::Kind::kMotion);
    desk->Turn();
    if (desk->frames() == drawn) continue;
    times->cpu_ms.push_back(1e3 * (Seconds(CLOCK_THREAD_CPUTIME_ID) - cpu));
    times->wall_ms.push_back(1e3 * (Seconds(CLOCK_MONOTONIC) - wall));
  }
}

/// Moves for so long, while one derivation follows the other: how many were posted.
int MoveBeside(Desk* desk, double seconds, void (Desk::*derive)(), Times* times) {
  int derived = 0;
  const double until = Seconds(CLOCK_MONOTONIC) + seconds;
  while (Seconds(CLOCK_MONOTONIC) < until) {
    if (derive != nullptr && !desk->Derives()) {
      (desk->*derive)();
      ++derived;
    }
    Move(desk, 60, times);
  }
  return derived;
}

void Report(benchmark::State& state, const Times& times) {
  state.SetLabel(std::string("LP_NUM_THREADS=") + std::getenv("LP_NUM_THREADS"));
  CHECK(!times.cpu_ms.empty(), "something was drawn");
  state.counters["frames"] = static_cast<double>(times.cpu_ms.size());
  state.counters["cpu_p50_ms"] = Times::At(times.cpu_ms, 0.5);
  state.counters["cpu_p99_ms"] = Times::At(times.cpu_ms, 0.99);
  state.counters["wall_p50_ms"] = Times::At(times.wall_ms, 0.5);
  state.counters["wall_p99_ms"] = Times::At(times.wall_ms, 0.99);
  state.counters["cpu_most_ms"] = Times::At(times.cpu_ms, 1);
}

void BenchApplicationHovering(benchmark::State& state) {
  Desk desk;
  desk.Send(PenEvent::Kind::kProximityIn);
  Times times;
  for (auto _ : state) Move(&desk, kFrames, &times);
  Report(state, times);
}
BENCHMARK(BenchApplicationHovering)->Iterations(1)->Unit(benchmark::kMillisecond);

void BenchApplicationDrawing(benchmark::State& state) {
  Desk desk;
  desk.Send(PenEvent::Kind::kProximityIn);
  desk.Send(PenEvent::Kind::kDown);
  desk.Turn();
  Times times;
  for (auto _ : state) Move(&desk, kFrames, &times);
  Report(state, times);
}
BENCHMARK(BenchApplicationDrawing)->Iterations(1)->Unit(benchmark::kMillisecond);

/// Draws for 3 s alone, then for 3 s beside derivations, one after the other; five times over.
void BenchApplicationBesideDerivations(benchmark::State& state) {
  Desk desk;
  desk.Send(PenEvent::Kind::kProximityIn);
  desk.Send(PenEvent::Kind::kDown);
  desk.Turn();
  std::vector<double> alone, beside;
  Times all_beside;
  int derived = 0;
  for (auto _ : state) {
    for (int run = 0; run < 5; ++run) {
      desk.Rest();
      Times quiet, busy;
      MoveBeside(&desk, 3, nullptr, &quiet);
      alone.push_back(Times::At(quiet.cpu_ms, 0.5));
      derived += MoveBeside(&desk, 3, &Desk::DeriveTooMuch, &busy);
      beside.push_back(Times::At(busy.cpu_ms, 0.5));
      for (const auto member : {&Times::cpu_ms, &Times::wall_ms}) {
        (all_beside.*member)
            .insert((all_beside.*member).end(), (busy.*member).begin(), (busy.*member).end());
      }
    }
  }
  Report(state, all_beside);
  state.counters["alone_cpu_p50_ms"] = Times::At(alone, 0.5);
  state.counters["beside_cpu_p50_ms"] = Times::At(beside, 0.5);
  state.counters["change"] = Times::At(beside, 0.5) / Times::At(alone, 0.5) - 1;
  state.counters["derivations"] = derived;
}
BENCHMARK(BenchApplicationBesideDerivations)->Iterations(1)->Unit(benchmark::kMillisecond);

/// Strokes of a quarter of a second, one after the other: each comes back from the session as part
/// of its sketch.
void BenchApplicationStrokeAfterStroke(benchmark::State& state) {
  Desk desk;
  desk.Send(PenEvent::Kind::kProximityIn);
  Times times;
  for (auto _ : state) {
    for (int stroke = 0; stroke < 60; ++stroke) {
      desk.Send(PenEvent::Kind::kDown);
      Move(&desk, 14, &times);
      desk.Send(PenEvent::Kind::kUp);
      Move(&desk, 1, &times);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));  // the session reads it
      Move(&desk, 1, &times);
    }
  }
  Report(state, times);
}
BENCHMARK(BenchApplicationStrokeAfterStroke)->Iterations(1)->Unit(benchmark::kMillisecond);

/// Draws for 10 s while one model after the other takes the place of the one that is seen.
void BenchApplicationWhereTheModelChanges(benchmark::State& state) {
  Desk desk;
  desk.Send(PenEvent::Kind::kProximityIn);
  desk.Send(PenEvent::Kind::kDown);
  desk.Turn();
  Times times;
  int derived = 0;
  for (auto _ : state) derived += MoveBeside(&desk, 10, &Desk::DeriveOther, &times);
  Report(state, times);
  state.counters["derivations"] = derived;
}
BENCHMARK(BenchApplicationWhereTheModelChanges)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::app
