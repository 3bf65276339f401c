// Footprints as files hold them: rings in metres east and north.
// No shapes yet and no local origin: that is lot.h's.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/lot_property.h"
#include "base/json.h"

namespace parti::app {

/// One outline on the ground, with its courtyards.
struct Footprint {
  std::string name;
  std::vector<std::vector<Vec2>> rings;  ///< (east, north), m; the outline first, then holes
  double height_m = 0;                   ///< of the ground; 0 where the file does not say
  std::optional<double> street_deg;      ///< where its street lies, clockwise from north; degrees
  LotProperties properties = {};         ///< all that the file says of it, by name
};

/// The footprints of a text, by what it looks like:
///   JSON lines of {"id", "rings": [[[east, north], …], …]};
///   GeoJSON: Polygon, MultiPolygon, Feature and collections of them, in metres;
///   CityJSON: the ground of every building and the surfaces of land use;
///   lines of these: GeoJSON text sequences (RFC 8142) and CityJSONSeq.
/// `file` is for error messages. Where `refused` is not null, a lot whose coordinates or street
/// can't be read does not cost the others: what is wrong with it is put there.
/// errors  kBadText, kBadNumber  with the place or the name;  kNothingMade  no footprint in it.
Result<std::vector<Footprint>> FootprintsFrom(std::string_view text, std::string_view file,
                                              std::vector<Error>* refused = nullptr);

/// [[east, north], …] with further coordinates ignored; `what` names it in messages.
Result<std::vector<Vec2>> RingFrom(const Json& ring, std::string_view what);

/// A lot's outline and holes; `lot` names it in messages.
Result<std::vector<std::vector<Vec2>>> RingsFrom(const Json& rings, std::string_view lot);

/// "street_deg" among the properties of a lot, where it is there and not null; `lot` names it.
/// errors  kBadText  no number;  kBadNumber  none from -360 to 360.
Result<std::optional<double>> StreetIn(const Json& properties, std::string_view lot);

/// Footprints that are read, one by one.
class FootprintList {
 public:
  /// `refused` may be null: then a lot that can't be read is the error.
  explicit FootprintList(std::vector<Error>* refused) : refused_(refused) {}

  /// Takes a lot in, or what is wrong with it. errors  that, where nobody takes it.
  Result<void> Add(Result<Footprint> lot) {
    if (lot) {
      all_.push_back(std::move(*lot));
    } else if (refused_ != nullptr) {
      refused_->push_back(std::move(lot.error()));
    } else {
      return Fail(lot);
    }
    return {};
  }

  const std::vector<Footprint>& all() const { return all_; }
  /// How many lots there were, good and bad.
  size_t met() const { return all_.size() + (refused_ != nullptr ? refused_->size() : 0); }
  std::vector<Footprint> Take() && { return std::move(all_); }

 private:
  std::vector<Footprint> all_;
  std::vector<Error>* refused_;
};

/// Whether a value of this type ("Feature") is GeoJSON that may hold lots.
bool IsGeoJson(std::string_view type);

/// The lots of a value of such a type are appended. Points, lines and empty polygons are no lots.
/// errors  kBadText  not what RFC 7946 says;  kBadNumber;  kLimitReached  nested too deep.
Result<void> AddGeoJson(const Json& json, FootprintList* footprints);

/// The same of a CityJSON object or of a CityJSONFeature, whose vertices the `transform` of its
/// sequence places; null: none. errors  kBadText  not what CityJSON 1.x and 2.0 say;  kBadNumber.
Result<void> AddCityJson(const Json& city, const Json& transform, FootprintList* footprints);

}  // namespace parti::app
