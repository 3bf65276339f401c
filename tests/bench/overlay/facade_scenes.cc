#include "tests/bench/overlay/facade_scenes.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

using grammar::Polygon;

Polygon Box(const Vec2& low, const Vec2& high) {
  return {{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)}, {}};
}

Polygon Arch(const Vec2& low, const Vec2& high, int samples) {
  const Vec2 size = high - low;
  Polygon arch{{low, Vec2(high.x, low.y)}, {}};
  for (int i = 0; i <= samples; ++i) {
    const double angle = kPi * i / samples;
    arch.outer.push_back(low +
                         Vec2(0.5 + 0.5 * std::cos(angle), 0.5 + 0.5 * std::sin(angle)) * size);
  }
  return arch;
}

/// A star-shaped polygon: slanted edges in all directions.
Polygon Gable(Random* random) {
  Polygon gable;
  const int corners = 5 + static_cast<int>(random->Uniform(0, 15));
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + random->Uniform(0.1, 0.9)) / corners;
    const double radius = random->Uniform(3, 8);
    gable.outer.push_back(Vec2(8, 8) + Vec2(std::cos(angle), std::sin(angle)) * radius);
  }
  return gable;
}

double Coordinate(Random* random) {
  const double any = random->Uniform(0, 16);
  if (random->Uniform() < 0.4) return any;
  const double grid = std::round(any * 2) / 2;
  return random->Uniform() < 0.8 ? grid : grid + random->Uniform(-1e-12, 1e-12);
}

Polygon AnyShape(Random* random) {
  const Vec2 a(Coordinate(random), Coordinate(random)), b(Coordinate(random), Coordinate(random));
  const Vec2 low = glm::min(a, b), high = glm::max(a, b) + Vec2(0.5, 0.5);
  return random->Uniform() < 0.5 ? Box(low, high) : Arch(low, high, 7);
}

/// One piece of the shape inside the gable, as doubles.
Polygon CutPiece(const Polygon& gable, const Polygon& shape) {
  const auto pieces = kCgal.intersection(gable, shape);
  if (!pieces || pieces->empty()) return {};
  const Polygon* largest = &pieces->front();
  for (const Polygon& piece : *pieces) {
    if (grammar::Area(piece) > grammar::Area(*largest)) largest = &piece;
  }
  return *largest;
}

/// A few last bits to either side, as chains of cuts leave them.
Polygon Rounded(Polygon polygon, Random* random) {
  for (Vec2& p : polygon.outer) {
    p.x *= 1 + std::round(random->Uniform(-2.5, 2.5)) * 0x1p-52;
    p.y *= 1 + std::round(random->Uniform(-2.5, 2.5)) * 0x1p-52;
  }
  return polygon;
}

WallScene Grid(int columns, int rows, bool arched) {
  WallScene scene{Box({0, 0}, {3.0 * columns, 3.0 * rows}), {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 tile(3.0 * column, 3.0 * row);
      const Vec2 low = tile + Vec2(0.8, 1.0), high = tile + Vec2(2.2, 2.6);
      scene.parts.push_back(arched ? Arch(low, high, 24) : Box(low, high));
      scene.parts.push_back(Box(tile + Vec2(0.7, 0.8), tile + Vec2(2.3, 1.0)));
      scene.parts.push_back(Box(tile, tile + Vec2(0.2, 3)));
    }
  }
  return scene;
}

}  // namespace

std::vector<Pair> CutPairs(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<Pair> pairs;
  while (pairs.size() < count) {
    const Polygon gable = Gable(&random);
    Polygon a = CutPiece(gable, AnyShape(&random)), b = CutPiece(gable, AnyShape(&random));
    if (a.outer.size() < 3 || b.outer.size() < 3) continue;
    if (random.Uniform() < 0.3) b = CutPiece(a, b);  // inside, sharing borders
    if (b.outer.size() < 3 || grammar::Area(b) < 1e-6) continue;
    pairs.emplace_back(Rounded(std::move(a), &random), Rounded(std::move(b), &random));
  }
  return pairs;
}

Pair PairOfAFailure() {
  return {{{{0.75504638830598292, 4.6551073336747599},
            {2.3735584563668635, 3.210567539009813},
            {3.0010476886974855, 3},
            {7.5100000000000016, 3},
            {7.5100000000000016, 4.2549999999999999},
            {7.1628958819979793, 4.7995240925925353},
            {6.1903317555148618, 5.2361985104973776},
            {4.7849358735168828, 5.4785345297881882},
            {3.2250641264831197, 5.4785345297881882},
            {1.8196682444851404, 5.2361985104973776},
            {0.84710411800202268, 4.7995240925925353}},
           {}},
          {{{10.816702107840824, 8.3466129061607237},
            {10.166236883441252, 8.3084214211336374},
            {10.816702107840824, 11.471581452145104},
            {10.816702107840824, 15.160663326581254},
            {9.3445427666024212, 13.921046722926857},
            {6.8117606134948705, 14.481691975121281},
            {6.7865723323810672, 9.8936095255702128},
            {5.3269434642172273, 9.307585393181899},
            {1.5949208255224558, 9.0078944124680778},
            {0.50000000000000044, 7.546751179162249},
            {0.50000000000000044, 4.8827390360660594},
            {2.3735584563668635, 3.210567539009813},
            {4.9216962190974272, 2.3554849812370344},
            {5.4597018992002431, 0},
            {8.4087010163772078, 1.4362508623621411},
            {10.145774491817861, 0.41354531559044538},
            {10.816702107840824, 0.45927933950051492}},
           {}}};
}

WallScene ArchedGrid(int columns, int rows) { return Grid(columns, rows, true); }
WallScene RectangleGrid(int columns, int rows) { return Grid(columns, rows, false); }

std::vector<WallScene> RealFacades(const std::string& path) {
  constexpr double kWidth_m = 20;
  std::vector<WallScene> scenes;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    WallScene scene;
    const nlohmann::json facade = nlohmann::json::parse(line);
    for (const auto& e : facade["elements"]) {
      const Vec2 low(e["x0"].get<double>(), e["y0"].get<double>());
      const Vec2 high(e["x1"].get<double>(), e["y1"].get<double>());
      Polygon box = Box(low * kWidth_m, high * kWidth_m);
      if (e["label"] == "facade") {
        scene.wall = std::move(box);
      } else if (high.x > low.x && high.y > low.y) {
        scene.parts.push_back(std::move(box));
      }
    }
    if (!scene.wall.outer.empty()) scenes.push_back(std::move(scene));
  }
  return scenes;
}

}  // namespace parti::bench
