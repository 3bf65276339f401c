// texture(file), setupProjection, projectUV and what moves texture coordinates afterwards.
// Reading the image is the library's (asset_library.h); coordinates are maps (material.h), so that
// all that is made of a shape keeps them.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

#include "grammar/asset.h"
#include "grammar/item_place.h"
#include "grammar/operations/row_parts.h"
#include "grammar/texture_extent.h"

namespace parti::grammar {
namespace {

using Products = Result<std::vector<Product>>;

Products Painted(const Item& item, Paint paint) {
  Item painted = item;
  painted.paint = std::make_shared<const Paint>(std::move(paint));
  return std::vector<Product>{{std::move(painted), -1}};
}

Paint PaintOf(const Item& item) { return item.paint ? *item.paint : Paint(); }

/// The image once over the scope's x and y.
TextureMap OnceOver(const Scope& s) {
  TextureMap map;
  map.u = s.size.x > 0 ? s.x / s.size.x : s.x;
  map.v = s.size.y > 0 ? s.y / s.size.y : s.y;
  map.offset = -Vec2(glm::dot(map.u, s.origin), glm::dot(map.v, s.origin));
  return map;
}

Products ApplyTexture(const Item& item, const Action& action) {
  const auto& file = std::get<std::string>(action.arguments[0]);
  if (file.empty()) return std::vector<Product>{{item, -1}};
  if (!action.asset) {
    return Fail(ErrorCode::kFile, fmt::format("'{}' was not read", file),
                "wear images where files may be read");
  }
  if (!action.asset->image) {
    return Fail(ErrorCode::kFile, fmt::format("'{}' is no image", file), "give a .png or .jpg");
  }
  Paint paint = PaintOf(item);
  Material material = paint.material ? *paint.material : Material();
  material.image = action.asset->image;
  if (material.name.empty()) material.name = material.image->name;
  paint.material = std::make_shared<const Material>(std::move(material));
  if (!paint.map && item.type == ItemType::kPlanar) paint.map = OnceOver(item.scope);
  return Painted(item, std::move(paint));
}

/// One of scope.xy, world.zy …: where an image's axes run.
struct ImageAxes {
  Vec3 origin{0, 0, 0}, u{1, 0, 0}, v{0, 1, 0};
  double width_m = 0, height_m = 0;  ///< of the scope along them; 0 in the world
};

ImageAxes AxesFrom(const Item& item, std::string_view word) {
  const int u = word[6] - 'x', v = word[7] - 'x';
  if (word.starts_with("world")) {
    ImageAxes axes;
    axes.u = axes.v = Vec3(0, 0, 0);
    axes.u[u] = axes.v[v] = 1;
    return axes;
  }
  // Of what lies, y and z both name the second axis in its plane: the image lies there, too.
  const bool in_plane = item.type == ItemType::kPlanar && u != 2 && v != 2;
  const Scope named = in_plane ? item.scope : NamedScope(item);
  return {named.origin, named.axis(u), named.axis(v), named.size[u], named.size[v]};
}

/// One over an image's size along an axis of this length; floating sizes fit it a whole number of
/// times.
Result<double> RateOf(const Size& size, double length_m) {
  double metres = Metres(size, length_m);
  if (size.kind == Size::Kind::kFloating && length_m > 0 && size.value != 0) {
    metres = length_m / std::max(1.0, std::round(length_m / size.value));
  }
  if (std::abs(metres) > kLengthTolerance_m) return 1 / metres;
  return Fail(ErrorCode::kBadNumber, "setupProjection: an image without size",
              "give its width and height in metres, or '1 to fill the scope");
}

Products ApplySetup(const Item& item, const Action& action) {
  const ImageAxes axes = AxesFrom(item, std::get<std::string>(action.arguments[1]));
  const auto u = RateOf(std::get<Size>(action.arguments[2]), axes.width_m);
  const auto v = RateOf(std::get<Size>(action.arguments[3]), axes.height_m);
  if (!u) return Fail(u);
  if (!v) return Fail(v);
  if (std::get<double>(action.arguments[0]) != 0) return std::vector<Product>{{item, -1}};
  const Vec2 offset(std::get<double>(action.arguments[4]), std::get<double>(action.arguments[5]));
  TextureMap map;
  map.u = axes.u * *u;
  map.v = axes.v * *v;
  map.offset =
      offset * Vec2(*u, *v) - Vec2(glm::dot(map.u, axes.origin), glm::dot(map.v, axes.origin));
  Paint paint = PaintOf(item);
  paint.projection = map;
  return Painted(item, std::move(paint));
}

Products ApplyProject(const Item& item, const Action& action) {
  Paint paint = PaintOf(item);
  if (std::get<double>(action.arguments[0]) != 0) return std::vector<Product>{{item, -1}};
  if (!paint.projection) {
    return Fail(ErrorCode::kBadArguments, "projectUV: no projection was set up for this shape",
                "setupProjection(0, scope.xy, 1, 1) before it");
  }
  paint.map = paint.projection;
  return Painted(item, std::move(paint));
}

constexpr std::array<std::string_view, 12> kImageAxes = {
    "scope.xy", "scope.xz", "scope.yx", "scope.yz", "scope.zx", "scope.zy",
    "world.xy", "world.xz", "world.yx", "world.yz", "world.zx", "world.zy"};

Parameter ImageSize(std::string_view name) {
  return {
      .name = name,
      .kind = ParameterKind::kSize,
      .low = -1e6,
      .high = 1e6,
      .default_value = Size{Size::Kind::kAbsolute, 1},
      .doc =
          "of the image, in metres, as a part of the scope, or ~2 for about 2 m, a whole number "
          "of times; less than 0 mirrors it",
      .words = kFloatingToo};
}

Parameter Shift(std::string_view name) {
  return {.name = name,
          .kind = ParameterKind::kLength,
          .low = -1e6,
          .high = 1e6,
          .default_value = 0.0,
          .required = false,
          .doc = "by which the image is shifted"};
}

const std::array<Parameter, 1> kTextureParameters = {{{
    .name = "file",
    .kind = ParameterKind::kText,
    .default_value = std::string("bricks.png"),
    .doc = "a .png or .jpg beside the rules, or in a folder above; \"\" changes nothing",
}}};

const std::array<Parameter, 6> kSetupParameters = {UvSetParameter(),
                                                   {.name = "axes",
                                                    .kind = ParameterKind::kWord,
                                                    .default_value = std::string("scope.xy"),
                                                    .doc = "along which the image runs",
                                                    .words = kImageAxes},
                                                   ImageSize("texWidth"),
                                                   ImageSize("texHeight"),
                                                   Shift("widthOffset"),
                                                   Shift("heightOffset")};

const std::array<Parameter, 1> kProjectParameters = {UvSetParameter()};

}  // namespace

constinit const Operation kTexture = {
    .name = "texture",
    .word = "Texture",
    .doc =
        "Gives a shape, and what is made from it, an image to wear: once over a planar shape, "
        "unless projectUV says otherwise.",
    .source = "CGA",
    .parameters = kTextureParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .file = 0,
    .apply = ApplyTexture,
};

constinit const Operation kSetupProjection = {
    .name = "setupProjection",
    .word = "SetupProjection",
    .doc = "Says how an image will lie on a shape and on what is made from it: see projectUV.",
    .source = "CGA",
    .parameters = kSetupParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .apply = ApplySetup,
};

constinit const Operation kProjectUv = {
    .name = "projectUV",
    .word = "ProjectUV",
    .doc = "Lays the image as setupProjection said, wherever the shape now is.",
    .source = "CGA",
    .parameters = kProjectParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .apply = ApplyProject,
};

}  // namespace parti::grammar
