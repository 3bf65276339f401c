// The unit bodies that primitiveSphere, Cylinder and Cone insert, by what they depend on: a library
// keeps each once (asset_library.h), as it does what i() inserts.
#pragma once

#include <compare>
#include <memory>
#include <optional>

#include "grammar/action.h"
#include "grammar/mesh.h"

namespace parti::grammar {

/// Equal for bodies that are equal.
struct PrimitiveBody {
  enum class Kind : uint8_t { kCylindrical, kConical, kSpherical };
  Kind kind = Kind::kSpherical;
  int sides = 0, rings = 0;  ///< rings of a sphere, else 0
  auto operator<=>(const PrimitiveBody&) const = default;
};

/// What a valid action inserts; nothing for all other operations, cubes and what is flat.
std::optional<PrimitiveBody> PrimitiveBodyOf(const Action& action);

/// Made anew: a face takes about 150 bytes.
std::shared_ptr<const Mesh> MeshOf(const PrimitiveBody& body);

}  // namespace parti::grammar
