// The polygons of GeoJSON (RFC 7946) as footprints. That numbers are metres is footprint.cc's to
// see.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/footprint.h"
#include "app/lot_values.h"

namespace parti::app {
namespace {

constexpr int kDeepest = 32;

const Json& At(const Json& object, const char* name) {
  static const Json kNone;
  if (!object.is_object()) return kNone;
  const auto found = object.find(name);
  return found == object.end() ? kNone : *found;
}

/// The text or number under `key`, else the fallback.
std::string NameIn(const Json& object, const char* key, std::string fallback) {
  const Json& id = At(object, key);
  if (id.is_string()) return id.get<std::string>();
  return id.is_number() ? id.dump() : std::move(fallback);
}

/// Adds what a value holds. The name and the street are those of the feature around it.
class Adder {
 public:
  explicit Adder(FootprintList* all) : all_(all) {}

  Result<void> Add(const Json& json, const Footprint& feature, int depth) {
    if (depth > kDeepest) return Fail(ErrorCode::kLimitReached, "GeoJSON nested too deep");
    const Json& type = At(json, "type");
    if (type == "FeatureCollection") return AddEach(json, "features", feature, depth);
    if (type == "GeometryCollection") return AddEach(json, "geometries", feature, depth);
    if (type == "Feature") return AddFeature(json, depth);
    if (type == "Polygon") return AddPolygon(At(json, "coordinates"), feature);
    if (type == "MultiPolygon") return AddPolygons(At(json, "coordinates"), feature);
    return {};
  }

 private:
  Result<void> AddEach(const Json& object, const char* list, const Footprint& feature, int depth) {
    const Json& items = At(object, list);
    if (!items.is_array()) {
      return Fail(ErrorCode::kBadText,
                  fmt::format("{} has no list \"{}\"", NameIn(object, "type", "an object"), list));
    }
    for (const Json& item : items) {
      if (auto added = Add(item, feature, depth + 1); !added) return added;
    }
    return {};
  }

  Result<void> AddFeature(const Json& json, int depth) {
    const Json& properties = At(json, "properties");
    Footprint feature;
    feature.name = NameIn(properties, "id", fmt::format("{}", all_->met()));
    feature.name = NameIn(json, "id", feature.name);
    const auto street = StreetIn(properties, feature.name);
    if (!street) return all_->Add(Fail(street));
    feature.street_deg = *street;
    feature.properties = PropertiesIn(properties);
    return Add(At(json, "geometry"), feature, depth + 1);
  }

  /// An empty list of coordinates is a geometry that is not there (RFC 7946, 3.1).
  Result<void> AddPolygon(const Json& coordinates, const Footprint& feature) {
    if (coordinates.is_array() && coordinates.empty()) return {};
    auto rings = RingsFrom(coordinates, feature.name);
    if (!rings) return all_->Add(Fail(rings));
    Footprint lot = feature;
    lot.rings = std::move(*rings);
    return all_->Add(std::move(lot));
  }

  Result<void> AddPolygons(const Json& coordinates, const Footprint& feature) {
    if (!coordinates.is_array()) {
      return Fail(ErrorCode::kBadText,
                  fmt::format("lot '{}' has no list of polygons", feature.name));
    }
    for (const Json& polygon : coordinates) {
      if (auto added = AddPolygon(polygon, feature); !added) return added;
    }
    return {};
  }

  FootprintList* all_;
};

}  // namespace

bool IsGeoJson(std::string_view type) {
  constexpr std::string_view kKnown[] = {"FeatureCollection", "Feature", "GeometryCollection",
                                         "Polygon", "MultiPolygon"};
  return std::find(std::begin(kKnown), std::end(kKnown), type) != std::end(kKnown);
}

Result<void> AddGeoJson(const Json& json, FootprintList* footprints) {
  Footprint unnamed;
  unnamed.name = "0";
  return Adder(footprints).Add(json, unnamed, 0);
}

}  // namespace parti::app
