#include "render/reproject.h"

#include <cmath>

namespace parti::render {
namespace {

double FocalPx(const Camera& camera) {
  return camera.height_px * 0.5 / std::tan(camera.vertical_fov.radians() * 0.5);
}

/// World directions from pixels.
glm::dmat3 DirectionFromPixel(const View& view) {
  const Camera& camera = view.camera();
  const double focal = FocalPx(camera);
  return {view.right() / focal, -view.up() / focal,
          view.forward() - view.right() * (camera.width_px * 0.5 / focal) +
              view.up() * (camera.height_px * 0.5 / focal)};
}

}  // namespace

glm::dmat3 PictureFromMoved(const Camera& from, const Camera& to) {
  if (from == to) return glm::dmat3(1);
  const View seen_from(from), seen_to(to);
  const Vec3 normal = seen_to.forward();
  const double away = glm::dot(normal, to.target - to.eye);
  // The ray along d meets the plane at eye + d * away / (normal . d); times (normal . d), and from
  // the other eye, that is linear in d.
  const glm::dmat3 from_eye = glm::outerProduct(to.eye - from.eye, normal) + glm::dmat3(away);
  const glm::dmat3 picture =
      glm::inverse(DirectionFromPixel(seen_from)) * from_eye * DirectionFromPixel(seen_to);
  return picture / away;
}

}  // namespace parti::render
