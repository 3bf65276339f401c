// Shapes, cameras and perfect or shaky pens for the tests of sketch/.
#pragma once

#include <vector>

#include "base/camera.h"
#include "base/random.h"
#include "base/stroke.h"
#include "grammar/item.h"
#include "sketch/configuration.h"

namespace parti::tests {

/// A rectangle: first corner at origin, x along `x`, normal `normal`.
grammar::Item Face(const Vec3& origin, const Vec3& x, const Vec3& normal, double width,
                   double height);
/// 20 m wide, 12 m deep, on the ground, its first corner at (-10, 0, 6).
grammar::Item Lot();
/// 16 m wide, 9 m high, facing south (+z), its lower left corner at (-8, 0, 0).
grammar::Item Facade();
/// 10 x 6 x 8 m, standing on the ground with its minimum corner at the origin.
grammar::Item Box();
/// From the south east, above, so that lot, façade and box fill a good part of the picture.
Camera HouseCamera();

/// A point of the item's plane (height over it) in the world.
Vec3 At(const grammar::Item& item, double x, double y, double height = 0);

/// Straight strokes along world lines, a sample every 8 px, each end off by a normal deviation of
/// `noise_px`; 100 px take 120 ms.
Stroke Draw(const std::vector<Vec3>& corners, const Camera& camera, double noise_px = 0,
            uint64_t seed = 1);

/// World lines as a configuration without runners-up.
sketch::Configuration Drawn(const std::vector<Segment3>& lines, const Camera& camera);

/// Turns a task about the world's y axis, or mirrors it in x; strokes stay as they are for turns.
grammar::Item Turned(const grammar::Item& item, Angle angle);
Camera Turned(Camera camera, Angle angle);

}  // namespace parti::tests
