#include "app/model_mesh.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "base/utf8.h"
#include "grammar/item_surface.h"

namespace parti::app {
namespace {

/// Of a loop with holes: each corner is one triangle, each hole two more.
size_t MostTriangles(size_t corners, size_t holes) {
  return corners < 3 ? 0 : corners + 2 * holes - 2;
}

bool IsRectangle(const grammar::Item& item) { return grammar::IsFlat(item.type) && !item.polygon; }

size_t MostTriangles(const grammar::Item& item) {
  constexpr size_t kOfABox = 12;
  if (!item.mesh && !item.polygon) return kOfABox;
  size_t triangles = 0;
  if (item.polygon) {
    size_t corners = item.polygon->outer.size();
    for (const grammar::Ring& hole : item.polygon->holes) corners += hole.size();
    triangles += MostTriangles(corners, item.polygon->holes.size());
  }
  if (!item.mesh) return triangles;
  for (const grammar::MeshFace& face : item.mesh->faces) {
    size_t corners = face.loop.size();
    for (const auto& hole : face.holes) corners += hole.size();
    triangles += MostTriangles(corners, face.holes.size());
  }
  return triangles;
}

/// False where `take`, which is given a ModelPart of its own, has had enough.
template <typename Take>
bool VisitLeaf(const grammar::ShapeTree& tree, grammar::ShapeIndex leaf, const Take& take) {
  const grammar::Shape& shape = tree[leaf];
  const bool closed = grammar::IsClosedBody(shape.item);
  for (grammar::SurfacePart& surface : grammar::SurfaceOf(shape.item)) {
    ModelPart part{
        std::string(tree.Name(shape.symbol)), surface.color_rgb,      closed,
        std::move(surface.corners),           std::move(surface.uvs), std::move(surface.material)};
    if (!take(std::move(part))) return false;
  }
  return true;
}

}  // namespace

ModelParts PartsOf(std::vector<const grammar::ShapeTree*> trees) {
  ModelParts parts;
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) {
      parts.most_triangles += MostTriangles((*tree)[i].item);
    }
  }
  parts.visit = [trees = std::move(trees)](const PartSink& sink) {
    for (const grammar::ShapeTree* tree : trees) {
      for (const grammar::ShapeIndex i : tree->Leaves()) {
        if (!VisitLeaf(*tree, i, sink)) return;
      }
    }
  };
  return parts;
}

ModelParts PartsOf(const ModelMesh& mesh) {
  ModelParts parts;
  for (const ModelPart& part : mesh.parts) parts.most_triangles += part.corners.size() / 3;
  parts.visit = [&mesh](const PartSink& sink) {
    for (const ModelPart& part : mesh.parts) {
      if (!sink(part)) return;
    }
  };
  return parts;
}

size_t TriangleCount(std::span<const grammar::ShapeTree* const> trees) {
  size_t triangles = 0;
  const auto add = [&triangles](const ModelPart& part) {
    triangles += part.corners.size() / 3;
    return true;
  };
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) {
      if (IsRectangle((*tree)[i].item)) {
        triangles += 2;
      } else {
        VisitLeaf(*tree, i, add);
      }
    }
  }
  return triangles;
}

ModelMesh ModelMeshFrom(std::span<const grammar::ShapeTree* const> trees) {
  ModelMesh mesh;
  const auto take = [&mesh](ModelPart&& part) {
    mesh.parts.push_back(std::move(part));
    return true;
  };
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) VisitLeaf(*tree, i, take);
  }
  return mesh;
}

ModelMesh ModelMeshFrom(const grammar::ShapeTree& tree) {
  const grammar::ShapeTree* const trees[] = {&tree};
  return ModelMeshFrom(trees);
}

std::string GroupNameOf(const std::string& symbol) {
  if (symbol.empty()) return "Unnamed";
  if (IsUtf8(symbol)) return symbol;
  std::string name = symbol;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c & 0x80) != 0; }, '_');
  return name;
}

std::vector<SymbolGroup> GroupBySymbol(const ModelMesh& mesh) {
  std::vector<SymbolGroup> groups;
  std::unordered_map<std::string, size_t> found;
  for (size_t i = 0; i < mesh.parts.size(); ++i) {
    const std::string name = GroupNameOf(mesh.parts[i].symbol);
    const auto [it, is_new] = found.emplace(name, groups.size());
    if (is_new) groups.push_back({name, {}});
    groups[it->second].parts.push_back(i);
  }
  return groups;
}

}  // namespace parti::app
