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

/// Things by the names of their groups, which stand in the order of their first things.
template <typename Thing>
class Groups {
 public:
  void Add(const std::string& symbol, const Thing& thing) {
    all_[NumberOf(symbol)].push_back(thing);
  }
  bool Has(const std::string& symbol) const { return numbers_.contains(GroupNameOf(symbol)); }
  const std::vector<std::vector<Thing>>& all() const { return all_; }

 private:
  size_t NumberOf(const std::string& symbol) {
    const auto [it, is_new] = numbers_.emplace(GroupNameOf(symbol), all_.size());
    if (is_new) all_.emplace_back();
    return it->second;
  }

  std::unordered_map<std::string, size_t> numbers_;
  std::vector<std::vector<Thing>> all_;
};

struct LeafRef {
  const grammar::ShapeTree* tree;
  grammar::ShapeIndex leaf;
};

/// Of the leaves that have parts, as far as groups are ordered by them.
Groups<LeafRef> GroupsOf(const std::vector<const grammar::ShapeTree*>& trees) {
  Groups<LeafRef> groups;
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) {
      const std::string symbol(tree->Name((*tree)[i].symbol));
      const bool counts = groups.Has(symbol) || !grammar::SurfaceOf((*tree)[i].item).empty();
      if (counts) groups.Add(symbol, {tree, i});
    }
  }
  return groups;
}

}  // namespace

ModelParts PartsOf(std::vector<const grammar::ShapeTree*> trees) {
  ModelParts parts;
  for (const grammar::ShapeTree* tree : trees) {
    for (const grammar::ShapeIndex i : tree->Leaves()) {
      parts.most_triangles += MostTriangles((*tree)[i].item);
    }
  }
  parts.visit_groups = [trees](const PartSink& sink) {
    const Groups<LeafRef> groups = GroupsOf(trees);
    for (const std::vector<LeafRef>& group : groups.all()) {
      for (const LeafRef& one : group) {
        if (!VisitLeaf(*one.tree, one.leaf, sink)) return;
      }
    }
  };
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
  parts.visit_groups = [&mesh](const PartSink& sink) {
    Groups<const ModelPart*> groups;
    for (const ModelPart& part : mesh.parts) groups.Add(part.symbol, &part);
    for (const std::vector<const ModelPart*>& group : groups.all()) {
      for (const ModelPart* part : group) {
        if (!sink(*part)) return;
      }
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

}  // namespace parti::app
