#include "tests/pen/house_plan.h"

#include <string>
#include <vector>

#include "app/command.h"
#include "app/tablet_mapping.h"
#include "base/check.h"

namespace parti::tests {
namespace {

using WorldLine = std::vector<Vec3>;  // a polyline to be drawn in one stroke, m

/// A group of strokes in one view, and what is done after them.
struct Step {
  Camera camera;
  std::vector<WorldLine> strokes;
  std::vector<std::string> commands;
};

// The house: 20 m by 14 m and 19 m high, ground floor 4 m, four floors of 3 m, a top floor of 3 m.
constexpr double kWidth = 20, kDepth = 14, kHeight = 19, kGround = 4, kTop = 16;

Camera Eye(const Vec3& eye, const Vec3& target, double fov_deg) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.vertical_fov = Angle::Degrees(fov_deg);
  return camera;
}

Vec3 South(double x, double y) { return {x, y, kDepth}; }

std::vector<Step> Plan() {
  const Camera overview = Eye({42, 17, 47}, {10, 8.5, 7}, 36);
  const Camera facade = Eye({19, 10, 44}, {10, 8.5, 14}, 30);
  const Camera window = Eye({14.5, 9, 26}, {11.25, 8.5, 14}, 30);
  const Camera street = Eye({21, 4, 40}, {10, 2.5, 14}, 32);
  const Camera above = Eye({36, 42, 44}, {10, 18, 7}, 32);

  const auto level = [](double y) { return WorldLine{South(0, y), South(kWidth, y)}; };
  std::vector<WorldLine> blocks;
  for (double x = 2.5; x < kWidth - 1; x += 2.5) blocks.push_back({South(x, 10), South(x, 7)});
  const auto ring = [](double inset, double x0, double x1, double y0, double y1, auto at) {
    return WorldLine{at(x0 + inset, y0 + inset), at(x1 - inset, y0 + inset),
                     at(x1 - inset, y1 - inset), at(x0 + inset, y1 - inset),
                     at(x0 + inset, y0 + inset)};
  };
  const auto roof = [](double x, double z) { return Vec3(x, kHeight, z); };

  std::vector<WorldLine> bays;
  for (double x = 4; x < kWidth - 1; x += 4) bays.push_back({South(x, kGround), South(x, 0)});
  return {
      {overview, {}, {"lot rect(20,14)"}},
      {overview, {{{kWidth, 0, kDepth}, {kWidth, kHeight, kDepth}}}, {"pick 1 extrude"}},
      {overview,
       {{South(0, kHeight), South(kWidth, kHeight)},
        {South(kWidth, kHeight), {kWidth, kHeight, 0}}},
       {"pick 1 comp"}},
      {overview,
       {level(kGround), level(kTop)},
       {"pick 1 split", "name Lower Ground", "name Middle CenterFloors", "name Upper TopFloor"}},
      {facade, {level(7), level(10), level(13)}, {"pick 1 repeat"}},
      {facade, blocks, {"pick 1 repeat", "name Tile WindowBlock"}},
      {window,
       {ring(0.5, 10, 12.5, 7, 10, South)},
       {"pick 1 offset", "name Inner Glass", "name Border Frame"}},
      {street, bays, {"pick 1 repeat", "name Tile Bay"}},
      {street,
       {ring(0.5, 8, 12, 0, kGround, South)},
       {"pick 1 offset", "name Inner Glass", "name Border Frame"}},
      {above, {ring(2, 0, kWidth, 0, kDepth, roof)}, {"pick 1 offset"}},
      {above, {{roof(18, 12), {18, kHeight + 4, 12}}}, {"pick 1 extrude", "name Mass Penthouse"}},
      {overview,
       {},
       {"node .Frame --> extrude(0.15)", "node .RoofBorder --> extrude(0.6)",
        "node .Glass --> color(\"#7e98a8\")"}},
  };
}

DeviceFacts Tablet() {
  DeviceFacts facts;
  facts.name = "Parti synthetic pen tablet";
  facts.vendor = 0x1209;  // pid.codes, for open source devices
  facts.product = 0x5041;
  facts.size_mm = Vec2(280, 175);
  facts.has_pen = facts.has_pressure = facts.has_tilt = facts.has_distance = true;
  facts.has_eraser = true;
  return facts;
}

std::vector<Vec2> OnTablet(const WorldLine& line, const Camera& camera, const DeviceFacts& tablet) {
  const View view(camera);
  const app::TabletMapping mapping(tablet, camera);
  std::vector<Vec2> path;
  for (const Vec3& p : line) {
    const auto pixel = view.Project(p);
    CHECK(pixel, "the plan draws what its cameras see");
    path.push_back(mapping.ToTablet_mm(*pixel));
  }
  return path;
}

}  // namespace

input::Drawing HouseDrawing(uint64_t seed, const PenModelParameters& parameters) {
  const DeviceFacts tablet = Tablet();
  Random random(seed);
  input::Drawing drawing;
  drawing.events.emplace_back(DeviceEvent{DeviceEvent::Kind::kAdded, 0, 0, tablet});
  double t_s = 0.5;
  int strokes = 0;
  const Camera* seen = nullptr;
  const std::vector<Step> plan = Plan();
  for (const Step& step : plan) {
    if (!seen || !(*seen == step.camera)) {
      drawing.commands.push_back({strokes, app::TextOf(app::SetView{step.camera})});
      seen = &step.camera;
    }
    for (const WorldLine& line : step.strokes) {
      const auto path = OnTablet(line, step.camera, tablet);
      for (PenEvent& event : DrawStroke(path, *tablet.size_mm, t_s, parameters, &random)) {
        t_s = std::max(t_s, event.t_s);
        drawing.events.emplace_back(event);
      }
      t_s += random.Uniform(0.25, 0.6);
      ++strokes;
    }
    for (const std::string& command : step.commands) drawing.commands.push_back({strokes, command});
    t_s += random.Uniform(0.8, 1.6);  // looking at the suggestions
  }
  return drawing;
}

}  // namespace parti::tests
