#include "app/footprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace parti::app {
namespace {

using Footprints = std::vector<Footprint>;

/// A file all of whose coordinates could be degrees, and that is smaller than this, is in degrees:
/// no lot is half a metre wide.
constexpr double kSmallestExtent_m = 0.5;
constexpr int kDeepestGeoJson = 32;

const Json* Member(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::string TypeOf(const Json& object) {
  const Json* type = Member(object, "type");
  return type != nullptr && type->is_string() ? type->get<std::string>() : "";
}

/// The text or number under `key`, else the fallback.
std::string NameIn(const Json& object, const char* key, std::string fallback) {
  const Json* id = Member(object, key);
  if (id == nullptr) return fallback;
  if (id->is_string()) return id->get<std::string>();
  return id->is_number() ? id->dump() : fallback;
}

Result<Footprint> FootprintFrom(const Json& rings, std::string name) {
  if (!rings.is_array() || rings.empty()) {
    return Fail(ErrorCode::kBadText, fmt::format("lot '{}' has no list of rings", name));
  }
  Footprint footprint{std::move(name), {}};
  for (const Json& ring : rings) {
    auto points = RingFrom(ring, fmt::format("a ring of lot '{}'", footprint.name));
    if (!points) return Fail(points);
    footprint.rings.push_back(std::move(*points));
  }
  return footprint;
}

Result<Footprint> LineFrom(std::string_view line, std::string_view file, int number) {
  auto json = ParseJson(line, file);
  if (!json) {
    Error error = json.error();
    if (error.place) error.place->line = number;
    return tl::unexpected<Error>(std::move(error));
  }
  const Json* rings = Member(*json, "rings");
  if (rings == nullptr) {
    return Fail(ErrorCode::kBadText, fmt::format("{}:{}: no \"rings\" in this line", file, number),
                "each line is {\"id\": …, \"rings\": [[[east, north], …], …]}");
  }
  return FootprintFrom(*rings, NameIn(*json, "id", fmt::format("line {}", number)));
}

Result<Footprints> LinesFrom(std::string_view text, std::string_view file) {
  Footprints footprints;
  int number = 0;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    start = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    auto footprint = LineFrom(line, file, number);
    if (!footprint) return Fail(footprint);
    footprints.push_back(std::move(*footprint));
  }
  return footprints;
}

Result<void> AddGeoJson(const Json& json, const std::string& name, int depth, Footprints* all);

Result<void> AddEach(const Json& object, const char* list, const std::string& name, int depth,
                     Footprints* all) {
  const Json* items = Member(object, list);
  if (items == nullptr || !items->is_array()) {
    return Fail(ErrorCode::kBadText, fmt::format("{} has no list \"{}\"", TypeOf(object), list));
  }
  for (const Json& item : *items) {
    if (auto added = AddGeoJson(item, name, depth + 1, all); !added) return added;
  }
  return {};
}

Result<void> AddPolygon(const Json* rings, std::string name, Footprints* all) {
  auto footprint = FootprintFrom(rings != nullptr ? *rings : Json(), std::move(name));
  if (!footprint) return Fail(footprint);
  all->push_back(std::move(*footprint));
  return {};
}

/// Points and lines are no lots and are passed over.
Result<void> AddGeoJson(const Json& json, const std::string& name, int depth, Footprints* all) {
  if (depth > kDeepestGeoJson) return Fail(ErrorCode::kLimitReached, "GeoJSON nested too deep");
  const std::string type = TypeOf(json);
  if (type == "FeatureCollection") return AddEach(json, "features", name, depth, all);
  if (type == "GeometryCollection") return AddEach(json, "geometries", name, depth, all);
  if (type == "Feature") {
    const Json* geometry = Member(json, "geometry");
    const Json* properties = Member(json, "properties");
    std::string id = fmt::format("{}", all->size());
    if (properties != nullptr) id = NameIn(*properties, "id", id);
    if (geometry == nullptr || geometry->is_null()) return {};
    return AddGeoJson(*geometry, NameIn(json, "id", id), depth + 1, all);
  }
  const Json* coordinates = Member(json, "coordinates");
  if (type == "Polygon") return AddPolygon(coordinates, name, all);
  if (type != "MultiPolygon" || coordinates == nullptr) return {};
  for (const Json& polygon : *coordinates) {
    if (auto added = AddPolygon(&polygon, name, all); !added) return added;
  }
  return {};
}

/// GeoJSON says degrees unless both sides know better; we take metres and refuse what can't be.
Result<void> CheckMetres(const Footprints& footprints) {
  Vec2 low(1e300), high(-1e300);
  for (const Footprint& footprint : footprints) {
    for (const Vec2& p : footprint.rings.front()) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const bool small = std::max(high.x - low.x, high.y - low.y) < kSmallestExtent_m;
  const bool like_degrees = low.x >= -180 && high.x <= 180 && low.y >= -90 && high.y <= 90;
  if (!small || !like_degrees) return {};
  return Fail(ErrorCode::kBadNumber, "these coordinates look like degrees, not metres",
              "project the file to metres first: ogr2ogr -t_srs EPSG:32633 out.geojson in.geojson");
}

bool IsGeoJson(const std::string& type) {
  for (const char* known :
       {"FeatureCollection", "Feature", "GeometryCollection", "Polygon", "MultiPolygon"}) {
    if (type == known) return true;
  }
  return false;
}

}  // namespace

Result<std::vector<Vec2>> RingFrom(const Json& ring, std::string_view what) {
  if (!ring.is_array()) return Fail(ErrorCode::kBadText, fmt::format("{} is not a list", what));
  std::vector<Vec2> points;
  points.reserve(ring.size());
  for (const Json& point : ring) {
    if (!point.is_array() || point.size() < 2) {
      return Fail(ErrorCode::kBadText, fmt::format("{} holds something that is no point", what),
                  "points are [east, north] in metres");
    }
    const auto east = NumberFrom(point[0], what);
    if (!east) return Fail(east);
    const auto north = NumberFrom(point[1], what);
    if (!north) return Fail(north);
    points.emplace_back(*east, *north);
  }
  return points;
}

Result<Footprints> FootprintsFrom(std::string_view text, std::string_view file) {
  // A line that is a whole object of its own begins a file of lines; any other JSON is one value.
  const size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const Json first = Json::parse(text.substr(start, text.find('\n', start) - start), nullptr,
                                 /*allow_exceptions=*/false);
  Footprints footprints;
  if (Member(first, "rings") != nullptr) {
    auto lines = LinesFrom(text, file);
    if (!lines) return lines;
    footprints = std::move(*lines);
  } else {
    const auto json = ParseJson(text, file);
    if (!json) return Fail(json);
    const std::string type = TypeOf(*json);
    if (type == "CityJSON") {
      auto city = CityJsonFootprints(*json);
      if (!city) return city;
      footprints = std::move(*city);
    } else if (IsGeoJson(type)) {
      const auto added = AddGeoJson(*json, "0", 0, &footprints);
      if (!added) return Fail(added);
      if (const auto metres = CheckMetres(footprints); !footprints.empty() && !metres) {
        return Fail(metres);
      }
    } else {
      return Fail(ErrorCode::kBadText, fmt::format("{} holds no lots", file),
                  "lots are lines with \"rings\", GeoJSON polygons in metres, or CityJSON");
    }
  }
  if (!footprints.empty()) return footprints;
  return Fail(ErrorCode::kNothingMade, fmt::format("{} holds no lots", file),
              "polygons of GeoJSON and buildings of CityJSON are lots");
}

}  // namespace parti::app
