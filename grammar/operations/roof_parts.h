// What the rows of roofs share: reading their arguments, and standing their meshes up in the world.
// The shapes of roofs are grammar/roof.h's.
#pragma once

#include <array>
#include <string_view>

#include "grammar/operations/rows.h"
#include "grammar/roof.h"

namespace parti::grammar {

/// CGA's valueType, which may be left out, and the number that it is for: the first two parameters
/// of every roof.
inline constexpr std::array<std::string_view, 2> kPitchWords = {"byAngle", "byHeight"};
Parameter PitchKindParameter();
Parameter PitchParameter(double default_deg);
/// A distance from 0 to 100 m that may be left out.
Parameter OverhangParameter(std::string_view name, std::string_view doc);

/// Whether the argument says how high a roof is [m], and not its angle.
bool IsHeight(const Action& action, size_t argument);
/// What the first two arguments say.
RoofPitch PitchOf(const Action& action);
/// An argument that is a number.
double NumberAt(const Action& action, size_t argument);

/// The one product of a roof: a volume over the planar item, from a mesh in its coordinates, z
/// along its normal. Stands up as extrude's do.
Result<std::vector<Product>> RoofOver(const Item& planar, Result<Mesh> roof);

/// The front (front_edge.h) in the item's own coordinates.
Vec2 FrontIn(const Item& planar);

}  // namespace parti::grammar
