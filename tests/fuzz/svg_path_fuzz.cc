// SVG paths from any bytes: read, sampled, and laid out by vectorial in a scene that is normalised.
#include <cmath>
#include <cstdint>

#include "base/check.h"
#include "grammar/layers/normalise.h"
#include "grammar/layers/path_rings.h"
#include "grammar/operation.h"

namespace parti::grammar {
namespace {

/// A wall with a tile in front of which the shape is drawn.
struct Wall {
  ShapeTree tree;
  ShapeIndex tile;

  Wall() : tree(Planar(), "Wall") {
    Item item = tree[0].item;
    item.type = ItemType::kShape2D;
    item.fixed_geometry = false;
    item.scope.origin = Vec3(1, 1, 0);
    item.scope.size = Vec3(3, 2, 0);
    tile = tree.Append(0, item, kNoName, nullptr);
  }
  static Item Planar() {
    Item item;
    item.scope.size = Vec3(5, 4, 0);
    return item;
  }
};

void TryRings(const SvgPath& path) {
  for (const auto& loop : path) {
    CHECK(!loop.empty(), "a loop goes somewhere");
    for (size_t i = 0; i < loop.size(); ++i) {
      CHECK(loop[i].end() == loop[(i + 1) % loop.size()].start(), "loops are closed");
    }
  }
  for (const Ring& ring : RingsOf(path, 20, Vec2(3, 2))) {
    for (const Vec2& p : ring) CHECK(std::isfinite(p.x) && std::isfinite(p.y), "finite corners");
  }
}

void TryScene(std::string_view text) {
  Wall wall;
  Action action = Default(*FindOperation("vectorial"));
  action.arguments = {std::string(text), 20.0};
  const auto made = Apply(action, wall.tree[wall.tile].item);
  if (!made) {
    CHECK(!made.error().message.empty(), "a refusal says why");
    return;
  }
  const ShapeIndex drawn =
      wall.tree.Append(wall.tile, made->front().item, kNoName, action.operation);
  const ShapeIndex shapes[] = {wall.tile, drawn};
  const auto scene = Normalise(&wall.tree, 0, shapes);
  CHECK(scene.has_value(), "what vectorial makes is normalised");
  double area = 0;
  for (const auto& pieces : scene->pieces) {
    for (const ShapeIndex i : pieces) area += AreaOf(wall.tree[i].item);
  }
  for (const Uncovered& free : scene->uncovered) area += Area(free.polygon);
  CHECK(std::abs(area - 20) < 1e-4, "pieces and background fill the wall");
}

void Try(std::string_view text) {
  const auto path = ParseSvgPath(text);
  if (!path) {
    CHECK(path.error().place.has_value(), "an error in a text has a place");
    (void)FormatError(path.error());
    return;
  }
  TryRings(*path);
  if (text.size() < 2000) TryScene(text);
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::grammar::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
