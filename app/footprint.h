// Footprints as files hold them: rings in metres east and north.
// No shapes yet and no local origin: that is lot.h's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/json.h"

namespace parti::app {

/// One outline on the ground, with its courtyards.
struct Footprint {
  std::string name;
  std::vector<std::vector<Vec2>> rings;  ///< (east, north), m; the outline first, then holes
  double height_m = 0;                   ///< of the ground; 0 where the file does not say
};

/// The footprints of a text, by what it looks like:
///   JSON lines of {"id", "rings": [[[east, north], …], …]};
///   GeoJSON: Polygon, MultiPolygon, Feature and collections of them, in metres;
///   CityJSON: the ground of every building and the surfaces of land use.
/// `file` is for error messages.
/// errors  kBadText, kBadNumber  with the place or the name;  kNothingMade  no footprint in it.
Result<std::vector<Footprint>> FootprintsFrom(std::string_view text, std::string_view file);

/// [[east, north], …] with further coordinates ignored; `what` names it in messages.
Result<std::vector<Vec2>> RingFrom(const Json& ring, std::string_view what);

/// errors  kBadText  not what CityJSON 1.x and 2.0 say;  kBadNumber.
Result<std::vector<Footprint>> CityJsonFootprints(const Json& city);

}  // namespace parti::app
