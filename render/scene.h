// What render draws: values only, in the world or on the picture; float, as the GPU wants them.
// Knows nothing of grammars and strokes: app turns shapes and sketches into this.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "render/image.h"

namespace parti::render {

using Vec2f = glm::vec2;
using Vec3f = glm::vec3;
using Vec4f = glm::vec4;

/// A flat-shaded face set with one colour: corners three by three, counter-clockwise from outside.
/// Open sets are seen from both sides.
struct Faces {
  std::vector<Vec3f> corners;
  Vec3f color{0.93f, 0.92f, 0.90f};  ///< sRGB
  uint32_t id = 0;                   ///< for picking; 0: not pickable
  bool closed = false;  ///< a watertight body: its back sides, never seen, are not drawn
  /// It touches the back of a face that hides it; where the two meet in one line, that face wins.
  bool yields = false;
  /// A PNG or JPEG as its file holds it, multiplied by `color` and repeated without end. Null, or
  /// not to be read: `color` alone.
  std::shared_ptr<const std::string> image = nullptr;
  /// One a corner where there is an image, (0, 0) its lower left corner, (1, 1) its upper right;
  /// those that are missing or not finite are (0, 0).
  std::vector<Vec2f> uvs = {};
};

/// Straight lines in the world, hidden by what lies in front of them unless `on_top`.
struct Lines {
  std::vector<Vec3f> ends;               ///< two by two
  Vec4f color{0.1f, 0.1f, 0.12f, 1.0f};  ///< sRGB, alpha
  float width_px = 1.5f;
  float dash_px = 0;  ///< 0: solid
  bool on_top = false;
  /// Where faces lie before all of these lines, in their planes: the unit normal of those faces. An
  /// eye on the side that it points to does not see the lines. 0: there are none.
  Vec3f behind{0, 0, 0};
  /// How far apart they lie on their faces. Where that is few pixels they are fainter (Look), as in
  /// a building seen from afar. 0: never.
  float spacing_m = 0;
};

/// Ink on the picture, in pixels: a polyline with a width at each point, round ends and joints.
struct Ink {
  std::vector<Vec2f> points;
  std::vector<float> widths_px;  ///< as many as points
  Vec4f color{0.05f, 0.1f, 0.45f, 1.0f};
};

/// Drawn in this order: ground, faces, lines, lines on top, ink.
struct Scene {
  std::vector<Faces> faces;
  std::vector<Lines> lines;
  std::vector<Ink> ink;
  bool ground = true;  ///< paper, a faint metre grid and the building's shadow on y = 0
};

}  // namespace parti::render
