#include "tests/app/ground_strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/json.h"
#include "grammar/polygon.h"

namespace parti::app {
namespace {

struct Box {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void Add(const Vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

}  // namespace

std::vector<Gesture> ReadGestures(const std::string& path, const std::vector<std::string>& names) {
  std::vector<Gesture> gestures;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    const auto json = ParseJson(line, path);
    const auto stroke = StrokeFrom(json ? (*json)["points"] : Json(), "points");
    if (!json || !stroke) {
      ADD_FAILURE() << path << ": " << line.substr(0, 60);
      continue;
    }
    const std::string name = json->value("class", "");
    if (std::find(names.begin(), names.end(), name) == names.end()) continue;
    gestures.push_back({(*json)["id"], name, *stroke});
  }
  return gestures;
}

std::shared_ptr<const DrawnStroke> SeenFrom(const Camera& camera, const Stroke& on_ground_m) {
  const View view(camera);
  Stroke seen = on_ground_m;
  for (StrokeSample& sample : seen) {
    const auto px = view.Project(Vec3(sample.position.x, 0, sample.position.y));
    EXPECT_TRUE(px) << "the camera does not see this point";
    sample.position = px.value_or(Vec2(0));
  }
  return std::make_shared<const DrawnStroke>(DrawnStroke{std::move(seen), camera});
}

Stroke LaidOut(const Stroke& stroke, double size_m) {
  Box box;
  for (const StrokeSample& sample : stroke) box.Add(sample.position);
  const Vec2 size = box.high - box.low;
  const double scale = size_m / std::max(size.x, size.y);
  Stroke laid = stroke;
  for (StrokeSample& sample : laid) {
    sample.position = (sample.position - (box.low + box.high) * 0.5) * scale;
  }
  return laid;
}

std::vector<Vec2> CornersOf(const std::string& lot) {
  std::vector<Vec2> corners;
  std::string numbers = lot;
  EXPECT_EQ(lot.substr(0, 5), "poly(") << lot;
  for (char& c : numbers) {
    if (std::string_view("poly(),").find(c) != std::string_view::npos) c = ' ';
  }
  std::istringstream in(numbers);
  for (Vec2 p; in >> p.x >> p.y;) corners.push_back(p);
  return corners;
}

double Overlap(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  constexpr int kSteps = 36;
  Box box;
  for (const auto* ring : {&a, &b}) {
    for (const Vec2& p : *ring) box.Add(p);
  }
  int common = 0, all = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const Vec2 p = box.low + (box.high - box.low) * (Vec2(i + 0.5, j + 0.5) / (1.0 * kSteps));
      const bool in_a = grammar::Contains({a, {}}, p), in_b = grammar::Contains({b, {}}, p);
      common += in_a && in_b;
      all += in_a || in_b;
    }
  }
  return all > 0 ? static_cast<double>(common) / all : 0;
}

Camera GroundView() {
  Camera camera;
  camera.eye = {18, 26, 40};
  camera.target = {0, 0, 0};
  camera.vertical_fov = Angle::Degrees(40);
  return camera;
}

}  // namespace parti::app
