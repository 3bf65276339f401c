// Frame times at 1600 x 1000: what a view change costs, and what a changed scene costs.
#include <benchmark/benchmark.h>

#include "render/offscreen.h"
#include "tests/support/sample_scenes.h"

namespace parti::render {
namespace {

Camera TownCamera(int n) {
  Camera camera = tests::HouseCamera(1600, 1000);
  camera.eye = Vec3(n * 9, n * 5, n * 11);
  camera.target = {n * 3, 0, n * 3};
  return camera;
}

/// A town of n x n plots and about 10 storeys each, uploaded and drawn.
void BenchDrawScene(benchmark::State& state) {
  const auto target = static_cast<OffscreenTarget>(state.range(1));
  auto renderer = OffscreenRenderer::Create(target);
  if (!renderer) return state.SkipWithError(renderer.error().message.c_str());
  const int n = static_cast<int>(state.range(0));
  const Scene scene = tests::Town(n, 10);
  const Camera camera = TownCamera(n);
  (void)(*renderer)->Draw(scene, camera);  // compiles what the shaders become
  for (auto _ : state) {
    auto image = (*renderer)->Draw(scene, camera);
    if (!image) return state.SkipWithError(image.error().message.c_str());
    benchmark::DoNotOptimize(image->pixels.data());
  }
  state.counters["shapes"] = static_cast<double>(scene.faces.size());
  state.SetLabel(std::string((*renderer)->name()));
}
BENCHMARK(BenchDrawScene)
    ->ArgNames({"plots", "target"})
    ->Args({1, 1})
    ->Args({32, 1})
    ->Args({32, 2})
    ->Args({100, 1})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()  // of the rasteriser's threads too
    ->UseRealTime();

void BenchDrawIds(benchmark::State& state) {
  auto renderer = OffscreenRenderer::Create();
  if (!renderer) return state.SkipWithError(renderer.error().message.c_str());
  const Scene scene = tests::Town(32, 10);
  for (auto _ : state) {
    auto ids = (*renderer)->DrawIds(scene, TownCamera(32));
    if (!ids) return state.SkipWithError(ids.error().message.c_str());
    benchmark::DoNotOptimize(ids->data());
  }
}
BENCHMARK(BenchDrawIds)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace parti::render
