// Finding where rings cross or touch: the check behind PolygonFrom.
// Says where, for the error message; mends nothing.
#pragma once

#include <optional>
#include <vector>

#include "grammar/polygon.h"

namespace parti::grammar {

/// Two edges that share a point and should not: ring and edge numbers (edge i runs from corner i).
struct Contact {
  size_t ring_a = 0, edge_a = 0;
  size_t ring_b = 0, edge_b = 0;
  Vec2 at{0, 0};
  bool crosses = false;  ///< else they only touch
};

/// The first contact, by lower x of the edges, between edges that are not neighbours in their ring,
/// or between neighbours beyond the corner they share; nothing when all rings are simple and apart
/// by more than tolerance_m. O(n log n) and the pairs that overlap in x.
std::optional<Contact> FindContact(const std::vector<Ring>& rings, double tolerance_m);

}  // namespace parti::grammar
