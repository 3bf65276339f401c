// Footprints as files hold them: rings in metres east and north.
// No shapes yet and no local origin: that is lot.h's.
#pragma once

#include <optional>
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
  std::optional<double> street_deg;      ///< where its street lies, clockwise from north; degrees
};

/// The footprints of a text, by what it looks like:
///   JSON lines of {"id", "rings": [[[east, north], …], …]};
///   GeoJSON: Polygon, MultiPolygon, Feature and collections of them, in metres;
///   CityJSON: the ground of every building and the surfaces of land use;
///   lines of these: GeoJSON text sequences (RFC 8142) and CityJSONSeq.
/// `file` is for error messages.
/// errors  kBadText, kBadNumber  with the place or the name;  kNothingMade  no footprint in it.
Result<std::vector<Footprint>> FootprintsFrom(std::string_view text, std::string_view file);

/// [[east, north], …] with further coordinates ignored; `what` names it in messages.
Result<std::vector<Vec2>> RingFrom(const Json& ring, std::string_view what);

/// A lot's outline and holes; `lot` names it in messages.
Result<std::vector<std::vector<Vec2>>> RingsFrom(const Json& rings, std::string_view lot);

/// "street_deg" among the properties of a lot, where it is there and not null; `lot` names it.
/// errors  kBadText  no number;  kBadNumber  none from -360 to 360.
Result<std::optional<double>> StreetIn(const Json& properties, std::string_view lot);

/// Whether a value of this type ("Feature") is GeoJSON that may hold lots.
bool IsGeoJson(std::string_view type);

/// The lots of a value of such a type are appended. Points, lines and empty polygons are no lots.
/// errors  kBadText  not what RFC 7946 says;  kBadNumber;  kLimitReached  nested too deep.
Result<void> AddGeoJson(const Json& json, std::vector<Footprint>* footprints);

/// Of a CityJSON object or of a CityJSONFeature, whose vertices the `transform` of its sequence
/// places; null: none.
/// errors  kBadText  not what CityJSON 1.x and 2.0 say;  kBadNumber.
Result<std::vector<Footprint>> CityJsonFootprints(const Json& city, const Json& transform);

}  // namespace parti::app
