#include "app/model_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/utf8.h"
#include "grammar/item_surface.h"

namespace parti::app {
namespace {

/// Points by their cells of a grid; a point's neighbours lie in its cell or the ones beside it.
class PointGrid {
 public:
  /// The number of the first point within kWeld_m, which `p` becomes where there is none.
  uint32_t IndexOf(const Vec3& p, std::vector<Vec3>* points) {
    const Cell home = CellOf(p);
    for (int i = 0; i < 27; ++i) {
      const Cell cell = {home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1};
      const auto [first, last] = cells_.equal_range(HashOf(cell));
      for (auto it = first; it != last; ++it) {
        if (glm::length((*points)[it->second] - p) <= kWeld_m) return it->second;
      }
    }
    const auto index = static_cast<uint32_t>(points->size());
    points->push_back(p);
    cells_.emplace(HashOf(home), index);
    return index;
  }

 private:
  using Cell = std::array<int64_t, 3>;
  static Cell CellOf(const Vec3& p) {
    const auto part = [](double v) { return static_cast<int64_t>(std::floor(v / kWeld_m)); };
    return {part(p.x), part(p.y), part(p.z)};
  }
  static uint64_t HashOf(const Cell& cell) {
    uint64_t hash = 0;
    for (const int64_t part : cell) {
      hash = (hash ^ static_cast<uint64_t>(part)) * 0x9e3779b97f4a7c15ull;
      hash ^= hash >> 29;
    }
    return hash;
  }
  std::unordered_multimap<uint64_t, uint32_t> cells_;
};

/// Beyond this, 10 micrometres are less than a double's last digits. [m]
constexpr double kFarthest_m = 1e9;

bool IsWeldable(const Vec3& p) {
  return std::abs(p.x) < kFarthest_m && std::abs(p.y) < kFarthest_m && std::abs(p.z) < kFarthest_m;
}

std::string NameFrom(const std::string& symbol) {
  if (symbol.empty()) return "Unnamed";
  if (IsUtf8(symbol)) return symbol;
  std::string name = symbol;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c & 0x80) != 0; }, '_');
  return name;
}

}  // namespace

ModelMesh ModelMeshFrom(std::span<const grammar::ShapeTree* const> trees) {
  ModelMesh mesh;
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) {
      const grammar::Shape& shape = (*tree)[i];
      const bool closed = grammar::IsClosedBody(shape.item);
      for (grammar::SurfacePart& surface : grammar::SurfaceOf(shape.item)) {
        mesh.parts.push_back({std::string(tree->Name(shape.symbol)), surface.color_rgb, closed,
                              std::move(surface.corners), std::move(surface.uvs),
                              std::move(surface.material)});
      }
    }
  }
  return mesh;
}

ModelMesh ModelMeshFrom(const grammar::ShapeTree& tree) {
  const grammar::ShapeTree* const trees[] = {&tree};
  return ModelMeshFrom(trees);
}

WeldedPart Weld(const std::vector<Vec3>& corners) {
  WeldedPart part;
  PointGrid grid;
  for (size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vec3* p = &corners[i];
    if (!IsWeldable(p[0]) || !IsWeldable(p[1]) || !IsWeldable(p[2])) continue;
    std::array<uint32_t, 3> at{};
    for (int k = 0; k < 3; ++k) at[k] = grid.IndexOf(p[k], &part.points);
    const auto& q = part.points;
    const Vec3 normal = glm::cross(q[at[1]] - q[at[0]], q[at[2]] - q[at[0]]);
    const double length = glm::length(normal);
    if (!(length > 0)) continue;
    part.triangles.insert(part.triangles.end(), at.begin(), at.end());
    part.normals.push_back(normal / length);
    part.sources.push_back(static_cast<uint32_t>(i / 3));
  }
  return part;
}

std::vector<SymbolGroup> GroupBySymbol(const ModelMesh& mesh) {
  std::vector<SymbolGroup> groups;
  std::unordered_map<std::string, size_t> found;
  for (size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::string name = NameFrom(mesh.parts[i].symbol);
    const auto [it, is_new] = found.emplace(name, groups.size());
    if (is_new) groups.push_back({name, {}});
    groups[it->second].parts.push_back(i);
  }
  return groups;
}

}  // namespace parti::app
