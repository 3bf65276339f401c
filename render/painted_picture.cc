#include "render/painted_picture.h"

#include <cmath>

#include "render/reproject.h"

namespace parti::render {

uint32_t PaintedPicture::IdAt(const Vec2& px) const {
  const double x = std::floor(px.x * size_px.x / camera.width_px);
  const double y = std::floor(px.y * size_px.y / camera.height_px);
  // NaN fails every comparison.
  if (!(x >= 0 && y >= 0 && x < size_px.x && y < size_px.y)) return 0;
  const size_t at = static_cast<size_t>(y) * size_px.x + static_cast<size_t>(x);
  return at < ids.size() ? ids[at] : 0;
}

CanvasPicture ToCanvas(const std::shared_ptr<const PaintedPicture>& picture) {
  CanvasPicture shown;
  shown.texture = picture->texture;
  shown.size_px = picture->size_px;
  shown.view_px = PictureSize(picture->camera);
  shown.cells = picture->cells;
  shown.keep = picture;
  return shown;
}

CanvasPicture ToCanvas(const std::shared_ptr<const PaintedPicture>& picture, const Camera& now) {
  CanvasPicture shown = ToCanvas(picture);
  if (Validate(now)) shown.picture_from_canvas = PictureFromMoved(picture->camera, now);
  return shown;
}

}  // namespace parti::render
