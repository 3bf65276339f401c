// Compares 2D libraries on what façades ask of them: robustness first, then speed. Areas are
// compared with those of CGAL's exact numbers. Prints the table of docs/layers.md.
#include <fmt/format.h>

#include <cmath>
#include <ctime>

#include "tests/bench/overlay/facade_scenes.h"
#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

constexpr double kWrong_m2 = 1e-5;

double AreaOf(const Polygons& polygons) {
  double area = 0;
  for (const grammar::Polygon& polygon : polygons) area += grammar::Area(polygon);
  return area;
}

/// How one library did on one kind of work.
struct Score {
  size_t calls = 0, refused = 0, wrong = 0;
  double worst_m2 = 0;
  std::clock_t clocks = 0;  ///< of the processor

  template <typename Work>
  void Time(double right_m2, const Work& work) {
    const std::clock_t start = std::clock();
    const std::optional<Polygons> result = work();
    clocks += std::clock() - start;
    ++calls;
    if (!result) {
      ++refused;
      return;
    }
    const double off = std::abs(AreaOf(*result) - right_m2);
    wrong += off > kWrong_m2 ? 1 : 0;
    worst_m2 = std::max(worst_m2, off);
  }
  void Print(std::string_view work, std::string_view library) const {
    fmt::print("| {} | {} | {} | {} | {} | {:.1e} | {:.1f} |\n", work, library, calls, refused,
               wrong, worst_m2,
               1e6 * static_cast<double>(clocks) / CLOCKS_PER_SEC / static_cast<double>(calls));
  }
};

constexpr const OverlayLibrary* kLibraries[] = {&kGeos, &kGeosOnGrid, &kClipper, &kBoostPolygon,
                                                &kCgal};

void ComparePairs(std::string_view work, const std::vector<Pair>& pairs) {
  std::vector<double> right;
  for (const auto& [a, b] : pairs) right.push_back(AreaOf(kCgal.intersection(a, b).value()));
  for (const OverlayLibrary* library : kLibraries) {
    Score score;
    for (size_t i = 0; i < pairs.size(); ++i) {
      score.Time(right[i], [&] { return library->intersection(pairs[i].first, pairs[i].second); });
    }
    score.Print(work, library->name);
    std::fflush(stdout);
  }
}

void CompareScenes(std::string_view work, const std::vector<WallScene>& scenes) {
  std::vector<double> right;
  for (const WallScene& scene : scenes) {
    right.push_back(AreaOf(kCgal.difference(scene.wall, scene.parts).value()));
  }
  for (const OverlayLibrary* library : kLibraries) {
    Score score;
    for (size_t i = 0; i < scenes.size(); ++i) {
      score.Time(right[i], [&] { return library->difference(scenes[i].wall, scenes[i].parts); });
    }
    score.Print(work, library->name);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace parti::bench

int main(int argc, char** argv) {
  using namespace parti::bench;
  fmt::print("| work | library | calls | refused | wrong | worst m^2 | us a call |\n");
  fmt::print("| --- | --- | ---: | ---: | ---: | ---: | ---: |\n");
  ComparePairs("pieces cut before", CutPairs(argc > 2 ? std::stoul(argv[2]) : 5000, 7));
  ComparePairs("the pair of a failure", {PairOfAFailure()});
  CompareScenes("900 rectangles from a wall", {RectangleGrid(20, 15)});
  CompareScenes("300 arches, 600 rectangles", {ArchedGrid(20, 15)});
  const auto real = RealFacades(argc > 1 ? argv[1] : "");
  if (!real.empty()) CompareScenes("real facades", real);
  return 0;
}
