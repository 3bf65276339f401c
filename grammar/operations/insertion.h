// How a body comes into a scope: the part that i and the primitives share.
// Where the body comes from is theirs.
#pragma once

#include <memory>

#include "grammar/item.h"

namespace parti::grammar {

/// A unit mesh and where it lies in its own coordinates.
struct Insertion {
  Vec3 low{0, 0, 0};
  Vec3 size{0, 0, 0};
  std::shared_ptr<const Mesh> mesh;
};

/// Where it comes to lie, by CGA's names: in the scope; along axes where that has no size, as large
/// as the mean of the others' stretch makes it (its own size where there are none), and as far from
/// the scope as it is from its own origin.
Scope FittedTo(const Scope& named, const Insertion& in);

/// A box of this size in the middle of the scope's x and z, on its floor.
Scope StoodIn(const Scope& named, const Vec3& size);

/// The volume that this mesh makes in a scope; null: the whole box. Keeps of `item` what was asked
/// for and the mesh does not bring itself: where the mesh has materials, no color and no material;
/// never where its texture lay.
Item Inserted(const Item& item, const Scope& scope, std::shared_ptr<const Mesh> mesh);

}  // namespace parti::grammar
