#include "grammar/operations/roof_parts.h"

#include <utility>

#include "grammar/front_edge.h"
#include "grammar/item_make.h"
#include "grammar/mesh_edges.h"

namespace parti::grammar {

Parameter PitchKindParameter() {
  return {.name = "valueType",
          .kind = ParameterKind::kWord,
          .default_value = std::string(kPitchWords[0]),
          .required = false,
          .doc = "what the next number is: an angle, or with byHeight the roof's height",
          .words = kPitchWords};
}

Parameter PitchParameter(double default_deg) {
  return {.name = "angle",
          .kind = ParameterKind::kAngle,
          .low = 0,
          .high = 1e4,
          .default_value = default_deg,
          .doc = "of the roof planes, 0.1 to 89 degrees; byHeight: the height in metres"};
}

Parameter OverhangParameter(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kLength,
          .low = 0,
          .high = 100,
          .default_value = 0.0,
          .required = false,
          .doc = doc};
}

double NumberAt(const Action& action, size_t argument) {
  return std::get<double>(action.arguments[argument]);
}

bool IsHeight(const Action& action, size_t argument) {
  const auto parameters = action.operation->parameters;
  return argument == 1 && !parameters.empty() && parameters[0].words.data() == kPitchWords.data() &&
         std::get<std::string>(action.arguments[0]) == kPitchWords[1];
}

RoofPitch PitchOf(const Action& action) { return {IsHeight(action, 1), NumberAt(action, 1)}; }

Result<std::vector<Product>> RoofOver(const Item& planar, Result<Mesh> roof) {
  if (!roof) return Fail(roof);
  Vec3 low = roof->points[0], high = low;
  for (const Vec3& p : roof->points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Scope drawn = planar.scope;
  drawn.origin = planar.scope.ToWorld(low);
  drawn.size = high - low;
  const Standing standing = StandingOf(drawn);
  for (Vec3& p : roof->points) p = StandUp(p - low, drawn.size, standing);
  StartAtBottom(&*roof);
  std::vector<Product> products;
  products.push_back({VolumeItem(StandUp(drawn, standing), std::move(*roof), planar), -1});
  return products;
}

Vec2 FrontIn(const Item& planar) {
  const Vec3 front = FrontOf(planar);
  return {glm::dot(front, planar.scope.x), glm::dot(front, planar.scope.y)};
}

}  // namespace parti::grammar
