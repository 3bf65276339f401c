#include "app/footprint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/lot_values.h"

namespace parti::app {
namespace {

using Footprints = std::vector<Footprint>;

/// A file of GeoJSON whose coordinates could all be degrees, and none of whose lots is wider than
/// this, is in degrees: no lot is half a metre wide.
constexpr double kSmallestExtent_m = 0.5;
constexpr double kWidestZone_deg = 6;  ///< of UTM

const Json* Member(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

std::string TypeOf(const Json& object) {
  const Json* type = Member(object, "type");
  return type != nullptr && type->is_string() ? type->get<std::string>() : "";
}

/// Which projection in metres fits a place in degrees: UTM's zone, by its EPSG number.
int UtmOf(const Vec2& place) {
  const int zone = static_cast<int>(std::floor((place.x + 180) / kWidestZone_deg)) % 60 + 1;
  return (place.y < 0 ? 32700 : 32600) + zone;
}

/// GeoJSON says degrees unless both sides know better; we take metres and refuse what can't be.
Result<void> CheckMetres(const Footprints& footprints) {
  Vec2 low(1e300), high(-1e300);
  double widest = 0;
  for (const Footprint& footprint : footprints) {
    Vec2 own_low(1e300), own_high(-1e300);
    for (const Vec2& p : footprint.rings.front()) {
      own_low = glm::min(own_low, p);
      own_high = glm::max(own_high, p);
    }
    widest = std::max({widest, own_high.x - own_low.x, own_high.y - own_low.y});
    low = glm::min(low, own_low);
    high = glm::max(high, own_high);
  }
  const bool like_degrees = low.x >= -180 && high.x <= 180 && low.y >= -90 && high.y <= 90;
  if (widest >= kSmallestExtent_m || !like_degrees) return {};
  return Fail(ErrorCode::kBadNumber, "these coordinates look like degrees, not metres",
              fmt::format("project the file to metres first: ogr2ogr -t_srs EPSG:{} out.geojson "
                          "in.geojson",
                          UtmOf((low + high) * 0.5)));
}

/// Takes in one JSON value after the other: a file's only one, or those of its lines.
class Reader {
 public:
  Reader(std::string_view file, std::vector<Error>* refused)
      : file_(file), refused_(refused), footprints_(refused) {}

  /// `name` is for a lot that has none of its own.
  Result<void> Add(const Json& value, std::string name) {
    const std::string type = TypeOf(value);
    if (Member(value, "rings") != nullptr) return AddRings(value, std::move(name));
    if (type == "CityJSON" || type == "CityJSONFeature") return AddCity(value, type);
    if (!IsGeoJson(type)) {
      return Fail(ErrorCode::kBadText, "this holds no lots",
                  "lots are lines with \"rings\", GeoJSON polygons in metres, or CityJSON");
    }
    is_geo_json_ = true;
    return AddGeoJson(value, &footprints_);
  }

  Result<Footprints> Finish() && {
    Footprints all = std::move(footprints_).Take();
    if (all.empty() && refused_ != nullptr && !refused_->empty()) {
      Error error = refused_->front();
      error.message = fmt::format("{}: {}", file_, error.message);
      return tl::unexpected<Error>(std::move(error));
    }
    if (all.empty()) {
      return Fail(ErrorCode::kNothingMade, fmt::format("{} holds no lots", file_),
                  "polygons of GeoJSON and buildings of CityJSON are lots");
    }
    if (is_geo_json_) {
      if (const auto metres = CheckMetres(all); !metres) return Fail(metres);
    }
    return all;
  }

 private:
  Result<void> AddRings(const Json& value, std::string name) {
    if (const Json* id = Member(value, "id")) {
      if (id->is_string()) name = id->get<std::string>();
      if (id->is_number()) name = id->dump();
    }
    const auto street = StreetIn(value, name);
    if (!street) return footprints_.Add(Fail(street));
    auto rings = RingsFrom(value["rings"], name);
    if (!rings) return footprints_.Add(Fail(rings));
    LotProperties properties = PropertiesIn(value);
    std::erase_if(properties, [](const LotProperty& one) { return one.name == "rings"; });
    return footprints_.Add(
        Footprint{std::move(name), std::move(*rings), 0, *street, std::move(properties)});
  }

  /// The first line of a CityJSONSeq is a CityJSON object that has what its features share.
  Result<void> AddCity(const Json& value, const std::string& type) {
    const Json* own = Member(value, "transform");
    if (type == "CityJSON") transform_ = own != nullptr ? *own : Json();
    has_header_ = has_header_ || type == "CityJSON";
    if (!has_header_) {
      return Fail(ErrorCode::kBadText, "a CityJSONFeature stands before any CityJSON object",
                  "the first line of a CityJSONSeq says how vertices are placed");
    }
    return AddCityJson(value, transform_, &footprints_);
  }

  std::string_view file_;
  std::vector<Error>* refused_;
  FootprintList footprints_;
  Json transform_;
  bool has_header_ = false, is_geo_json_ = false;
};

/// An error that has no place in its text names the file, or the line of it.
tl::unexpected<Error> In(std::string_view where, Error error) {
  if (!error.place) error.message = fmt::format("{}: {}", where, error.message);
  return tl::unexpected<Error>(std::move(error));
}

Result<void> AddLine(std::string_view line, std::string_view file, int number, Reader* reader) {
  auto json = ParseJson(line, file);
  if (!json) {
    Error error = json.error();
    if (error.place) error.place->line = number;
    return tl::unexpected<Error>(std::move(error));
  }
  auto added = reader->Add(*json, fmt::format("line {}", number));
  if (!added) return In(fmt::format("{}:{}", file, number), added.error());
  return {};
}

Result<void> AddLines(std::string_view text, std::string_view file, Reader* reader) {
  constexpr std::string_view kBlank = " \t\r\x1e";  // a record of RFC 8142 begins with the last
  int number = 0;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    std::string_view line = text.substr(start, end - start);
    start = end + 1;
    ++number;
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    if (line.empty()) continue;
    if (auto added = AddLine(line, file, number, reader); !added) return added;
  }
  return {};
}

/// Whether a text is lines: its first is a whole object of its own.
bool IsLines(std::string_view text) {
  const size_t start = std::min(text.find_first_not_of(" \t\r\n\x1e"), text.size());
  const Json first = Json::parse(text.substr(start, text.find('\n', start) - start), nullptr,
                                 /*allow_exceptions=*/false);
  return first.is_object();
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

Result<std::vector<std::vector<Vec2>>> RingsFrom(const Json& rings, std::string_view lot) {
  if (!rings.is_array() || rings.empty()) {
    return Fail(ErrorCode::kBadText, fmt::format("lot '{}' has no list of rings", lot));
  }
  std::vector<std::vector<Vec2>> all;
  for (const Json& ring : rings) {
    auto points = RingFrom(ring, fmt::format("a ring of lot '{}'", lot));
    if (!points) return Fail(points);
    all.push_back(std::move(*points));
  }
  return all;
}

Result<std::optional<double>> StreetIn(const Json& properties, std::string_view lot) {
  constexpr double kTurn_deg = 360;
  const Json* given = Member(properties, "street_deg");
  if (given == nullptr || given->is_null()) return std::optional<double>();
  const std::string what = fmt::format("street_deg of lot '{}'", lot);
  const auto street = NumberFrom(*given, what);
  if (!street) return Fail(street);
  if (std::abs(*street) <= kTurn_deg) return std::optional<double>(*street);
  return Fail(ErrorCode::kBadNumber, fmt::format("{} is {}", what, *street),
              "0: the street lies in the north, 90: in the east; from -360 to 360");
}

Result<Footprints> FootprintsFrom(std::string_view text, std::string_view file,
                                  std::vector<Error>* refused) {
  Reader reader(file, refused);
  if (IsLines(text)) {
    if (const auto added = AddLines(text, file, &reader); !added) return Fail(added);
  } else {
    const auto json = ParseJson(text, file);
    if (!json) return Fail(json);
    if (const auto added = reader.Add(*json, "0"); !added) return In(file, added.error());
  }
  return std::move(reader).Finish();
}

}  // namespace parti::app
