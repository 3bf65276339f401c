// A model as exporters take it: the visible shapes as triangles, without any grammar.
// Formats are the exporters'; pictures take a render::Scene instead.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/math.h"
#include "grammar/shape_tree.h"

namespace parti::app {

/// What is alike of one visible shape: mostly all of it, of assets the faces of one material.
struct ModelPart {
  std::string symbol;      ///< "" where it has none
  uint32_t color_rgb = 0;  ///< 0xRRGGBB; 0: none given
  bool closed = false;     ///< of a watertight body; else seen from both sides
  std::vector<Vec3>
      corners;  ///< triangles, three by three, counter-clockwise from outside; m, y up
  std::vector<Vec2> uvs = {};  ///< one a corner, (0, 0) the image's lower left; none: not textured
  std::shared_ptr<const grammar::Material> material = nullptr;  ///< null: plain
};

/// Parts in the depth-first order of their trees.
struct ModelMesh {
  std::vector<ModelPart> parts;
};

/// What is given parts one by one; false: it has had enough.
using PartSink = std::function<bool(const ModelPart&)>;

/// A model whose parts are made when they are asked for, one after the other: of a large model all
/// of them need many times the memory of the file.
struct ModelParts {
  std::function<void(const PartSink&)> visit;  ///< the same parts each time
  /// The same parts, those of one group (GroupNameOf) after the other; groups in the order of their
  /// first parts. Between groups the sink is not told.
  std::function<void(const PartSink&)> visit_groups;
  size_t most_triangles = 0;  ///< there are no more; counted without making them
};

/// The leaves of the trees of all lots, in the order of ModelMeshFrom. The trees must outlive it.
ModelParts PartsOf(std::vector<const grammar::ShapeTree*> trees);
ModelParts PartsOf(const ModelMesh& mesh);  ///< the mesh must outlive it

/// Of ModelMeshFrom, without making it; a rectangle is two without being looked at.
size_t TriangleCount(std::span<const grammar::ShapeTree* const> trees);

/// The leaves of the trees of all lots.
ModelMesh ModelMeshFrom(std::span<const grammar::ShapeTree* const> trees);
ModelMesh ModelMeshFrom(const grammar::ShapeTree& tree);

/// What files call the shapes of a symbol: "Unnamed" for "", and _ for each byte of what is not
/// UTF-8.
std::string GroupNameOf(const std::string& symbol);

}  // namespace parti::app
