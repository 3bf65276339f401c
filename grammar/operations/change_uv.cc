// tileUV, scaleUV, translateUV, rotateUV, normalizeUV, deleteUV: texture coordinates that a shape
// has, changed. Laying them out is texture.cc's. CGA's texture layers but the color's (0) are kept
// by nothing, so that other layers change nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grammar/operations/row_parts.h"
#include "grammar/texture_extent.h"

namespace parti::grammar {
namespace {

using Products = Result<std::vector<Product>>;

bool IsColor(const Action& action) { return std::get<double>(action.arguments[0]) == 0; }
double NumberAt(const Action& action, size_t i) { return std::get<double>(action.arguments[i]); }

Products Same(const Item& item) { return std::vector<Product>{{item, -1}}; }

Products Painted(const Item& item, const std::optional<TextureMap>& map) {
  Paint paint = item.paint ? *item.paint : Paint();
  paint.map = map;
  Item painted = item;
  painted.paint = std::make_shared<const Paint>(std::move(paint));
  return std::vector<Product>{{std::move(painted), -1}};
}

/// (u, v) multiplied, then moved.
TextureMap Changed(TextureMap map, const Vec2& factor, const Vec2& shift) {
  map.u *= factor.x;
  map.v *= factor.y;
  map.offset = map.offset * factor + shift;
  return map;
}

Products ApplyScale(const Item& item, const Action& action) {
  if (!IsColor(action)) return Same(item);
  const Vec2 factor(NumberAt(action, 1), NumberAt(action, 2));
  return Painted(item, Changed(TextureMapOf(item), factor, Vec2(0, 0)));
}

Products ApplyShift(const Item& item, const Action& action) {
  if (!IsColor(action)) return Same(item);
  const Vec2 shift(NumberAt(action, 1), NumberAt(action, 2));
  return Painted(item, Changed(TextureMapOf(item), Vec2(1, 1), shift));
}

Products ApplyTurn(const Item& item, const Action& action) {
  if (!IsColor(action)) return Same(item);
  const Angle angle = Angle::Degrees(NumberAt(action, 1));
  const double cosine = std::cos(angle.radians()), sine = std::sin(angle.radians());
  const TextureMap map = TextureMapOf(item);
  TextureMap turned;
  turned.u = map.u * cosine - map.v * sine;
  turned.v = map.u * sine + map.v * cosine;
  turned.offset = Vec2(map.offset.x * cosine - map.offset.y * sine,
                       map.offset.x * sine + map.offset.y * cosine);
  return Painted(item, turned);
}

/// What a coordinate is multiplied by so that the image is that large: `rate_1_m` is how fast it
/// runs now, `extent` how far over the whole shape. 0 leaves it as it is.
double FactorFor(const Size& size, double rate_1_m, double extent) {
  if (size.value == 0 || rate_1_m <= 0 || extent <= 0) return 1;
  if (size.kind == Size::Kind::kRelative) return 1 / (size.value * extent);
  const double length_m = extent / rate_1_m;
  if (size.kind == Size::Kind::kAbsolute) return 1 / (size.value * rate_1_m);
  const double times = std::max(1.0, std::round(length_m / std::abs(size.value)));
  return std::copysign(times / extent, size.value);
}

Products ApplyTile(const Item& item, const Action& action) {
  if (!IsColor(action)) return Same(item);
  const TextureMap map = TextureMapOf(item);
  const Box2 box = TextureExtent(item, map);
  const Vec2 extent = box.high - box.low;
  const Vec2 factor(FactorFor(std::get<Size>(action.arguments[1]), glm::length(map.u), extent.x),
                    FactorFor(std::get<Size>(action.arguments[2]), glm::length(map.v), extent.y));
  return Painted(item, Changed(map, factor, Vec2(0, 0)));
}

constexpr std::string_view kBoth = "uv", kU = "u", kV = "v";

Products ApplyNormalize(const Item& item, const Action& action) {
  if (!IsColor(action)) return Same(item);
  const auto& which = std::get<std::string>(action.arguments[1]);
  const TextureMap map = TextureMapOf(item);
  const Box2 box = TextureExtent(item, map);
  Vec2 factor(1, 1), shift(0, 0);
  for (int i = 0; i < 2; ++i) {
    const double extent = box.high[i] - box.low[i];
    const bool is_meant = which == kBoth || which == (i == 0 ? kU : kV);
    if (!is_meant || extent <= 0) continue;
    factor[i] = 1 / extent;
    shift[i] = -box.low[i] / extent;
  }
  return Painted(item, Changed(map, factor, shift));
}

Products ApplyDelete(const Item& item, const Action& action) {
  return IsColor(action) ? Painted(item, std::nullopt) : Same(item);
}

Parameter Number(std::string_view name, double value, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kFactor,
          .low = -1e6,
          .high = 1e6,
          .default_value = value,
          .doc = doc};
}

Parameter TileSize(std::string_view name) {
  return {.name = name,
          .kind = ParameterKind::kSize,
          .low = -1e6,
          .high = 1e6,
          .default_value = Size{Size::Kind::kAbsolute, 1},
          .doc = "of the image: metres, ~2 for a whole number of times, '1 for once; 0 leaves it",
          .words = kFloatingToo};
}

constexpr std::array<std::string_view, 3> kWays = {kBoth, kU, kV};
constexpr std::array<std::string_view, 2> kFaces = {"collectiveAllFaces", "separatePerFace"};

const std::array<Parameter, 3> kScaleParameters = {UvSetParameter(), Number("uFactor", 1, "for u"),
                                                   Number("vFactor", 1, "for v")};
const std::array<Parameter, 3> kShiftParameters = {UvSetParameter(), Number("u", 0, "to the right"),
                                                   Number("v", 0, "up")};
const std::array<Parameter, 2> kTurnParameters = {
    UvSetParameter(), TurnParameter("angle", "of the coordinates, about (0, 0)")};
const std::array<Parameter, 3> kTileParameters = {UvSetParameter(), TileSize("width"),
                                                  TileSize("height")};
const std::array<Parameter, 3> kNormalizeParameters = {
    UvSetParameter(),
    Parameter{.name = "coordinates",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kBoth),
              .doc = "which of them",
              .words = kWays},
    Parameter{.name = "faces",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kFaces[0]),
              .required = false,
              .doc = "all of a shape's together, which is all that is known here",
              .words = kFaces}};
const std::array<Parameter, 1> kDeleteParameters = {UvSetParameter()};

constexpr Operation Row(std::string_view name, std::string_view word, std::string_view doc,
                        std::span<const Parameter> parameters,
                        Products (*apply)(const Item&, const Action&)) {
  return {.name = name,
          .word = word,
          .doc = doc,
          .source = "CGA",
          .parameters = parameters,
          .takes = kSurfaced,
          .gives = kSurfaced,
          .in_place = true,
          .sampled = false,
          .apply = apply};
}

}  // namespace

constinit const Operation kTileUv =
    Row("tileUV", "TileUV", "Makes the image of a shape that large, from where it begins.",
        kTileParameters, ApplyTile);
constinit const Operation kScaleUv =
    Row("scaleUV", "ScaleUV", "Multiplies texture coordinates: 2 shows the image twice.",
        kScaleParameters, ApplyScale);
constinit const Operation kTranslateUv =
    Row("translateUV", "TranslateUV", "Moves texture coordinates: 0.5 by half an image.",
        kShiftParameters, ApplyShift);
constinit const Operation kRotateUv =
    Row("rotateUV", "RotateUV", "Turns texture coordinates.", kTurnParameters, ApplyTurn);
constinit const Operation kNormalizeUv =
    Row("normalizeUV", "NormalizeUV", "Fits the image once over the shape.", kNormalizeParameters,
        ApplyNormalize);
constinit const Operation kDeleteUv =
    Row("deleteUV", "DeleteUV", "Takes the texture coordinates of a shape away.", kDeleteParameters,
        ApplyDelete);

}  // namespace parti::grammar
