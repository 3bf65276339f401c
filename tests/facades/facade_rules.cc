#include "tests/facades/facade_rules.h"

#include <fmt/format.h>

#include <array>

#include "grammar/lexer.h"

namespace parti::tests {
namespace {

using grammar::Box2;
using grammar::NumberText;

constexpr std::array<LabelLayer, 10> kLayers = {{
    {"pillar", "pillars", "Pillar", R"(color("#e6dcc8") extrude(0.12))"},
    {"molding", "moldings", "Molding", R"(color("#ebe3d3") extrude(0.06))"},
    {"deco", "ornaments", "Ornament", R"(color("#cdb08c") extrude(0.1))"},
    {"shop", "shops", "Shop", R"(color("#5b6f78") extrude(-0.2))"},
    {"window", "windows", "Window", R"(color("#8aa3b8") extrude(-0.18))"},
    {"door", "doors", "Door", R"(color("#6b4c3a") extrude(-0.3))"},
    {"blind", "blinds", "Blind", R"(color("#9a7a5f") extrude(-0.06))"},
    {"sill", "sills", "Sill", R"(color("#f1ebdd") extrude(0.16))"},
    {"cornice", "cornices", "Cornice", R"(color("#d4c4a5") extrude(0.28))"},
    {"balcony", "balconies", "Balcony", R"(color("#777d82") extrude(0.7))"},
}};

/// A box in the coordinates of a wall.
Box2 Within(const Box2& wall, const Box2& box) { return {box.low - wall.low, box.high - wall.low}; }

bool IsInside(const Box2& box, const Vec2& size) {
  return box.low.x >= 0 && box.low.y >= 0 && box.high.x <= size.x && box.high.y <= size.y;
}

/// A rectangle as a closed path in parts of the shape that it is drawn in.
std::string PathOf(const Box2& box, const Vec2& size) {
  const Vec2 low = box.low / size, high = box.high / size;
  return fmt::format("M{} {} H{} V{} H{} Z", low.x, low.y, high.x, high.y, low.x);
}

/// "WindowAt(1.2, 3.4, 0.9, 1.5)", or a path for what reaches over the wall's border.
std::string PlacedText(const LabelLayer& layer, const Box2& box, const Vec2& size) {
  if (!IsInside(box, size)) {
    return fmt::format("{}Outline(\"{}\")", layer.symbol, PathOf(box, size));
  }
  const Vec2 extent = box.high - box.low;
  return fmt::format("{}At({}, {}, {}, {})", layer.symbol, NumberText(box.low.x),
                     NumberText(box.low.y), NumberText(extent.x), NumberText(extent.y));
}

/// The rule of one layer of one wall: its elements, one a line.
std::string LayerRule(const AnnotatedFacade& facade, const Box2& wall, const LabelLayer& layer,
                      const std::string& name) {
  std::string text = fmt::format("{} -->", name);
  for (const Annotation& element : facade.elements) {
    if (&kLayers.at(LayerOf(element.label)) != &layer) continue;
    text += "\n  " + PlacedText(layer, Within(wall, element.box), wall.high - wall.low);
  }
  return text + "\n";
}

bool Has(const AnnotatedFacade& facade, const LabelLayer& layer) {
  for (const Annotation& element : facade.elements) {
    if (&kLayers.at(LayerOf(element.label)) == &layer) return true;
  }
  return false;
}

/// "layers("a", "b") { A | B }"
class LayersText {
 public:
  void Add(const std::string& name, const std::string& symbol) {
    names_ += fmt::format("{}\"{}\"", names_.empty() ? "" : ", ", name);
    symbols_ += fmt::format("{}{}", symbols_.empty() ? "" : " | ", symbol);
  }
  std::string Text() const { return fmt::format("layers({}) {{ {} }}", names_, symbols_); }

 private:
  std::string names_, symbols_;
};

std::string WallRules(const AnnotatedFacade& facade, size_t number) {
  const Box2& wall = facade.walls[number];
  LayersText layers;
  std::string rules;
  for (const LabelLayer& layer : kLayers) {
    if (!Has(facade, layer)) continue;
    const std::string name = fmt::format("{}s{}", layer.symbol, number + 1);
    layers.Add(std::string(layer.layer), name);
    rules += LayerRule(facade, wall, layer, name);
  }
  const std::string body = rules.empty() ? std::string("color(\"#d9cbb0\")") : layers.Text();
  return fmt::format("Facade{} --> color(\"#d9cbb0\") {}\n{}", number + 1, body, rules);
}

/// The rules of a kind of element that `placed`, the rules of the layers, ask for.
std::string KindRules(const LabelLayer& layer, const std::string& placed, bool finished) {
  std::string text;
  if (placed.find(fmt::format(" {}At(", layer.symbol)) != std::string::npos) {
    text += fmt::format(
        "{0}At(left, bottom, width, height) -->\n"
        "  segment(x, left, width, ~1) {{\n"
        "    NIL | segment(y, bottom, height, ~1) {{ NIL | {0} | NIL }} | NIL\n"
        "  }}\n",
        layer.symbol);
  }
  if (placed.find(fmt::format(" {}Outline(", layer.symbol)) != std::string::npos) {
    text += fmt::format("{0}Outline(path) --> vectorial(path) {0}\n", layer.symbol);
  }
  if (finished) {
    text += fmt::format("{0} --> set_property(\"fixed_geometry\", false) {1} {0}Body\n",
                        layer.symbol, layer.finish);
  }
  return text;
}

}  // namespace

std::span<const LabelLayer> LabelLayers() { return kLayers; }

size_t LayerOf(std::string_view label) {
  for (size_t i = 0; i < kLayers.size(); ++i) {
    if (kLayers.at(i).label == label) return i;
  }
  return kLayers.size() - 1;
}

std::string RulesOf(const AnnotatedFacade& facade, bool finished) {
  std::string text = fmt::format("// {}: {} elements on {} wall(s)\n", facade.id,
                                 facade.elements.size(), facade.walls.size());
  text += fmt::format("Lot --> extrude({}) comp(f) {{ front: Sheet | all: NIL }}\n",
                      NumberText(facade.size_m.y));
  LayersText walls;
  std::string rules;
  for (size_t i = 0; i < facade.walls.size(); ++i) {
    walls.Add(fmt::format("wall {}", i + 1), fmt::format("Wall{}", i + 1));
    rules += fmt::format("Wall{0} --> vectorial(\"{1}\") Facade{0}\n", i + 1,
                         PathOf(facade.walls[i], facade.size_m));
    rules += WallRules(facade, i);
  }
  text += fmt::format("Sheet --> color(\"#f4f2ec\") {}\n", walls.Text()) + rules;
  for (const LabelLayer& layer : kLayers) {
    if (Has(facade, layer)) text += KindRules(layer, rules, finished);
  }
  return text;
}

std::string LotOf(const AnnotatedFacade& facade) {
  return fmt::format("rect({},1)", NumberText(facade.size_m.x));
}

}  // namespace parti::tests
