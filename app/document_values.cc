#include "app/document_values.h"

#include <cstring>
#include <limits>

#include "base/json.h"

namespace parti::app {
namespace {

Json JsonOf(const Vec3& v) { return Json::array({v.x, v.y, v.z}); }

Json JsonOf(const grammar::Ring& ring) {
  Json list = Json::array();
  for (const Vec2& p : ring) list.push_back({p.x, p.y});
  return list;
}

/// The member `key` of an object, or null.
const Json& Member(const Json& object, const char* key) {
  static const Json kNull;
  const auto at = object.find(key);
  return object.is_object() && at != object.end() ? *at : kNull;
}

/// Reads one vector after the other into its place; stops at the first failure.
struct VectorReader {
  const Json& object;
  Result<void> result = {};

  void Read(const char* key, Vec3* into) {
    if (!result) return;
    const auto v = Vec3From(Member(object, key), key);
    if (v) {
      *into = *v;
    } else {
      result = Fail(v);
    }
  }
  double Number(const char* key) {
    const auto number = NumberFrom(Member(object, key), key);
    if (!number && result) result = Fail(number);
    return number.value_or(0);
  }
};

Result<grammar::Ring> RingFrom(const Json& list) {
  grammar::Ring ring;
  for (const Json& point : list) {
    if (!point.is_array() || point.size() != 2) {
      return Fail(ErrorCode::kBadText, "a corner is not two numbers");
    }
    const auto x = NumberFrom(point[0], "corner"), y = NumberFrom(point[1], "corner");
    if (!x) return Fail(x);
    if (!y) return Fail(y);
    ring.emplace_back(*x, *y);
  }
  return ring;
}

constexpr size_t kSampleNumbers = 4;

}  // namespace

std::string JsonOf(const Camera& camera) {
  const Json json = {{"eye", JsonOf(camera.eye)}, {"target", JsonOf(camera.target)},
                     {"up", JsonOf(camera.up)},   {"vfov_deg", camera.vertical_fov.degrees()},
                     {"width", camera.width_px},  {"height", camera.height_px}};
  return json.dump();
}

Result<Camera> CameraFrom(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  Camera camera;
  VectorReader reader{*json};
  reader.Read("eye", &camera.eye);
  reader.Read("target", &camera.target);
  reader.Read("up", &camera.up);
  camera.vertical_fov = Angle::Degrees(reader.Number("vfov_deg"));
  camera.width_px = reader.Number("width");
  camera.height_px = reader.Number("height");
  if (!reader.result) return Fail(reader.result);
  if (const auto valid = Validate(camera); !valid) return Fail(valid);
  return camera;
}

std::string JsonOf(const grammar::Item& planar) {
  const grammar::Scope& s = planar.scope;
  Json json = {{"origin", JsonOf(s.origin)}, {"x", JsonOf(s.x)},
               {"y", JsonOf(s.y)},           {"z", JsonOf(s.z)},
               {"size", JsonOf(s.size)},     {"facing", JsonOf(planar.facing)}};
  if (planar.street_deg) json["street_deg"] = *planar.street_deg;
  if (planar.polygon) {
    json["rings"] = Json::array({JsonOf(planar.polygon->outer)});
    for (const grammar::Ring& hole : planar.polygon->holes) json["rings"].push_back(JsonOf(hole));
  }
  return json.dump();
}

Result<grammar::Item> PlanarItemFrom(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  grammar::Item item;
  VectorReader reader{*json};
  reader.Read("origin", &item.scope.origin);
  reader.Read("x", &item.scope.x);
  reader.Read("y", &item.scope.y);
  reader.Read("z", &item.scope.z);
  reader.Read("size", &item.scope.size);
  reader.Read("facing", &item.facing);
  if (json->contains("street_deg")) {
    item.street_deg = static_cast<float>(reader.Number("street_deg"));
  }
  if (!reader.result) return Fail(reader.result);
  const Json& rings = Member(*json, "rings");
  if (rings.is_null()) return item;
  if (!rings.is_array() || rings.empty()) {
    return Fail(ErrorCode::kBadText, "rings is not a list of rings");
  }
  auto polygon = std::make_shared<grammar::Polygon>();
  for (const Json& list : rings) {
    auto ring = RingFrom(list);
    if (!ring) return Fail(ring);
    if (&list == &rings.front()) {
      polygon->outer = std::move(*ring);
    } else {
      polygon->holes.push_back(std::move(*ring));
    }
  }
  // A whole check, not only of the form: a damaged document must not break the geometry's promises.
  std::vector<grammar::Ring> all = {polygon->outer};
  all.insert(all.end(), polygon->holes.begin(), polygon->holes.end());
  if (const auto valid = grammar::PolygonFrom(all); !valid) return Fail(valid);
  item.polygon = std::move(polygon);
  return item;
}

std::string BytesOf(const Stroke& stroke) {
  static_assert(std::numeric_limits<double>::is_iec559);
  std::string bytes;
  bytes.reserve(stroke.size() * kSampleNumbers * sizeof(double));
  for (const StrokeSample& s : stroke) {
    const double numbers[kSampleNumbers] = {
        s.position.x, s.position.y, s.t_s,
        s.pressure.value_or(std::numeric_limits<double>::quiet_NaN())};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  }
  return bytes;
}

Result<Stroke> StrokeFromBytes(std::string_view bytes) {
  constexpr size_t kSampleBytes = kSampleNumbers * sizeof(double);
  if (bytes.size() % kSampleBytes != 0) {
    return Fail(ErrorCode::kDamagedFile, "a stroke ends in the middle of a sample");
  }
  Stroke stroke;
  for (size_t at = 0; at < bytes.size(); at += kSampleBytes) {
    double numbers[kSampleNumbers];
    std::memcpy(numbers, bytes.data() + at, sizeof numbers);
    StrokeSample sample{Vec2(numbers[0], numbers[1]), numbers[2], std::nullopt};
    if (!IsFinite(sample.position) || !std::isfinite(sample.t_s)) {
      return Fail(ErrorCode::kDamagedFile, "a stroke has a number that is not finite");
    }
    if (std::isfinite(numbers[3])) sample.pressure = numbers[3];
    stroke.push_back(sample);
  }
  return stroke;
}

}  // namespace parti::app
