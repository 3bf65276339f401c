// What a file brings in: a body to insert, or an image to wear (CGA's i and texture).
// Formats are read here from bytes; where bytes come from is the library's (asset_library.h).
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "base/error.h"
#include "grammar/mesh.h"

namespace parti::grammar {

/// Immutable and shared by everything that was made of it. Either a mesh or an image.
struct Asset {
  Vec3 low{0, 0, 0};   ///< minimum corner of its bounds in its own coordinates; m, y up
  Vec3 size{0, 0, 0};  ///< of its bounds; at least two above 0
  std::shared_ptr<const Mesh> mesh;  ///< with its bounds stretched to [0, 1]; flat along sizes of 0
  std::shared_ptr<const Image> image;
};

/// The bytes of a file that an asset refers to, by the name that it uses.
/// errors  kFile  naming the file.
using FileReader = std::function<Result<std::string>(const std::string& name)>;

/// Larger files are refused: an asset is inserted thousands of times.
inline constexpr size_t kMostAssetFaces = 2'000'000;

/// Any of them by the ending of `name`: .obj, .gltf, .glb, .png, .jpg, .jpeg.
/// errors  kUnknownName  another ending;  those of the format.
Result<Asset> AssetFrom(std::string_view bytes, std::string_view name, const FileReader& files);

/// Wavefront OBJ with its material files: v, vt, f (also negative numbers), usemtl, mtllib; newmtl,
/// Kd, d, Tr, map_Kd. Polygons that are flat stay whole, others become triangles. A material file
/// or image that is missing is an error, too.
/// errors  kDamagedFile  a number that is none, an index of nothing, no face (the place says
/// where);
///         kLimitReached; those of `files`.
Result<Asset> AssetFromObj(std::string_view text, std::string_view name, const FileReader& files);

/// glTF 2.0, text or binary: the triangles of its default scene with all transforms, base colours,
/// base colour images and their first texture coordinates.
/// errors  kDamagedFile  not glTF, cut short, or an accessor outside its buffer;  kLimitReached;
///         those of `files`.
Result<Asset> AssetFromGltf(std::string_view bytes, std::string_view name, const FileReader& files);

/// PNG or JPEG, by signature and end; pixels are not looked at.
/// errors  kDamagedFile  neither, or cut short.
Result<Image> ImageFrom(std::string_view bytes, std::string_view name);

}  // namespace parti::grammar
