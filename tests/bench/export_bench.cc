// What a file of a town costs in time and memory: houses of 40 boxes and 8 fine sheets, 20,080
// triangles each.
#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "app/export_glb.h"
#include "app/export_obj.h"

namespace parti::app {
namespace {

void AddQuad(const Vec3& at, const Vec3& u, const Vec3& v, std::vector<Vec3>* corners) {
  corners->insert(corners->end(), {at, at + u, at + u + v, at, at + u + v, at + v});
}

/// A wavy sheet of 2 * cells * cells triangles, no two of which are coplanar.
ModelPart Sheet(const Vec3& at, int cells) {
  ModelPart part{"Sheet", 0xC8A084, false, {}};
  const auto point = [&](int x, int z) {
    return at + Vec3(0.02 * x, 0.01 * std::sin(1.7 * x + 2.3 * z), 0.02 * z);
  };
  for (int x = 0; x < cells; ++x) {
    for (int z = 0; z < cells; ++z) {
      const Vec3 a = point(x, z), b = point(x, z + 1), c = point(x + 1, z + 1), d = point(x + 1, z);
      part.corners.insert(part.corners.end(), {a, b, c, a, c, d});
    }
  }
  return part;
}

ModelPart Box(const Vec3& at) {
  ModelPart part{"Box", 0, true, {}};
  const Vec3 x(0.4, 0, 0), y(0, 1.2, 0), z(0, 0, 0.3);
  AddQuad(at, y, x, &part.corners);
  AddQuad(at + z, x, y, &part.corners);
  AddQuad(at, x, z, &part.corners);
  AddQuad(at + y, z, x, &part.corners);
  AddQuad(at, z, y, &part.corners);
  AddQuad(at + x, y, z, &part.corners);
  return part;
}

ModelMesh Town(int houses) {
  ModelMesh mesh;
  for (int house = 0; house < houses; ++house) {
    const int row = house / 20;
    const Vec3 place(12.3 * (house % 20), 0, 17.9 * row);
    for (int i = 0; i < 40; ++i) mesh.parts.push_back(Box(place + Vec3(0.7 * i, 0, 0)));
    for (int i = 0; i < 8; ++i) mesh.parts.push_back(Sheet(place + Vec3(0, 0.5 * i, 0), 35));
  }
  return mesh;
}

/// The most memory of a process of its own that does this and ends; bytes.
template <typename Work>
double PeakOf(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  rusage usage{};
  wait4(child, nullptr, 0, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// What an export, which returns the size of its file, takes beside the model: as a multiple of it.
template <typename Export>
void CountMemory(const Export& exported, benchmark::State* state) {
  const double idle = PeakOf([] {});
  const double busy = PeakOf([&] { benchmark::DoNotOptimize(exported()); });
  state->counters["memory/file"] = (busy - idle) / static_cast<double>(exported());
}

void CountTriangles(const ModelMesh& mesh, benchmark::State* state) {
  state->counters["triangles/s"] =
      benchmark::Counter(static_cast<double>(PartsOf(mesh).most_triangles),
                         benchmark::Counter::kIsIterationInvariantRate);
}

void BenchGlb(benchmark::State& state) {
  const ModelMesh mesh = Town(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(GltfBytes(mesh, GltfForm::kBinary));
  CountTriangles(mesh, &state);
  CountMemory([&] { return GltfBytes(mesh, GltfForm::kBinary)->size(); }, &state);
}
BENCHMARK(BenchGlb)->Arg(2)->Arg(50)->Unit(benchmark::kMillisecond);

void BenchObj(benchmark::State& state) {
  const ModelMesh mesh = Town(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(ObjTextOf(mesh, "town.mtl"));
  CountTriangles(mesh, &state);
  CountMemory([&] { return ObjTextOf(mesh, "town.mtl")->obj.size(); }, &state);
}
BENCHMARK(BenchObj)->Arg(2)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace parti::app
