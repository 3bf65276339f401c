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

std::vector<std::pair<Polygon, Polygon>> CutPairs(size_t count, uint64_t seed) {
  Random random(seed);
  std::vector<std::pair<Polygon, Polygon>> pairs;
  while (pairs.size() < count) {
    const Polygon gable = Gable(&random);
    Polygon a = CutPiece(gable, AnyShape(&random)), b = CutPiece(gable, AnyShape(&random));
    if (a.outer.size() < 3 || b.outer.size() < 3) continue;
    if (random.Uniform() < 0.3) b = CutPiece(a, b);  // inside, sharing borders
    if (b.outer.size() < 3 || grammar::Area(b) < 1e-6) continue;
    pairs.emplace_back(std::move(a), std::move(b));
  }
  return pairs;
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
