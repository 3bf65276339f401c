// A model as exporters take it: the visible shapes as triangles, without any grammar.
// Formats are the exporters'; pictures take a render::Scene instead.
#pragma once

#include <cstdint>
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

/// The leaves of the trees of all lots.
ModelMesh ModelMeshFrom(std::span<const grammar::ShapeTree* const> trees);
ModelMesh ModelMeshFrom(const grammar::ShapeTree& tree);

/// A part with shared corners. Corners nearer than kWeld_m are one: faces of a body that work out a
/// corner by different sums then meet exactly.
struct WeldedPart {
  std::vector<Vec3> points;         ///< in the order in which triangles name them first
  std::vector<uint32_t> triangles;  ///< three indices each; those without area are left out
  std::vector<Vec3> normals;        ///< one a triangle, unit length
  std::vector<uint32_t> sources;    ///< one a triangle: which of the part's it was
};

inline constexpr double kWeld_m = 1e-5;

/// Left out: triangles with corners that are not finite, or without area. Linear.
WeldedPart Weld(const std::vector<Vec3>& corners);

/// Symbols in order of their first part, each with its parts' numbers.
struct SymbolGroup {
  std::string name;  ///< "Unnamed" for shapes without symbol; always UTF-8
  std::vector<size_t> parts;
};
std::vector<SymbolGroup> GroupBySymbol(const ModelMesh& mesh);

}  // namespace parti::app
