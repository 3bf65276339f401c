// Small scenes made by hand, with every kind of thing that a picture can hold.
// Scenes of shape trees are the tests of app.
#pragma once

#include "render/offscreen.h"

namespace parti::render::tests {

/// Adds a closed box and its twelve edges.
void AddBox(Scene* scene, const Vec3f& low, const Vec3f& high, uint32_t id,
            const Vec3f& color = Faces{}.color);

/// A house of storeys with windows, a flat roof with a parapet and a gabled wing.
Scene House();

/// House with a sketch on it: a hidden and a visible suggestion, lifted lines and ink.
Scene HouseWithSketch(const Camera& camera);

/// From the south-east, a little above the roof.
Camera HouseCamera(double width_px, double height_px);

/// n x n x storeys boxes side by side.
Scene Town(int n, int storeys);

/// The colour of a pixel, rows from the top.
glm::ivec3 PixelAt(const Image& image, int x, int y);

}  // namespace parti::render::tests
