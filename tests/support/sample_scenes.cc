#include "tests/support/sample_scenes.h"

#include <array>
#include <cmath>

namespace parti::render::tests {
namespace {

constexpr Vec3f kGlass{0.62f, 0.70f, 0.76f};
constexpr Vec3f kRoof{0.80f, 0.62f, 0.52f};
constexpr Vec4f kAccent{0.85f, 0.30f, 0.10f, 1};

void AddQuad(Faces* faces, const Vec3f& a, const Vec3f& b, const Vec3f& c, const Vec3f& d) {
  for (const Vec3f& p : {a, b, c, a, c, d}) faces->corners.push_back(p);
}

void AddWindows(Scene* scene, float y) {
  for (int i = 0; i < 4; ++i) {
    const float x = 1.0f + 2.75f * static_cast<float>(i);
    AddBox(scene, {x, y + 0.8f, 8.0f}, {x + 1.6f, y + 2.4f, 8.06f}, 100, kGlass);
  }
  for (int i = 0; i < 2; ++i) {
    const float z = 1.2f + 3.6f * static_cast<float>(i);
    AddBox(scene, {12.0f, y + 0.8f, z}, {12.06f, y + 2.4f, z + 2.0f}, 101, kGlass);
  }
}

/// A gabled prism along z over [low, high], its eaves at low.y and its ridge at high.y.
void AddGable(Scene* scene, const Vec3f& low, const Vec3f& high, uint32_t id) {
  const float middle = 0.5f * (low.x + high.x);
  const Vec3f a{low.x, low.y, high.z}, b{high.x, low.y, high.z}, top{middle, high.y, high.z};
  const Vec3f c{low.x, low.y, low.z}, d{high.x, low.y, low.z}, back{middle, high.y, low.z};
  Faces walls{{a, b, top, d, c, back}, Faces{}.color, id};
  Faces roof{{}, kRoof, id};
  AddQuad(&roof, b, d, back, top);
  AddQuad(&roof, c, a, top, back);
  scene->faces.push_back(walls);
  scene->faces.push_back(roof);
  scene->lines.push_back({{a, top, top, b, c, back, back, d, top, back, a, c, b, d, a, b, c, d}});
}

}  // namespace

void AddBox(Scene* scene, const Vec3f& low, const Vec3f& high, uint32_t id, const Vec3f& color) {
  std::array<Vec3f, 8> p;
  for (int i = 0; i < 8; ++i) {
    p[i] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z};
  }
  Faces faces{{}, color, id, true};
  AddQuad(&faces, p[4], p[5], p[7], p[6]);  // south
  AddQuad(&faces, p[1], p[0], p[2], p[3]);  // north
  AddQuad(&faces, p[5], p[1], p[3], p[7]);  // east
  AddQuad(&faces, p[0], p[4], p[6], p[2]);  // west
  AddQuad(&faces, p[6], p[7], p[3], p[2]);  // top
  AddQuad(&faces, p[0], p[1], p[5], p[4]);  // bottom
  scene->faces.push_back(faces);
  Lines edges;
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) {
      if (!(i & bit)) edges.ends.insert(edges.ends.end(), {p[i], p[i | bit]});
    }
  }
  scene->lines.push_back(edges);
}

Scene House() {
  Scene scene;
  AddBox(&scene, {0, 0, 0}, {12, 3.6f, 8}, 1);
  AddBox(&scene, {0, 3.6f, 0}, {12, 6.8f, 8}, 2);
  AddBox(&scene, {0, 6.8f, 0}, {12, 10, 8}, 3);
  AddBox(&scene, {1, 10, 1}, {9, 12.4f, 7}, 4, kRoof);
  for (const float y : {0.2f, 3.6f, 6.8f}) AddWindows(&scene, y);
  AddBox(&scene, {-6, 0, 2}, {0, 3, 8}, 5);
  AddGable(&scene, {-6, 3, 2}, {0, 5.4f, 8}, 6);
  Faces lot{{}, {0.90f, 0.91f, 0.86f}, 7};
  AddQuad(&lot, {-8, 0, 11}, {15, 0, 11}, {15, 0, -3}, {-8, 0, -3});
  scene.faces.push_back(lot);
  scene.lines.push_back({{{-8, 0, 11},
                          {15, 0, 11},
                          {15, 0, 11},
                          {15, 0, -3},
                          {15, 0, -3},
                          {-8, 0, -3},
                          {-8, 0, -3},
                          {-8, 0, 11}}});
  return scene;
}

Camera HouseCamera(double width_px, double height_px) {
  Camera camera;
  camera.eye = {34, 19, 40};
  camera.target = {4.2, 5.2, 4};
  camera.vertical_fov = Angle::Degrees(32);
  camera.width_px = width_px;
  camera.height_px = height_px;
  return camera;
}

Scene HouseWithSketch(const Camera& camera) {
  Scene scene = House();
  Scene box;
  AddBox(&box, {0, 10, 0}, {12, 14.5f, 8}, 0);
  Lines suggestion = box.lines[0];
  suggestion.color = kAccent;
  suggestion.width_px = 2.2f;
  suggestion.dash_px = 7;
  suggestion.on_top = true;
  scene.lines.push_back(suggestion);
  scene.lines.push_back({{{0, 10, 8}, {0, 14.5f, 8}, {0, 14.5f, 8}, {12, 14.5f, 8}},
                         {0.1f, 0.35f, 0.8f, 1},
                         2.6f,
                         0,
                         true});
  const View view(camera);
  Ink ink;
  for (int i = 0; i <= 60; ++i) {
    const double t = i / 60.0;
    const Vec3 on_line =
        t < 0.4 ? Vec3(0, 10 + 4.5 * t / 0.4, 8) : Vec3(12 * (t - 0.4) / 0.6, 14.5, 8);
    const Vec2 wobble(2.0 * std::sin(9 * t), 2.5 * std::sin(14 * t + 1));
    ink.points.emplace_back(*view.Project(on_line) + wobble);
    ink.widths_px.push_back(static_cast<float>(1.5 + 3.5 * std::sin(kPi * t)));
  }
  scene.ink.push_back(ink);
  return scene;
}

Scene Town(int n, int storeys) {
  Scene scene;
  for (int i = 0; i < n * n; ++i) {
    const auto column = i % n, row = i / n;
    const float x = 6.0f * static_cast<float>(column), z = 6.0f * static_cast<float>(row);
    const int high = 1 + (i * 7 + i / n * 3) % (2 * storeys - 1);  // storeys on average
    for (int s = 0; s < high; ++s) {
      const float y = 3.0f * static_cast<float>(s);
      AddBox(&scene, {x, y, z}, {x + 5, y + 3, z + 5},
             static_cast<uint32_t>(scene.faces.size() + 1));
    }
  }
  return scene;
}

glm::ivec3 PixelAt(const Image& image, int x, int y) {
  const uint8_t* p = &image.pixels[(size_t{4} * image.width * y) + size_t{4} * x];
  return {p[0], p[1], p[2]};
}

}  // namespace parti::render::tests
