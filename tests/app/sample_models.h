// Models for the exporters' and pictures' tests, made by the grammar's own operations.
// What the operations do is tested with the grammar.
#pragma once

#include "app/model_mesh.h"
#include "grammar/shape_tree.h"

namespace parti::app::tests {

/// A lot that is left as it is, and on it: a body over an L with a courtyard, turned by 30 degrees
/// (awkward numbers), with a colour; two boxes of one symbol that touch; a planar sign.
grammar::ShapeTree Courtyard();

/// A town house derived from a selection-action tree: ground floor, floors with windows, a terrace
/// and a set-back top storey.
grammar::ShapeTree TownHouse();

/// The enclosed volume; positive where the triangles look outward.
double SignedVolume(const std::vector<Vec3>& corners);

/// Every edge of every triangle is met by exactly one the other way round.
bool IsClosed(const std::vector<Vec3>& points, const std::vector<uint32_t>& triangles);

}  // namespace parti::app::tests
