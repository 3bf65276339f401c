// vectorial("M0,0 …", samples): a 2D shape drawn as an SVG path in its predecessor's rectangle.
// The path itself is read by layers/svg_path.h.
#include <array>
#include <cmath>
#include <utility>

#include "grammar/layers/path_rings.h"
#include "grammar/operations/rows.h"
#include "grammar/operations/scene_item.h"

namespace parti::grammar {
namespace {

Result<std::vector<Product>> ApplyVectorial(const Item& item, const Action& action) {
  const auto& text = std::get<std::string>(action.arguments[0]);
  const auto samples = static_cast<int>(std::lround(std::get<double>(action.arguments[1])));
  const auto path = ParseSvgPath(text);
  if (!path) return Fail(path);
  const Vec2 size(item.scope.size.x, item.scope.size.y);
  auto polygon = PolygonFrom(RingsOf(*path, samples, size));
  if (!polygon) {
    Error error = polygon.error();
    error.message = "vectorial: " + error.message;
    error.place = PlaceIn(text, "", 0, text.size());
    return tl::unexpected<Error>(std::move(error));
  }
  const Box2 box = Bounds(*polygon);
  Item made = SceneItem(item, box.low, box.high - box.low);
  for (Vec2& p : polygon->outer) p -= box.low;
  for (Ring& hole : polygon->holes) {
    for (Vec2& p : hole) p -= box.low;
  }
  made.polygon = std::make_shared<const Polygon>(std::move(*polygon));
  return std::vector<Product>{{std::move(made), -1}};
}

const std::array<Parameter, 2> kParameters = {{
    {
        .name = "path",
        .kind = ParameterKind::kText,
        .default_value = std::string("M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z"),
        .doc = "path data as in SVG, but with y up; 0 to 1 is the shape's bounding rectangle",
    },
    {
        .name = "samples",
        .kind = ParameterKind::kFactor,
        .low = 1,
        .high = 10'000,
        .default_value = 50.0,
        .required = false,
        .doc = "corners that are spread over the path's curves",
    },
}};

}  // namespace

constinit const Operation kVectorial = {
    .name = "vectorial",
    .word = "Vectorial",
    .doc =
        "Lays a 2D shape out that is drawn as a path, over what it is made from, and clipped to "
        "it: all commands of SVG paths; further loops are holes.",
    .source = "Jesus 2018, (4.13), Listing 4.4; errata 4",
    .parameters = kParameters,
    .takes = kSceneItemTypes,
    .gives = Types(ItemType::kShape2D),
    .in_place = false,
    .sampled = false,
    .apply = ApplyVectorial,
};

}  // namespace parti::grammar
