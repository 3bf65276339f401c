// The ground that CityJSON's buildings stand on: their ground surfaces, merged along common edges,
// since files often hold them as triangles; the whole surface of land use.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/footprint.h"
#include "app/lot_values.h"
#include "grammar/polygon.h"

namespace parti::app {
namespace {

using Loop = std::vector<size_t>;  ///< vertex numbers
/// A surface: its outline, then holes.
struct Surface {
  std::vector<Loop> loops;
  std::string semantics;
};

struct City {
  std::vector<Vec3> vertices;  ///< east, north, height; m
};

Error Malformed(std::string_view what) {
  return {ErrorCode::kBadText, fmt::format("this CityJSON has {}", what)};
}

const Json& At(const Json& object, const char* name) {
  static const Json kNone;
  if (!object.is_object()) return kNone;
  const auto found = object.find(name);
  return found == object.end() ? kNone : *found;
}

Result<City> VerticesFrom(const Json& json, const Json& transform) {
  Vec3 scale(1), translate(0);
  if (transform.is_object()) {
    const auto s = Vec3From(At(transform, "scale"), "transform.scale");
    if (!s) return Fail(s);
    const auto t = Vec3From(At(transform, "translate"), "transform.translate");
    if (!t) return Fail(t);
    scale = *s;
    translate = *t;
  }
  City city;
  for (const Json& vertex : At(json, "vertices")) {
    const auto v = Vec3From(vertex, "a vertex");
    if (!v) return Fail(v);
    city.vertices.push_back(*v * scale + translate);
  }
  return city;
}

/// Adds the surfaces in a geometry's boundaries, whatever their depth: a list of lists of numbers
/// is one. `semantics` runs along beside, where there is one.
Result<void> AddSurfaces(const City& city, const Json& boundaries, const Json& values,
                         const Json& names, std::vector<Surface>* surfaces) {
  constexpr std::string_view kBad = "boundaries that are not numbers of vertices";
  if (!boundaries.is_array()) return tl::unexpected<Error>(Malformed(kBad));
  for (size_t i = 0; i < boundaries.size(); ++i) {
    const Json& part = boundaries[i];
    const Json value = values.is_array() && i < values.size() ? values[i] : Json();
    const bool is_surface = part.is_array() && !part.empty() && part[0].is_array() &&
                            !part[0].empty() && part[0][0].is_number();
    if (!is_surface) {
      if (auto added = AddSurfaces(city, part, value, names, surfaces); !added) return added;
      continue;
    }
    Surface surface;
    if (value.is_number_unsigned() && names.is_array() && value.get<size_t>() < names.size()) {
      const Json& type = At(names[value.get<size_t>()], "type");
      if (type.is_string()) surface.semantics = type.get<std::string>();
    }
    for (const Json& loop : part) {
      if (!loop.is_array()) return tl::unexpected<Error>(Malformed(kBad));
      Loop& numbers = surface.loops.emplace_back();
      for (const Json& number : loop) {
        if (!number.is_number_unsigned() || number.get<size_t>() >= city.vertices.size()) {
          return tl::unexpected<Error>(Malformed(kBad));
        }
        numbers.push_back(number.get<size_t>());
      }
    }
    surfaces->push_back(std::move(surface));
  }
  return {};
}

/// Twice the area vector over its length: the unit normal; 0 for surfaces without area.
Vec3 NormalOf(const City& city, const Surface& surface) {
  const Loop& outline = surface.loops.front();
  Vec3 sum(0);
  for (size_t i = 2; i < outline.size(); ++i) {
    const Vec3& a = city.vertices[outline[0]];
    sum += glm::cross(city.vertices[outline[i - 1]] - a, city.vertices[outline[i]] - a);
  }
  const double length = glm::length(sum);
  return length > 0 ? sum / length : sum;
}

double LowestOf(const City& city, const std::vector<Surface>& surfaces) {
  double lowest = 1e300;
  for (const Surface& s : surfaces) {
    for (const Loop& loop : s.loops) {
      for (const size_t i : loop) lowest = std::min(lowest, city.vertices[i].z);
    }
  }
  return lowest;
}

/// Ground surfaces where the file names them; else what faces down; else, in models that are open
/// below, the roof seen from above.
std::vector<Surface> GroundOf(const City& city, const std::vector<Surface>& surfaces) {
  constexpr double kFlat = 0.9;  // cosine; floors are flat, overhanging walls are not
  const auto those = [&](const auto& test) {
    std::vector<Surface> chosen;
    std::copy_if(surfaces.begin(), surfaces.end(), std::back_inserter(chosen), test);
    return chosen;
  };
  auto named = those([](const Surface& s) { return s.semantics == "GroundSurface"; });
  if (!named.empty()) return named;
  auto down = those([&](const Surface& s) { return NormalOf(city, s).z < -kFlat; });
  if (!down.empty()) return down;
  return those([&](const Surface& s) { return NormalOf(city, s).z > 1 - kFlat; });
}

/// The outlines of surfaces that share edges: every edge that is run through both ways is inside.
std::vector<Loop> BordersOf(const std::vector<Surface>& surfaces) {
  std::multiset<std::pair<size_t, size_t>> edges;
  for (const Surface& surface : surfaces) {
    for (const Loop& loop : surface.loops) {
      for (size_t i = 0; i < loop.size(); ++i) {
        const size_t from = loop[i], to = loop[(i + 1) % loop.size()];
        if (const auto back = edges.find({to, from}); back != edges.end()) {
          edges.erase(back);
        } else if (from != to) {
          edges.insert({from, to});
        }
      }
    }
  }
  std::vector<Loop> borders;
  while (!edges.empty()) {
    Loop loop{edges.begin()->first};
    do {
      const auto edge = edges.lower_bound({loop.back(), 0});
      if (edge == edges.end() || edge->first != loop.back()) break;  // a border that does not close
      loop.push_back(edge->second);
      edges.erase(edge);
    } while (loop.back() != loop.front());
    if (loop.back() == loop.front()) loop.pop_back();
    borders.push_back(std::move(loop));
  }
  return borders;
}

/// Borders as footprints: those with the winding of the whole are outlines, the others holes.
std::vector<Footprint> FootprintsOf(const City& city, const std::vector<Loop>& borders,
                                    const Footprint& model) {
  std::vector<grammar::Ring> rings;
  double sum = 0;
  for (const Loop& loop : borders) {
    grammar::Ring& ring = rings.emplace_back();
    for (const size_t i : loop) ring.emplace_back(city.vertices[i].x, city.vertices[i].y);
    sum += grammar::SignedArea(ring);
  }
  std::vector<Footprint> footprints;
  for (const grammar::Ring& ring : rings) {
    if (grammar::SignedArea(ring) * sum <= 0) continue;
    footprints.push_back(model);
    footprints.back().rings.push_back(ring);
  }
  for (grammar::Ring& ring : rings) {
    if (grammar::SignedArea(ring) * sum >= 0) continue;
    for (Footprint& footprint : footprints) {
      if (!grammar::Contains({footprint.rings.front(), {}}, ring.front())) continue;
      footprint.rings.push_back(std::move(ring));
      break;
    }
  }
  return footprints;
}

/// The first geometry that is made of surfaces: the ground is the same in every level of detail.
/// Points, lines and instances of templates say nothing of it.
const Json& SurfacesOf(const Json& object) {
  static const Json kNone;
  const Json& geometries = At(object, "geometry");
  if (!geometries.is_array()) return kNone;
  for (const Json& geometry : geometries) {
    const Json& type = At(geometry, "type");
    if (type != "MultiPoint" && type != "MultiLineString" && type != "GeometryInstance") {
      return geometry;
    }
  }
  return kNone;
}

bool IsBuilding(const Json& object) {
  const Json& type = At(object, "type");
  return type == "Building" || type == "BuildingPart";
}

/// What the file says of an object, and, where it is a part, of its buildings: many files have the
/// attributes of a building there alone. Its own come first.
Json AttributesOf(const Json& objects, const Json& object) {
  Json all = Json::object();
  const auto add = [&all](const Json& attributes) {
    if (attributes.is_object()) all.insert(attributes.begin(), attributes.end());
  };
  add(At(object, "attributes"));
  for (const Json& parent : At(object, "parents")) {
    if (parent.is_string()) add(At(At(objects, parent.get<std::string>().c_str()), "attributes"));
  }
  return all;
}

Result<std::vector<Footprint>> ObjectFootprints(const City& city, const std::string& name,
                                                const Json& objects) {
  const Json& object = objects[name];
  const Json& geometry = SurfacesOf(object);
  if ((!IsBuilding(object) && At(object, "type") != "LandUse") || geometry.is_null()) {
    return std::vector<Footprint>();
  }
  const Json attributes = AttributesOf(objects, object);
  const auto street = StreetIn(attributes, name);
  if (!street) return Fail(street);
  const Json& semantics = At(geometry, "semantics");
  std::vector<Surface> surfaces;
  const auto added = AddSurfaces(city, At(geometry, "boundaries"), At(semantics, "values"),
                                 At(semantics, "surfaces"), &surfaces);
  if (!added) {
    Error error = added.error();
    error.message = fmt::format("{}, in '{}'", error.message, name);
    return tl::unexpected<Error>(std::move(error));
  }
  const auto ground = IsBuilding(object) ? GroundOf(city, surfaces) : surfaces;
  return FootprintsOf(city, BordersOf(ground),
                      {name, {}, LowestOf(city, surfaces), *street, PropertiesIn(attributes)});
}

/// A point inside, in the middle of the largest triangle; nothing for what is no polygon.
std::optional<Vec2> PointIn(const Footprint& footprint) {
  const auto polygon = grammar::PolygonFrom(footprint.rings);
  if (!polygon) return std::nullopt;
  std::vector<Vec2> corners = polygon->outer;
  for (const grammar::Ring& hole : polygon->holes) {
    corners.insert(corners.end(), hole.begin(), hole.end());
  }
  const std::vector<uint32_t> triangles = grammar::Triangulate(*polygon);
  std::optional<Vec2> middle;
  double largest = 0;
  for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const Vec2 &a = corners[triangles[i]], &b = corners[triangles[i + 1]],
               &c = corners[triangles[i + 2]];
    const double area = std::abs(Cross(b - a, c - a));
    if (area <= largest) continue;
    largest = area;
    middle = (a + b + c) / 3.0;
  }
  return middle;
}

bool StandsOn(const Footprint& footprint, const std::vector<Footprint>& grounds) {
  const auto point = PointIn(footprint);
  return point && std::any_of(grounds.begin(), grounds.end(), [&](const Footprint& ground) {
           const auto polygon = grammar::PolygonFrom(ground.rings);
           return polygon && grammar::Contains(*polygon, *point);
         });
}

using Grounds = std::map<std::string, std::vector<Footprint>>;

/// Whether a part of a building stands on ground that the building itself has, as in files that
/// give a building's outline and, beside it, its parts as solids.
bool IsOnItsBuilding(const Footprint& footprint, const Json& object, const Grounds& grounds) {
  const Json& parents = At(object, "parents");
  if (!parents.is_array()) return false;
  return std::any_of(parents.begin(), parents.end(), [&](const Json& parent) {
    const auto found = parent.is_string() ? grounds.find(parent.get<std::string>()) : grounds.end();
    return found != grounds.end() && StandsOn(footprint, found->second);
  });
}

}  // namespace

Result<void> AddCityJson(const Json& json, const Json& transform, FootprintList* lots) {
  const auto city = VerticesFrom(json, transform);
  if (!city) return Fail(city);
  const Json& objects = At(json, "CityObjects");
  if (!objects.is_object()) return tl::unexpected<Error>(Malformed("no CityObjects"));
  Grounds grounds;
  for (const auto& [name, object] : objects.items()) {
    auto footprints = ObjectFootprints(*city, name, objects);
    if (footprints) {
      grounds.emplace(name, std::move(*footprints));
    } else if (auto added = lots->Add(Fail(footprints)); !added) {
      return added;
    }
  }
  for (const auto& [name, footprints] : grounds) {
    for (const Footprint& footprint : footprints) {
      if (IsOnItsBuilding(footprint, objects[name], grounds)) continue;
      if (auto added = lots->Add(footprint); !added) return added;
    }
  }
  return {};
}

}  // namespace parti::app
