// Edges of items with the faces that meet there.
// What pictures draw of them is EdgesOf (item.h); comp(e) makes items of them.
#pragma once

#include <vector>

#include "grammar/item.h"

namespace parti::grammar {

/// One edge of a body or of a planar shape, in the world.
struct ItemEdge {
  Vec3 a, b;            ///< as the loop of `face` runs
  Vec3 normal;          ///< unit, of the face that it was met in first
  Vec3 other{0, 0, 0};  ///< unit, of the other face; 0 on the border of what is open
  int faces = 1;        ///< that meet there: 1 on a border, usually 2
};

/// Each edge once, in the order in which the faces' loops (outline, then holes) meet them first;
/// edges without length left out. cost  n log n for meshes.
std::vector<ItemEdge> ItemEdgesOf(const Item& item);

/// Out of the face along its edge: unit, in the face's plane, at right angles to the edge.
Vec3 OutwardOf(const ItemEdge& edge);

/// A corner of a body, with the mean of the normals of its faces; of a planar shape, with that of
/// the outward directions of its two edges. Unit; 0 where they cancel.
struct ItemCorner {
  Vec3 point;
  Vec3 normal{0, 0, 0};
  bool on_border = false;  ///< of what is open, or of a planar shape
};
/// Each corner once, in the order in which the faces' loops meet them first.
std::vector<ItemCorner> ItemCornersOf(const Item& item);

}  // namespace parti::grammar
