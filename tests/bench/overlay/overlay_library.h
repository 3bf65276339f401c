// One face for the 2D libraries that docs/layers.md compares.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "grammar/polygon.h"

namespace parti::bench {

using Polygons = std::vector<grammar::Polygon>;

/// Nothing where the library refuses or throws. Built for one measurement, not for the program.
struct OverlayLibrary {
  std::string_view name;
  std::optional<Polygons> (*intersection)(const grammar::Polygon& a, const grammar::Polygon& b);
  /// `whole` without all of `parts`, which may overlap.
  std::optional<Polygons> (*difference)(const grammar::Polygon& whole, const Polygons& parts);
};

extern const OverlayLibrary kGeos, kGeosOnGrid, kClipper, kBoostPolygon, kCgal;

}  // namespace parti::bench
