// Which edge of a face comes first: the x axis of the face's scope.
// Upright faces start at their bottom, so that every façade is split the same way.
#pragma once

#include "grammar/mesh.h"

namespace parti::grammar {

/// Turns a loop (the set of corners stays) so that the edge that runs most nearly along `direction`
/// comes first; of equal ones the lowest, then the earliest.
void StartAlong(const std::vector<Vec3>& points, const Vec3& direction,
                std::vector<uint32_t>* loop);

/// The direction in which the bottom edge of a face runs, seen from outside, y up; 0 for faces that
/// lie flat, which have no bottom.
Vec3 BottomDirection(const Vec3& normal);

/// Starts every face that does not lie flat at its bottom.
void StartAtBottom(Mesh* mesh);

}  // namespace parti::grammar
