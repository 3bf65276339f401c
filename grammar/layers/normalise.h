// Planar shape normalisation: the 2D shapes of a scene become planar shapes that don't overlap
// (Jesus 2018, 4.3; errata 2, 3, 5, 6, 9a). Which shapes are no placeholders, and when a scene is
// normalised, is the driver's to know; the geometry is scene_geometry.h's.
#pragma once

#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

/// A part of a scene that nothing covers, in the scope coordinates of its planar shape.
struct Uncovered {
  ShapeIndex planar = kNoShape;
  Polygon polygon;
};

/// What a scene came to.
struct NormalisedScene {
  /// The planar shapes that each of the given shapes became, in their order; none: discarded.
  std::vector<std::vector<ShapeIndex>> pieces;
  /// What nothing covers, holes kept as holes: what deferred shapes take, and then the background.
  std::vector<Uncovered> uncovered;
};

/// Merges the layers of the scene of the planar shape `planar` and makes planar shapes of `shapes`.
///
/// shapes   the 2D shapes of the scene that are no placeholders and not deferred, in depth-first
///          order of the tree, each once. A shape that lies in the tree below other 2D shapes of
///          the scene is clipped to all of them, and to the planar shape; so what `vectorial` makes
///          has to stand in the tree before anything is made from it.
/// effect   A shape that stays as it was laid out, or of which one piece is left, becomes planar in
///          place: index, symbol and tags stay. Of several pieces the first is in place, the others
///          are appended to the shape's parent with its symbol and tags. A shape with fixed
///          geometry that is covered by area, and one that is covered as a whole, stays a 2D shape,
///          and is never visible. Nothing is appended for what is not covered: see
///          AppendBackground.
///          Order: a later layer lies over an earlier one; in a layer a smaller depth lies over a
///          larger one; of equals the later of `shapes` lies over the earlier.
/// pieces   have the axes of the planar shape, the origin in the lower left corner of their
///          bounding rectangle and its size (errata 3); color of their shape; neither layer nor
///          depth. Rectangles that nothing covers keep their very numbers.
/// areas    below 1e-9 of the scene's, and pieces narrower than SceneTolerance, are none
///          (errata 5).
/// errors   kDegenerateGeometry  a polygon that is not simple.
/// cost     O(n log n) and the pairs of shapes that overlap.
Result<NormalisedScene> Normalise(ShapeTree* tree, ShapeIndex planar,
                                  std::span<const ShapeIndex> shapes);

/// Gives a deferred layer or 2D shape what nothing covers: one planar shape per connected piece
/// inside its geometry and its 2D ancestors' (a layer's is the whole scene), in place and appended
/// like Normalise's pieces. `*uncovered` is what the shape's own scene left and what the scenes of
/// earlier deferred shapes in it left (errata 9a); what is taken is removed from it.
/// returns  the pieces; none where everything is covered: the shape stays as it is, invisible.
/// errors   kDegenerateGeometry  a polygon that is not simple.
Result<std::vector<ShapeIndex>> PlaceDeferred(ShapeTree* tree, ShapeIndex deferred,
                                              std::vector<Uncovered>* uncovered);

/// Appends what is left as last children of the planar shapes it belongs to: planar, terminal,
/// without symbol, tagged "background". To be called once, when no deferred shape is left.
void AppendBackground(ShapeTree* tree, std::span<const Uncovered> uncovered);

}  // namespace parti::grammar
