// From a pen event to the finished frame, off screen at 1600 x 1000 with 10,000 strokes and 100,000
// shapes in the scene; and the same while other threads are busy. CPU of the thread that draws ink.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "base/check.h"
#include "render/scene_painter.h"
#include "tests/support/canvas_target.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

using tests::CanvasTarget;

/// Before Mesa begins: with no rasteriser threads everything that a frame costs is on the clock of
/// the thread that draws it, which is the honest figure. LP_NUM_THREADS in the environment goes
/// before.
[[maybe_unused]] const int kFixed = setenv("LP_NUM_THREADS", "0", 0);

constexpr glm::ivec2 kSize{1600, 1000};
constexpr int kStrokes = 10000;
constexpr int kTownSide = 100;
constexpr int kSamplesPerFrame = 4;  // a pen of 240 Hz on a display of 60 Hz
constexpr int kFrames = 500;
constexpr Vec4f kInk{0.05f, 0.1f, 0.45f, 1};

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A pen that writes quickly all over the sheet, some 700 px/s.
struct Pen {
  double t = 0;
  Vec2f Next() {
    t += 1 / 240.0;
    return {static_cast<float>(800 + 600 * std::sin(1.1 * t) + 25 * std::sin(19 * t)),
            static_cast<float>(500 + 350 * std::sin(0.7 * t + 1) + 25 * std::cos(23 * t))};
  }
  float width() const { return static_cast<float>(2.5 + 1.5 * std::sin(3 * t)); }
};

std::vector<InkStroke> Sheet() {
  std::vector<InkStroke> strokes;
  for (int i = 0; i < kStrokes; ++i) {
    auto ink = std::make_shared<Ink>();
    ink->color = kInk;
    Pen pen{0.37 * i};
    for (int k = 0; k < 40; ++k) {
      ink->points.push_back(pen.Next());
      ink->widths_px.push_back(pen.width());
    }
    strokes.push_back({static_cast<uint64_t>(i) + 1, ink});
  }
  return strokes;
}

/// Rows of small buttons along the left side, as panels beside a pen are.
UiMesh Panels() {
  UiMesh mesh;
  for (uint32_t i = 0; i < 2000; ++i) {
    const uint32_t column = i % 20, row = i / 20;
    const Vec2f low(static_cast<float>(8 + 10 * column), static_cast<float>(8 + 9 * row));
    const uint32_t first = static_cast<uint32_t>(mesh.vertices.size());
    for (const Vec2f& corner : {Vec2f(0, 0), Vec2f(8, 0), Vec2f(8, 8), Vec2f(0, 8)}) {
      mesh.vertices.push_back({low + corner, {0, 0}, 0xe0ffffff - i});
    }
    for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }
  mesh.commands = {{{0, 0, kSize.x, kSize.y}, 1, 0, static_cast<uint32_t>(mesh.indices.size())}};
  return mesh;
}

/// The canvas at its fullest: a town painted in full, a sheet full of ink, panels.
struct Desk {
  std::unique_ptr<CanvasTarget> target;
  std::unique_ptr<ScenePainter> painter;
  std::shared_ptr<const Scene> town;
  Camera camera = tests::HouseCamera(kSize.x, kSize.y);
  UiMesh panels = Panels();
  uint64_t next_stroke = kStrokes + 1;
  Pen pen;
  std::atomic<bool> repainting = false;  ///< each picture is followed by another

  explicit Desk(OffscreenTarget kind) : target(CanvasTarget::Create(kind, kSize, 2)) {
    if (!target) return;
    town = std::make_shared<Scene>(tests::Town(kTownSide, 10));
    camera.eye = {kTownSide * 9, kTownSide * 5, kTownSide * 11};
    camera.target = {kTownSide * 3, 0, kTownSide * 3};
    auto shared = target->context().CreateShared();
    painter = std::move(*ScenePainter::Start(std::move(*shared), [this] {
      if (repainting) painter->Request({town, camera, true});
    }));
    painter->Request({town, camera});
    while (painter->busy()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    target->canvas().SetPicture(ToCanvas(painter->newest()));
    target->canvas().SetStrokes(Sheet());
    (void)target->canvas().SetPanelTexture(1, {1, 1, {255, 255, 255, 255}});
    for (int i = 0; i < 3; ++i) (void)target->Draw();
    target->gl().Finish();
  }
};

struct Samples {
  std::vector<double> cpu_ms, wall_ms, before_ms;

  static double At(std::vector<double> values, double part) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(part * static_cast<double>(values.size() - 1))];
  }
};

/// Samples into the canvas, then the frame until GL has finished it.
void DrawFrames(Desk* desk, int frames, Samples* samples) {
  Canvas& canvas = desk->target->canvas();
  for (int frame = 0; frame < frames; ++frame) {
    if (frame % 60 == 0) canvas.BeginStroke(desk->next_stroke++, kInk);
    const double cpu = Seconds(CLOCK_THREAD_CPUTIME_ID), wall = Seconds(CLOCK_MONOTONIC);
    for (int i = 0; i < kSamplesPerFrame; ++i) {
      const Vec2f at = desk->pen.Next();
      const float width = desk->pen.width();
      canvas.AddSamples({&at, 1}, {&width, 1});
    }
    Pen ahead = desk->pen;
    const std::array<Vec2f, 2> next = {ahead.Next(), ahead.Next()};
    const std::array<float, 2> widths = {ahead.width(), ahead.width()};
    canvas.SetPrediction(next, widths);
    canvas.SetMarksAbovePanels({{{next[1]}, {0.1f, 0.1f, 0.1f, 1}, 6, 0}});  // the cursor
    canvas.SetPanels(desk->panels);  // each frame anew, as panels are made
    const double before = Seconds(CLOCK_THREAD_CPUTIME_ID);
    CHECK(!desk->target->Draw().empty(), "each frame shows new ink");
    desk->target->gl().Finish();
    samples->cpu_ms.push_back(1e3 * (Seconds(CLOCK_THREAD_CPUTIME_ID) - cpu));
    samples->wall_ms.push_back(1e3 * (Seconds(CLOCK_MONOTONIC) - wall));
    samples->before_ms.push_back(1e3 * (before - cpu) / kSamplesPerFrame);
    if (frame % 60 == 59) canvas.EndStroke();
  }
  canvas.EndStroke();
}

void Report(benchmark::State& state, const Samples& samples) {
  state.SetLabel(std::string("LP_NUM_THREADS=") + std::getenv("LP_NUM_THREADS"));
  state.counters["cpu_p50_ms"] = Samples::At(samples.cpu_ms, 0.5);
  state.counters["cpu_p99_ms"] = Samples::At(samples.cpu_ms, 0.99);
  state.counters["wall_p50_ms"] = Samples::At(samples.wall_ms, 0.5);
  state.counters["wall_p99_ms"] = Samples::At(samples.wall_ms, 0.99);
  state.counters["per_sample_p99_ms"] = Samples::At(samples.before_ms, 0.99);
}

/// What is done once: all strokes are sent, and one in their middle is taken away.
void BenchInkSheet(benchmark::State& state) {
  Desk desk(OffscreenTarget::kOsMesa);
  if (!desk.target) return state.SkipWithError("no such context");
  std::vector<InkStroke> strokes = Sheet();
  const auto draw_ms = [&] {
    const double begin = Seconds(CLOCK_PROCESS_CPUTIME_ID);
    desk.target->canvas().SetStrokes(strokes);
    (void)desk.target->Draw();
    desk.target->gl().Finish();
    return 1e3 * (Seconds(CLOCK_PROCESS_CPUTIME_ID) - begin);
  };
  for (auto _ : state) {
    state.counters["same_ms"] = draw_ms();
    strokes.erase(strokes.begin() + kStrokes / 2);
    state.counters["one_less_ms"] = draw_ms();
    strokes.clear();
    state.counters["none_ms"] = draw_ms();
    desk.target->canvas().DamageAll();
    state.counters["composed_without_ink_ms"] = draw_ms();
    strokes = Sheet();
    state.counters["all_ms"] = draw_ms();
    desk.target->canvas().DamageAll();
    state.counters["composed_with_ink_ms"] = draw_ms();
  }
}
BENCHMARK(BenchInkSheet)->Iterations(1)->Unit(benchmark::kMillisecond);

void BenchInkFrame(benchmark::State& state) {
  Desk desk(static_cast<OffscreenTarget>(state.range(0)));
  if (!desk.target) return state.SkipWithError("no such context");
  Samples samples;
  for (auto _ : state) DrawFrames(&desk, kFrames, &samples);
  Report(state, samples);
}
BENCHMARK(BenchInkFrame)
    ->ArgName("target")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

/// Keeps a thread busy for as long as it lives.
class BusyThread {
 public:
  BusyThread() : thread_([this] { Work(); }) {}
  ~BusyThread() {
    stop_ = true;
    thread_.join();
  }

 private:
  void Work() {
    double sum = 0;
    for (int i = 0; !stop_; ++i) sum += std::sin(i);
    benchmark::DoNotOptimize(sum);
  }
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

/// Draws for 3 s beside nothing, then beside `Other`, five times over; the largest and the median
/// change of the median.
template <typename Other>
void CompareBeside(benchmark::State& state, const Other& other) {
  Desk desk(OffscreenTarget::kOsMesa);
  if (!desk.target) return state.SkipWithError("no such context");
  std::vector<double> alone, beside;
  Samples all_beside;
  const auto draw_3_s = [&desk](Samples* samples) {
    const double until = Seconds(CLOCK_MONOTONIC) + 3;
    while (Seconds(CLOCK_MONOTONIC) < until) DrawFrames(&desk, 60, samples);
    return Samples::At(samples->cpu_ms, 0.5);
  };
  for (auto _ : state) {
    for (int run = 0; run < 5; ++run) {
      Samples quiet, busy;
      alone.push_back(draw_3_s(&quiet));
      beside.push_back(other(&desk, [&] { return draw_3_s(&busy); }));
      all_beside.wall_ms.insert(all_beside.wall_ms.end(), busy.wall_ms.begin(), busy.wall_ms.end());
    }
  }
  state.counters["alone_p50_ms"] = Samples::At(alone, 0.5);
  state.counters["beside_p50_ms"] = Samples::At(beside, 0.5);
  state.counters["change"] = Samples::At(beside, 0.5) / Samples::At(alone, 0.5) - 1;
  state.counters["beside_wall_p50_ms"] = Samples::At(all_beside.wall_ms, 0.5);
  state.counters["beside_wall_p99_ms"] = Samples::At(all_beside.wall_ms, 0.99);
}

void BenchInkBesideABusyThread(benchmark::State& state) {
  CompareBeside(state, [](Desk*, const auto& draw) {
    const BusyThread busy;
    return draw();
  });
}
BENCHMARK(BenchInkBesideABusyThread)->Iterations(1)->Unit(benchmark::kMillisecond);

/// The model is painted anew all the time, as while the camera moves.
void BenchInkBesideThePainter(benchmark::State& state) {
  CompareBeside(state, [](Desk* desk, const auto& draw) {
    desk->repainting = true;
    desk->painter->Request({desk->town, desk->camera, true});
    const double median = draw();
    desk->repainting = false;
    return median;
  });
}
BENCHMARK(BenchInkBesideThePainter)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::render
