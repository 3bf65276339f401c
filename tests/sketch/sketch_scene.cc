#include "tests/sketch/sketch_scene.h"

namespace parti::tests {
namespace {

Vec3 TurnedAboutY(const Vec3& v, Angle angle) {
  const double c = std::cos(angle.radians()), s = std::sin(angle.radians());
  return {c * v.x + s * v.z, v.y, c * v.z - s * v.x};
}

void DrawLine(const Vec2& a, const Vec2& b, Stroke* stroke) {
  constexpr double kStep_px = 8, kSecondsPerPixel = 0.0012;
  const double length = glm::distance(a, b);
  const int steps = std::max(1, static_cast<int>(length / kStep_px));
  double t = stroke->empty() ? 0 : stroke->back().t_s;
  for (int i = stroke->empty() ? 0 : 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    // Slow at both ends, as hands are: the smooth step of a minimum-jerk movement.
    const double eased = share * share * share * (share * (share * 6 - 15) + 10);
    const double place = 0.15 * share + 0.85 * eased;
    stroke->push_back({a + (b - a) * place, t + share * length * kSecondsPerPixel});
  }
}

}  // namespace

grammar::Item Face(const Vec3& origin, const Vec3& x, const Vec3& normal, double width,
                   double height) {
  grammar::Item item;
  item.type = grammar::ItemType::kPlanar;
  item.scope.origin = origin;
  item.scope.x = glm::normalize(x);
  item.scope.z = glm::normalize(normal);
  item.scope.y = glm::cross(item.scope.z, item.scope.x);
  item.scope.size = Vec3(width, height, 0);
  item.facing = item.scope.z;
  return item;
}

grammar::Item Lot() { return Face({-10, 0, 6}, {1, 0, 0}, {0, 1, 0}, 20, 12); }

grammar::Item Facade() { return Face({-8, 0, 0}, {1, 0, 0}, {0, 0, 1}, 16, 9); }

grammar::Item Box() {
  grammar::Item item;
  item.type = grammar::ItemType::kVolume;
  item.scope.size = Vec3(10, 6, 8);
  return item;
}

Camera HouseCamera() {
  Camera camera;
  camera.eye = Vec3(16, 17, 30);
  camera.target = Vec3(0, 3, 0);
  return camera;
}

Vec3 At(const grammar::Item& item, double x, double y, double height) {
  return item.scope.ToWorld(Vec3(x, y, height));
}

Stroke Draw(const std::vector<Vec3>& corners, const Camera& camera, double noise_px,
            uint64_t seed) {
  const View view(camera);
  Random random(seed);
  std::vector<Vec2> pixels;
  for (const Vec3& corner : corners) {
    const Vec2 off(random.Normal(), random.Normal());
    pixels.push_back(view.Project(corner).value() + off * noise_px);
  }
  Stroke stroke;
  for (size_t i = 0; i + 1 < pixels.size(); ++i) DrawLine(pixels[i], pixels[i + 1], &stroke);
  return stroke;
}

sketch::Configuration Drawn(const std::vector<Segment3>& lines, const Camera& camera) {
  sketch::Configuration configuration;
  for (const Segment3& line : lines) {
    configuration.lines.push_back(sketch::DrawnPerfectly(line, camera));
  }
  return configuration;
}

grammar::Item Turned(const grammar::Item& item, Angle angle) {
  grammar::Item turned = item;
  turned.scope.origin = TurnedAboutY(item.scope.origin, angle);
  turned.scope.x = TurnedAboutY(item.scope.x, angle);
  turned.scope.y = TurnedAboutY(item.scope.y, angle);
  turned.scope.z = TurnedAboutY(item.scope.z, angle);
  turned.facing = TurnedAboutY(item.facing, angle);
  return turned;
}

Camera Turned(Camera camera, Angle angle) {
  camera.eye = TurnedAboutY(camera.eye, angle);
  camera.target = TurnedAboutY(camera.target, angle);
  camera.up = TurnedAboutY(camera.up, angle);
  return camera;
}

}  // namespace parti::tests
