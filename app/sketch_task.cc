#include "app/sketch_task.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/operation.h"

namespace parti::app {
namespace {

Result<const Json*> Member(const Json& object, const char* key, const std::string& what) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  if (!object.is_object() || found == object.end()) {
    return Fail(ErrorCode::kBadText, fmt::format("{} is missing", what));
  }
  return &*found;
}

Result<Vec3> VectorAt(const Json& object, const char* key, const std::string& owner) {
  const std::string what = fmt::format("{}.{}", owner, key);
  const auto member = Member(object, key, what);
  if (!member) return Fail(member);
  return Vec3From(**member, what);
}

Result<double> NumberAt(const Json& object, const char* key, const std::string& owner) {
  const std::string what = fmt::format("{}.{}", owner, key);
  const auto member = Member(object, key, what);
  if (!member) return Fail(member);
  return NumberFrom(**member, what);
}

// Reads into `value` unless something failed before.
template <typename T>
void Read(Result<T> (*reader)(const Json&, const char*, const std::string&), const Json& object,
          const char* key, const char* owner, T* value, Result<void>* so_far) {
  if (!*so_far) return;
  const auto result = reader(object, key, owner);
  if (!result) {
    *so_far = tl::unexpected<Error>(result.error());
  } else {
    *value = *result;
  }
}

Result<Camera> CameraFrom(const Json& json) {
  Camera camera;
  double fov_deg = 0;
  Result<void> so_far;
  Read(&VectorAt, json, "eye", "camera", &camera.eye, &so_far);
  Read(&VectorAt, json, "target", "camera", &camera.target, &so_far);
  Read(&VectorAt, json, "up", "camera", &camera.up, &so_far);
  Read(&NumberAt, json, "vfov_deg", "camera", &fov_deg, &so_far);
  Read(&NumberAt, json, "width", "camera", &camera.width_px, &so_far);
  Read(&NumberAt, json, "height", "camera", &camera.height_px, &so_far);
  camera.vertical_fov = Angle::Degrees(fov_deg);
  if (so_far) so_far = Validate(camera);
  if (!so_far) return tl::unexpected<Error>(so_far.error());
  return camera;
}

Result<grammar::Item> FaceFrom(const Json& corners) {
  if (!corners.is_array()) {
    return Fail(ErrorCode::kBadText, "shape.polygon is not a list of points");
  }
  std::vector<Vec3> ring;
  for (const Json& corner : corners) {
    const auto point = Vec3From(corner, fmt::format("shape.polygon[{}]", ring.size()));
    if (!point) return Fail(point);
    ring.push_back(*point);
  }
  return grammar::PlanarFrom({ring});
}

Result<grammar::Item> BoxItemFrom(const Json& box) {
  grammar::Scope scope;
  Result<void> so_far;
  Read(&VectorAt, box, "origin", "shape.box", &scope.origin, &so_far);
  Read(&VectorAt, box, "x", "shape.box", &scope.x, &so_far);
  Read(&VectorAt, box, "y", "shape.box", &scope.y, &so_far);
  Read(&VectorAt, box, "z", "shape.box", &scope.z, &so_far);
  Read(&VectorAt, box, "size", "shape.box", &scope.size, &so_far);
  if (!so_far) return tl::unexpected<Error>(so_far.error());
  constexpr double kRounded = 1e-3;  // axes written with few digits are still axes
  for (int i = 0; i < 3; ++i) {
    const double off = glm::length(scope.axis(i)) - 1;
    const double lean = glm::dot(scope.axis(i), scope.axis((i + 1) % 3));
    if (std::abs(off) > kRounded || std::abs(lean) > kRounded) {
      return Fail(ErrorCode::kBadNumber, "the axes of shape.box are not at right angles",
                  "x, y and z are wanted as unit vectors");
    }
  }
  scope.x = glm::normalize(scope.x);
  scope.y = glm::normalize(scope.y - scope.x * glm::dot(scope.x, scope.y));
  if (glm::dot(glm::cross(scope.x, scope.y), scope.z) < 0) {
    return Fail(ErrorCode::kBadNumber, "the axes of shape.box are left-handed",
                "swap two of them, or turn one around and move the origin to its other end");
  }
  scope.z = glm::cross(scope.x, scope.y);
  return grammar::BoxFrom(scope);
}

Result<grammar::Item> ShapeFrom(const Json& shape) {
  if (const auto face = Member(shape, "polygon", "shape.polygon")) return FaceFrom(**face);
  if (const auto box = Member(shape, "box", "shape.box")) return BoxItemFrom(**box);
  return Fail(ErrorCode::kBadText, "shape has neither a polygon nor a box");
}

Result<std::vector<Stroke>> StrokesFrom(const Json& list) {
  if (!list.is_array()) return Fail(ErrorCode::kBadText, "strokes is not a list");
  if (list.empty()) return Fail(ErrorCode::kTooShort, "there are no strokes");
  std::vector<Stroke> strokes;
  for (const Json& points : list) {
    auto stroke = parti::StrokeFrom(points, fmt::format("strokes[{}]", strokes.size()));
    if (!stroke) return Fail(stroke);
    strokes.push_back(std::move(*stroke));
  }
  return strokes;
}

double FirstNumber(const grammar::Action& action) {
  for (const grammar::Argument& argument : action.arguments) {
    if (const auto* number = std::get_if<double>(&argument)) return *number;
  }
  return 0;
}

std::optional<grammar::Axis> AxisIn(const grammar::Action& action) {
  for (const grammar::Argument& argument : action.arguments) {
    if (const auto* axis = std::get_if<grammar::Axis>(&argument)) return *axis;
  }
  return std::nullopt;
}

// Extents of the products along the axis, in order: what the sizes came to on this item.
std::vector<double> ExtentsAlong(int axis, const grammar::Action& action,
                                 const grammar::Item& item) {
  std::vector<double> sizes;
  const auto products = grammar::Apply(action, item);
  if (!products) return sizes;
  std::optional<int> last;
  for (const grammar::Product& product : *products) {
    // Pieces of one successor side by side (of a concave outline) are one part.
    if (action.operation->name == "split" && last == product.successor) continue;
    sizes.push_back(product.item.scope.size[axis]);
    last = product.successor;
  }
  return sizes;
}

BatchAnswer DialsOf(grammar::Action action) {
  BatchAnswer params = BatchAnswer::object();
  for (const grammar::Dial& dial : grammar::Dials(&action)) params[dial.name] = *dial.value;
  return params;
}

BatchAnswer ParamsOf(const grammar::Action& action, const grammar::Item& item) {
  const std::string_view name = action.operation->name;
  const auto axis = AxisIn(action);
  const int index = axis ? static_cast<int>(*axis) : 0;
  const std::string axis_name(1, "xyz"[index]);
  if (name == "extrude") return {{"distance", FirstNumber(action)}};
  if (name == "offset") return {{"distance", -FirstNumber(action)}};
  if (name == "comp") return BatchAnswer::object();
  if (name == "split") return {{"axis", axis_name}, {"sizes", ExtentsAlong(index, action, item)}};
  if (name == "repeat") {
    const size_t count = ExtentsAlong(index, action, item).size();
    const double size = item.scope.size[index] / static_cast<double>(std::max<size_t>(count, 1));
    return {{"axis", axis_name}, {"count", count}, {"size", size}};
  }
  return DialsOf(action);
}

}  // namespace

Result<SketchTask> SketchTaskFrom(const Json& task) {
  const auto shape = Member(task, "shape", "shape");
  if (!shape) return Fail(shape);
  const auto camera_json = Member(task, "camera", "camera");
  if (!camera_json) return Fail(camera_json);
  const auto list = Member(task, "strokes", "strokes");
  if (!list) return Fail(list);
  auto item = ShapeFrom(**shape);
  if (!item) return Fail(item);
  const auto camera = CameraFrom(**camera_json);
  if (!camera) return Fail(camera);
  auto strokes = StrokesFrom(**list);
  if (!strokes) return Fail(strokes);
  return SketchTask{std::move(*item), *camera, std::move(*strokes)};
}

BatchAnswer AnswerOf(const sketch::Suggestion& suggestion, const grammar::Item& item) {
  return {{"op", suggestion.action.operation->name}, {"params", ParamsOf(suggestion.action, item)}};
}

}  // namespace parti::app
