// Real façades: every annotated rectangle, each kind of element in a layer of its own, is as large
// after the normalisation as what the others leave of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/grammar/layers/scene_support.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

constexpr double kWidth_m = 20;
/// From the wall outward.
constexpr std::array<std::string_view, 10> kLayers = {
    "molding", "pillar", "cornice", "shop", "deco", "window", "sill", "blind", "balcony", "door"};

struct Element {
  size_t layer;
  Box2 box;
};

struct AnnotatedFacade {
  std::string id;
  Box2 wall;
  std::vector<Element> elements;
};

AnnotatedFacade FacadeFrom(const nlohmann::json& json) {
  AnnotatedFacade facade{json.at("id"), {}, {}};
  double largest = 0;
  for (const auto& e : json.at("elements")) {
    const Vec2 low(e.at("x0"), e.at("y0")), high(e.at("x1"), e.at("y1"));
    const Box2 box{low * kWidth_m, high * kWidth_m};
    const std::string label = e.at("label");
    const double area = (high.x - low.x) * (high.y - low.y);
    if (label == "facade" && area > largest) {
      facade.wall = box;
      largest = area;
    }
    const auto layer = std::find(kLayers.begin(), kLayers.end(), label) - kLayers.begin();
    if (label != "facade") facade.elements.push_back({static_cast<size_t>(layer), box});
  }
  return facade;
}

std::vector<double> Cuts(const AnnotatedFacade& facade, int axis) {
  std::vector<double> cuts = {facade.wall.low[axis], facade.wall.high[axis]};
  for (const Element& e : facade.elements) {
    for (const double at : {e.box.low[axis], e.box.high[axis]}) {
      cuts.push_back(std::clamp(at, facade.wall.low[axis], facade.wall.high[axis]));
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

bool Holds(const Box2& box, const Vec2& p) {
  return p.x > box.low.x && p.y > box.low.y && p.x < box.high.x && p.y < box.high.y;
}

/// The visible area of each element, and of the wall at the end, by counting the cells between all
/// borders: slow, and with nothing to go wrong.
std::vector<double> VisibleAreas(const AnnotatedFacade& facade) {
  std::vector<double> areas(facade.elements.size() + 1, 0.0);
  const std::vector<double> xs = Cuts(facade, 0), ys = Cuts(facade, 1);
  for (size_t i = 0; i + 1 < xs.size(); ++i) {
    for (size_t j = 0; j + 1 < ys.size(); ++j) {
      const Vec2 middle((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2);
      size_t top = facade.elements.size();
      for (size_t k = 0; k < facade.elements.size(); ++k) {
        if (!Holds(facade.elements[k].box, middle)) continue;
        const bool over =
            top == facade.elements.size() || facade.elements[k].layer >= facade.elements[top].layer;
        if (over) top = k;
      }
      areas[top] += (xs[i + 1] - xs[i]) * (ys[j + 1] - ys[j]);
    }
  }
  return areas;
}

TEST(RealFacades, EveryElementKeepsWhatTheOthersLeave) {
  PARTI_NEED_DATA(path, "facades/cmp-dev.jsonl");
  std::ifstream file(path);
  size_t facades = 0, elements = 0, cut = 0;
  for (std::string line; std::getline(file, line); ++facades) {
    const AnnotatedFacade facade = FacadeFrom(nlohmann::json::parse(line));
    const Vec2 size = facade.wall.high - facade.wall.low;
    TestScene scene(size.x, size.y);
    const auto layers = scene.Layers(
        R"(layers("a", "b", "c", "d", "e", "f", "g", "h", "i", "j") {A|B|C|D|E|F|G|H|I|J})");
    for (const Element& e : facade.elements) {
      scene.Add(layers[e.layer], e.box.low - facade.wall.low, e.box.high - facade.wall.low);
    }
    const auto pieces = scene.Normalise();
    const std::vector<double> expected = VisibleAreas(facade);
    ASSERT_EQ(pieces.size(), facade.elements.size()) << facade.id;
    for (size_t k = 0; k < pieces.size(); ++k) {
      double area = 0;
      for (const ShapeIndex i : pieces[k]) area += AreaOf(scene[i]);
      EXPECT_NEAR(area, expected[k], 1e-6) << facade.id << ", element " << k;
      ++elements;
      const Box2& box = facade.elements[k].box;
      cut += area < (box.high.x - box.low.x) * (box.high.y - box.low.y) - 1e-6 ? 1 : 0;
    }
    EXPECT_NEAR(scene.UncoveredArea(), expected.back(), 1e-6) << facade.id;
  }
  EXPECT_EQ(facades, 63u);
  std::printf("%zu facades, %zu elements, %zu of them cut\n", facades, elements, cut);
}

}  // namespace
}  // namespace parti::grammar::tests
