// From the corners and triangles of a file to a unit mesh: welded, cleaned, its paints attached.
// Shared by the formats; knows none of them.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/asset.h"

namespace parti::grammar {

/// Collects the faces of an asset.
class AssetMesh {
 public:
  /// A corner of a face: where it is, and where it is in the image.
  struct Corner {
    Vec3 point;
    Vec2 uv{0, 0};
  };

  /// A polygon without holes, counter-clockwise seen from outside, with its material (null: none)
  /// and, where `has_uv`, texture coordinates. One that is not flat, or whose coordinates are not
  /// those of one map, becomes triangles (a fan, where it isn't simple either); what has no area is
  /// dropped.
  void Add(const std::vector<Corner>& face, const std::shared_ptr<const Material>& material,
           bool has_uv);

  size_t faces() const { return mesh_.faces.size(); }

  /// errors  kDamagedFile  nothing with an area;  kBadNumber  a coordinate that is not finite, or
  ///         beyond kLargestCoordinate_m.
  Result<Asset> Finish(std::string_view name);

 private:
  void AddFace(std::span<const Corner> face, const std::shared_ptr<const Material>& material,
               bool has_uv);
  uint32_t PaintNumber(const Paint& paint);

  Mesh mesh_;
};

}  // namespace parti::grammar
