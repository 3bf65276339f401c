// What a surface looks like beyond one colour: materials, images, texture coordinates.
// Knows nothing of the geometry that wears it, nor of how pictures draw it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "base/math.h"

namespace parti::grammar {

/// An encoded picture (PNG or JPEG) as its file holds it; never decoded here.
struct Image {
  std::string name;   ///< of its file, without folders: "brick.png"
  std::string bytes;  ///< starts with the format's signature
};

/// CGA's material attributes, as far as exports can keep them. Shared and immutable.
struct Material {
  std::string name;                    ///< as its file calls it; "" none
  uint32_t color_rgb = 0;              ///< 0xRRGGBB, sRGB, multiplies the image; 0: none given
  double opacity = 1;                  ///< 0: clear, 1: opaque
  double metallic = 0;                 ///< 0: not a metal, 1: bare metal
  double roughness = 0.9;              ///< 0: a mirror, 1: chalk
  std::shared_ptr<const Image> image;  ///< CGA's colormap; null: none

  bool operator==(const Material&) const = default;
};

/// Texture coordinates of points: (u·p, v·p) + offset, (0, 0) the image's lower left corner, (1, 1)
/// its upper right; it repeats beyond. Affine, so that it holds for every part of a face, however
/// it is cut: textures need no care when shapes are split.
struct TextureMap {
  Vec3 u{1, 0, 0};  ///< 1/m, or per unit of the mesh
  Vec3 v{0, 1, 0};
  Vec2 offset{0, 0};

  Vec2 At(const Vec3& p) const { return Vec2(glm::dot(u, p), glm::dot(v, p)) + offset; }
  bool operator==(const TextureMap&) const = default;
};

/// What a face or an item wears.
struct Paint {
  std::shared_ptr<const Material> material;  ///< null: plain
  std::optional<TextureMap> map;  ///< an item's takes points of the world, a mesh's its own points
  std::optional<TextureMap> projection;  ///< items: set up, and used from projectUV on (CGA)

  bool operator==(const Paint&) const = default;
};

/// The same map for points that moved: At(p) of the result is At(back(p)) of `map`, where
/// back(p) = (dot(p - origin, x), dot(p - origin, y), dot(p - origin, z)) in an orthonormal frame.
TextureMap InFrame(const TextureMap& map, const Vec3& origin, const Vec3& x, const Vec3& y,
                   const Vec3& z);
/// The way back: At(p) of the result, p in that frame, is At of the point in the world.
TextureMap LocalIn(const TextureMap& map, const Vec3& origin, const Vec3& x, const Vec3& y,
                   const Vec3& z);
/// The same map for points that were mirrored in [0, size] along the axes that are true.
TextureMap Mirrored(const TextureMap& map, const Vec3& size, const bool (&flip)[3]);
/// The map of a triangle's plane that gives its corners these coordinates; nothing where it has no
/// area.
std::optional<TextureMap> MapThrough(const Vec3 (&corners)[3], const Vec2 (&uvs)[3]);
/// The same map for points that were moved by -low and then multiplied by scale (its parts not 0;
/// where one is, the map loses what it said along that axis).
TextureMap Rescaled(const TextureMap& map, const Vec3& low, const Vec3& scale);

}  // namespace parti::grammar
