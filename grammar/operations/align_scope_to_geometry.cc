// alignScopeToGeometry(upAxis, face, edge): the scope turned to an edge of the geometry.
#include <algorithm>
#include <array>
#include <utility>

#include "grammar/operations/rows.h"
#include "grammar/part_number.h"
#include "grammar/reframe.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kYUp = "yUp", kZUp = "zUp";
constexpr std::string_view kAny = "any", kAuto = "auto", kLargest = "largest";
constexpr std::string_view kLongest = "longest", kLowest = "world.lowest", kNone = "none";

/// The middle of a segment, for what is lowest.
double HeightOf(const Segment3& edge) { return (edge.a.y + edge.b.y) / 2; }

/// A planar shape's outline in the world.
std::vector<Segment3> OutlineOf(const Item& planar) {
  const Polygon polygon = PolygonOf(planar);
  std::vector<Segment3> edges;
  for (size_t i = 0; i < polygon.outer.size(); ++i) {
    const Vec2 &a = polygon.outer[i], &b = polygon.outer[(i + 1) % polygon.outer.size()];
    edges.push_back(
        {planar.scope.ToWorld(Vec3(a.x, a.y, 0)), planar.scope.ToWorld(Vec3(b.x, b.y, 0))});
  }
  return edges;
}

/// The edge that a word or number means; of equals the first.
const Segment3& Chosen(const std::vector<Segment3>& edges, std::string_view word) {
  if (const auto number = PartNumber(word)) return edges[RoundAndRound(*number, edges.size())];
  const auto before = [&](const Segment3& a, const Segment3& b) {
    if (word == kLowest) return HeightOf(a) < HeightOf(b) - kLengthTolerance_m;
    return glm::distance(a.a, a.b) > glm::distance(b.a, b.b) + kLengthTolerance_m;
  };
  return *std::min_element(edges.begin(), edges.end(), before);
}

/// The face that a word or number means.
const Item& ChosenFace(const std::vector<Item>& faces, std::string_view word) {
  if (const auto number = PartNumber(word)) return faces[RoundAndRound(*number, faces.size())];
  const auto lowest_of = [](const Item& face) {
    double lowest = INFINITY;
    for (const Segment3& edge : OutlineOf(face)) lowest = std::min(lowest, HeightOf(edge));
    return lowest;
  };
  const auto before = [&](const Item& a, const Item& b) {
    if (word == kLowest) return lowest_of(a) < lowest_of(b) - kLengthTolerance_m;
    return AreaOf(a) > AreaOf(b) + kAreaTolerance_m2;
  };
  return *std::min_element(faces.begin(), faces.end(), before);
}

Result<std::vector<Product>> ApplyAlign(const Item& item, const Action& action) {
  const auto& up = std::get<std::string>(action.arguments[0]);
  const auto& face = std::get<std::string>(action.arguments[1]);
  const auto& given = std::get<std::string>(action.arguments[2]);
  const std::string& edge = given == kNone ? face : given;
  const std::vector<Item> faces = FacesOf(item);
  if (faces.empty()) return std::vector<Product>{{item, -1}};
  const Item& chosen = ChosenFace(faces, given == kNone ? kAny : std::string_view(face));
  const std::vector<Segment3> outline = OutlineOf(chosen);
  const Segment3& along = Chosen(outline, edge);
  Scope axes;
  axes.x = glm::normalize(along.b - along.a);
  const Vec3& normal = chosen.scope.z;
  axes.y = up == kYUp ? normal : glm::cross(normal, axes.x);
  axes.z = glm::cross(axes.x, axes.y);
  return std::vector<Product>{{Reframed(item, axes), -1}};
}

constexpr std::array<std::string_view, 2> kUps = {kYUp, kZUp};
constexpr std::array<std::string_view, 6> kFaces = {kAny,     kAuto,   kLargest,
                                                    kLongest, kLowest, kAnyNumber};
constexpr std::array<std::string_view, 6> kEdges = {kNone,    kAny,    kAuto,
                                                    kLongest, kLowest, kAnyNumber};

const std::array<Parameter, 3> kParameters = {
    Parameter{.name = "upAxis",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kYUp),
              .doc = "the axis along the face's normal; a planar shape has its own names for them",
              .words = kUps},
    Parameter{.name = "face",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kAny),
              .doc = "a face's number from 0, or which; any is the largest",
              .words = kFaces},
    Parameter{.name = "edge",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kNone),
              .required = false,
              .doc = "the edge that becomes the x axis: its number from 0, or which; left out: the "
                     "second argument is the edge",
              .words = kEdges}};

}  // namespace

constinit const Operation kAlignToGeometry = {
    .name = "alignScopeToGeometry",
    .word = "AlignScopeToGeometry",
    .doc = "Turns the scope so that its x runs along an edge; the geometry stays where it is.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyAlign,
};

}  // namespace parti::grammar
