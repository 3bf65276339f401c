// Strokes drawn on the ground for tests: recorded gestures laid out in metres and seen by a camera.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session_state.h"

namespace parti::app {

/// A recorded gesture in its own coordinates.
struct Gesture {
  std::string id;
  std::string name;  ///< its class: "rectangle", "circle" …
  Stroke stroke;
};

/// Gestures of these classes; a bad line fails the test.
std::vector<Gesture> ReadGestures(const std::string& path, const std::vector<std::string>& names);

/// A stroke that lies on the ground (x right, y towards the south; m), as the camera sees it.
/// Every point must be seen.
std::shared_ptr<const DrawnStroke> SeenFrom(const Camera& camera, const Stroke& on_ground_m);

/// The stroke moved and scaled so that its bounding box lies in a square of `size_m` about the
/// origin.
Stroke LaidOut(const Stroke& stroke, double size_m);

/// The corners of "poly(x,z x,z …)"; other texts fail the test.
std::vector<Vec2> CornersOf(const std::string& lot);

/// Area of the common part of two simple polygons by that of their union, sampled.
double Overlap(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

/// A three-quarter view on the ground about the origin, as a new drawing has it.
Camera GroundView();

}  // namespace parti::app
