// Every number of how a picture looks: light, paper, grid, depth. All colours of light are linear
// factors, all colours of things sRGB.
#pragma once

#include "render/scene.h"

namespace parti::render {

/// The defaults were chosen by looking at houses and towns from all sides at 800 and 1600 px.
struct Look {
  /// The sun stands in the south-west (x west of the building is negative, south is +z), 43 degrees
  /// high: a drawing's usual light from the left, and shadows that don't move with the eye.
  Vec3f to_sun{-0.55f, 0.75f, 0.60f};
  Vec3f sun_light{0.90f, 0.86f, 0.78f};
  /// Light from the other side keeps faces in the shade apart from each other.
  Vec3f to_fill{0.85f, 0.20f, 0.45f};
  Vec3f fill_light{0.14f, 0.138f, 0.14f};
  Vec3f sky_light{0.43f, 0.44f, 0.455f};
  Vec3f ground_light{0.33f, 0.31f, 0.285f};
  Vec2f base_shade{0.10f, 1.5f};  ///< darkening at the foot of the scene, and its height [m]

  Vec3f paper_low{0.953f, 0.941f, 0.918f};
  Vec3f paper_high{0.984f, 0.980f, 0.969f};
  Vec3f grid_ink{0.55f, 0.53f, 0.50f};
  Vec3f grid_strength{0.16f, 0.34f, 0.42f};  ///< of lines every 1, 10 and 100 m
  Vec3f shadow_ink{0.66f, 0.665f, 0.69f};    ///< what is left of the paper in the shadow
  float ground_full = 1.3f;                  ///< the grid is full within this many scene radii,
  float ground_none = 4.0f;                  ///< and gone beyond this many
  float least_ground_m = 8;                  ///< the radius of scenes smaller than this

  int shadow_side = 2048;           ///< texels
  float shadow_bias_texels = 2.0f;  ///< along the normal, against a face's shadow on itself

  float line_pull = 2e-4f;         ///< lines are drawn nearer by this part of their distance,
  float face_slope_offset = 1.5f;  ///< and faces farther by this many pixels' worth of slope
  float face_offset_units = 2;     ///< and this many of the least depth steps
  float back_push = 3e-4f;         ///< faces seen from behind yield by this part of the distance,
  float layer_push = 1e-5f;       ///< and faces in one plane by this times their place in 16 layers
  float full_spacing_px = 6;      ///< lines are full where so many pixels lie between them,
  float full_line_px = 200;       ///< or where they are so long; others are fainter in proportion,
  float faintest_line = 0.12f;    ///< down to this part of their color
  float hidden_strength = 0.22f;  ///< of on_top lines where they are hidden
  int samples = 4;                ///< a pixel
};

}  // namespace parti::render
