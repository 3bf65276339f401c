#include "tests/facades/annotated_facade.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

#include "base/json.h"
#include "base/text_file.h"

namespace parti::tests {
namespace {

using grammar::Box2;

constexpr const char* kWall = "facade";
constexpr int kFewestPixels = 100, kMostPixels = 4000;
constexpr double kRounding = 1.01e-5;  // of coordinates that are written with five digits

struct Marked {
  std::string label;
  Box2 unit;  // of the photograph
};

Result<Marked> MarkedFrom(const Json& json) {
  Marked marked;
  marked.label = json.value("label", std::string());
  double* const values[] = {&marked.unit.low.x, &marked.unit.high.x, &marked.unit.low.y,
                            &marked.unit.high.y};
  const char* const names[] = {"x0", "x1", "y0", "y1"};
  for (int i = 0; i < 4; ++i) {
    const auto number = NumberFrom(json.value(names[i], Json()), names[i]);
    if (!number) return Fail(number);
    *values[i] = *number;
  }
  return marked;
}

/// The fewest pixels along an axis such that every coordinate is a whole number of them.
int PixelsAlong(const std::vector<Marked>& all, int axis) {
  const auto fits = [](double value, int pixels) {
    const double at = value * pixels;
    return std::abs(at - std::round(at)) <= pixels * kRounding;
  };
  for (int pixels = kFewestPixels; pixels < kMostPixels; ++pixels) {
    bool good = true;
    for (const Marked& m : all) {
      good = good && fits(m.unit.low[axis], pixels) && fits(m.unit.high[axis], pixels);
    }
    if (good) return pixels;
  }
  return kMostPixels;
}

Result<AnnotatedFacade> FacadeFrom(const Json& json) {
  AnnotatedFacade facade;
  facade.id = json.value("id", std::string());
  std::vector<Marked> all;
  for (const Json& element : json.value("elements", Json::array())) {
    const auto marked = MarkedFrom(element);
    if (!marked) return Fail(marked);
    all.push_back(*marked);
  }
  const double aspect = static_cast<double>(PixelsAlong(all, 0)) / PixelsAlong(all, 1);
  facade.size_m = Vec2(kPhotographHeight_m * aspect, kPhotographHeight_m);
  for (const Marked& m : all) {
    const Box2 box{m.unit.low * facade.size_m, m.unit.high * facade.size_m};
    if (m.label == kWall) {
      facade.walls.push_back(box);
    } else {
      facade.elements.push_back({m.label, box});
    }
  }
  return facade;
}

}  // namespace

Result<std::vector<AnnotatedFacade>> ReadAnnotatedFacades(const std::string& path) {
  const auto text = ReadFile(path);
  if (!text) return Fail(text);
  std::istringstream lines(*text);
  std::vector<AnnotatedFacade> facades;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty()) continue;
    const auto json = ParseJson(line, path);
    auto facade = json ? FacadeFrom(*json) : Result<AnnotatedFacade>(Fail(json));
    if (!facade) {
      facade.error().message = fmt::format("line {}: {}", number, facade.error().message);
      return facade.map([](auto&&) { return std::vector<AnnotatedFacade>(); });
    }
    facades.push_back(std::move(*facade));
  }
  return facades;
}

}  // namespace parti::tests
