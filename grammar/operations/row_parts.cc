#include "grammar/operations/row_parts.h"

namespace parti::grammar {

Parameter TurnParameter(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kAngle,
          .low = -3600,
          .high = 3600,
          .default_value = 0.0,
          .doc = doc};
}

Parameter UvSetParameter() {
  return {.name = "uvSet",
          .kind = ParameterKind::kFactor,
          .low = 0,
          .high = 9,
          .default_value = 0.0,
          .doc = "CGA's texture layer: 0, the color; others change nothing"};
}

Result<std::vector<Product>> Unchanged(const Item& item, const Action&) {
  return std::vector<Product>{{item, -1}};
}

}  // namespace parti::grammar
