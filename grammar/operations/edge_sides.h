// Which side of a planar shape its edges are on: what setback and the shapes L, U, O select by.
// The front itself is front_edge.h's.
#pragma once

#include <optional>
#include <vector>

#include "grammar/front_edge.h"
#include "grammar/operations/rows.h"
#include "grammar/polygon_setback.h"

namespace parti::grammar {

/// One edge of the outline or of a hole, as selectors see it.
struct EdgeSide {
  /// On shapes that lie: as seen from the street. On upright ones, where front and back are none:
  /// left and right of the scope.
  std::optional<StreetSide> side;
  bool top = false, bottom = false;  ///< of upright shapes
};

/// Ring by ring, the outline first. Shapes lie when their normal rises or falls by 45 degrees.
std::vector<EdgeSide> SidesOf(const Item& planar);

/// Whether the selector takes edge number `index`.
bool Selects(const Selector& selector, const EdgeSide& edge, size_t index);

/// Products of a division: strip k goes to successor successors[k], the remainder to `remainder`;
/// -1: nowhere.
std::vector<Product> ProductsOf(const Item& planar, SetbackParts parts,
                                const std::vector<int>& successors, int remainder);

/// shapeL, shapeU and shapeO: each side's edges set back by its distance, all in one shape.
struct SideDistances {
  double front = 0, right = 0, back = 0, left = 0;
};
/// The row's apply, once it knows its distances; its successors are `shape` and `remainder`.
Result<std::vector<Product>> ShapeOf(const Item& planar, const Action& action,
                                     const SideDistances& distances);

/// A width of a wing, 0 to 10 km.
Parameter WingParameter(std::string_view name, std::string_view doc);

}  // namespace parti::grammar
