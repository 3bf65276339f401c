// A finished picture of the model, as the painter hands it to whoever shows it and asks what is
// where. How it came about is ScenePainter's.
#pragma once

#include <memory>
#include <vector>

#include "render/canvas.h"

namespace parti::render {

/// Destroyed on any thread; its texture then serves for another.
struct PaintedPicture {
  GLuint texture = 0;        ///< GL_SRGB8_ALPHA8, rows from the bottom; shared with the painter
  glm::ivec2 size_px{0, 0};  ///< smaller than the camera's where it is coarse
  std::shared_ptr<const Scene> scene;
  Camera camera;
  bool coarse = false;
  std::vector<uint32_t> ids;         ///< Faces::id for each pixel, rows from the top; 0: none
  PictureCells cells;                ///< what it looks like, in short
  int uploads = 0;                   ///< of scenes by this painter so far
  std::shared_ptr<const void> slot;  ///< keeps the texture from being drawn over

  /// The id at a pixel of the camera's view; 0 where there is no face, and outside.
  uint32_t IdAt(const Vec2& px) const;
};

/// As a canvas shows it through the camera it was painted for, or through one that has moved since
/// (see PictureFromMoved); one that isn't valid moves nothing.
CanvasPicture ToCanvas(const std::shared_ptr<const PaintedPicture>& picture);
CanvasPicture ToCanvas(const std::shared_ptr<const PaintedPicture>& picture, const Camera& now);

/// Numbers of how pictures are painted.
struct PainterParams {
  /// Pictures are drawn in squares of this side [px], a multiple of PictureCells::kSide_px, each
  /// finished before the next: a newer request waits for one at most, and so does the pen where all
  /// contexts share a rasteriser (llvmpipe).
  int tile_side_px = 256;
  int coarse_divisor = 2;  ///< of width and height of coarse pictures
  /// A fine picture is begun when no request has come for this long [s] after a coarse one.
  double rest_s = 0.1;
};

}  // namespace parti::render
