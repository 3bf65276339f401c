// Golden pictures: tests/golden/NAME.png, or those of a document, compared with what was drawn.
// Any kind of picture; drawing them is their tests'.
#pragma once

#include <string>

#include "render/image.h"

namespace parti::tests {

/// What still counts as the same picture. OSMesa and EGL, and one Mesa and the next, differ in how
/// they round colours and cover edges: thinly, along lines. A shape that moved or vanished differs
/// in far more pixels, another word in many of those where it stands.
struct GoldenTolerance {
  int channel = 24;         ///< a pixel differs when a channel is off by more, of 255
  double fraction = 0.004;  ///< of the pixels may differ
  double crowd = 0.2;       ///< of the pixels of any square of kCrowd_px may differ
};
constexpr int kCrowd_px = 16;

/// How two pictures differ.
struct PictureDifference {
  bool same_size = false;
  size_t pixels = 0;     ///< that differ
  size_t crowd = 0;      ///< that differ in the square where most do; squares from the top left
  render::Image marked;  ///< the first picture, pale, with what differs in red
};

/// Pictures of different sizes are not compared further.
PictureDifference Compare(const render::Image& made, const render::Image& golden,
                          const GoldenTolerance& tolerance = {});

/// Fails the running test, and writes NAME.out.png and NAME.diff.png beside the golden picture,
/// when more pixels differ than allowed or there is no golden picture. With PARTI_UPDATE_GOLDEN=1
/// in the environment the golden picture is written instead: look at it before committing it.
void ExpectGolden(const render::Image& image, const std::string& name,
                  const GoldenTolerance& tolerance = {});
/// The same for PATH.png of the project, "docs/operations/extrude".
void ExpectPicture(const render::Image& image, const std::string& path,
                   const GoldenTolerance& tolerance = {});

}  // namespace parti::tests
