// The whole way from strokes to ranked operations, drawn with a perfect and with a shaky pen.
#include "sketch/suggestion.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "grammar/operation.h"
#include "tests/sketch/sketch_scene.h"

namespace parti::sketch {
namespace {

using grammar::Axis;
using ::testing::Not;
using tests::At;
using tests::Draw;

constexpr double kShaky_px = 2.5;

struct Sketch {
  grammar::Item item;
  Camera camera = tests::HouseCamera();
  std::vector<Stroke> strokes = {};

  void Add(const std::vector<Vec3>& corners, double noise_px = kShaky_px) {
    strokes.push_back(Draw(corners, camera, noise_px, strokes.size() + 1));
  }
};

Sketch Riser() {
  Sketch s{tests::Lot()};
  s.Add({At(s.item, 20, 0), At(s.item, 20, 0, 8)});
  return s;
}

Sketch Portal() {  // up, along the top and down, in one stroke
  Sketch s{tests::Lot()};
  s.Add({At(s.item, 0, 0), At(s.item, 0, 0, 6), At(s.item, 20, 0, 6), At(s.item, 20, 0)});
  return s;
}

Sketch InnerRectangle() {
  Sketch s{tests::Lot()};
  s.Add({At(s.item, 2, 2), At(s.item, 18, 2), At(s.item, 18, 10), At(s.item, 2, 10),
         At(s.item, 2, 2)});
  return s;
}

Sketch GroundFloor() {
  Sketch s{tests::Facade()};
  s.Add({At(s.item, 0, 3.4), At(s.item, 16, 3.4)});
  return s;
}

Sketch CentralBay() {
  Sketch s{tests::Facade()};
  s.Add({At(s.item, 4, 0), At(s.item, 4, 9)});
  s.Add({At(s.item, 12, 9), At(s.item, 12, 0)});
  return s;
}

Sketch EvenTiles() {
  Sketch s{tests::Facade()};
  for (int i = 1; i < 5; ++i) s.Add({At(s.item, 3.2 * i, 0), At(s.item, 3.2 * i, 9)});
  return s;
}

Sketch RoofEdges() {
  Sketch s{tests::Box()};
  s.Add({{0, 6, 8}, {10, 6, 8}});
  s.Add({{10, 6, 8}, {10, 6, 0}});
  return s;
}

struct Case {
  const char* operation;
  Sketch (*draw)();
};

const std::vector<Case>& Cases() {
  static const std::vector<Case> kCases = {{"extrude", Riser},         {"extrude", Portal},
                                           {"offset", InnerRectangle}, {"split", GroundFloor},
                                           {"split", CentralBay},      {"repeat", EvenTiles},
                                           {"comp", RoofEdges}};
  return kCases;
}

std::vector<Suggestion> Best(const Sketch& s) {
  const auto found = SuggestFromStrokes(s.strokes, s.item, s.camera);
  EXPECT_TRUE(found.has_value()) << (found ? "" : found.error().message);
  return found.value_or(std::vector<Suggestion>{});
}

double SizeOf(const grammar::Action& action, size_t i) {
  const auto products = grammar::Apply(action, tests::Facade()).value();
  return products[i].item.scope.size[static_cast<int>(std::get<Axis>(action.arguments[0]))];
}

TEST(Suggest, ARiserFromACornerIsAnExtrusion) {
  const auto best = Best(Riser());
  ASSERT_THAT(best, Not(::testing::IsEmpty()));
  EXPECT_EQ(best[0].action.operation->name, "extrude");
  EXPECT_NEAR(std::get<double>(best[0].action.arguments[0]), 8, 0.4);
  EXPECT_EQ(best[0].action.symbol, "Mass");
  EXPECT_TRUE(best[0].by_heuristic);
}

TEST(Suggest, APortalInOneStrokeIsAnExtrusion) {
  const auto best = Best(Portal());
  ASSERT_THAT(best, Not(::testing::IsEmpty()));
  EXPECT_EQ(best[0].action.operation->name, "extrude");
  EXPECT_NEAR(std::get<double>(best[0].action.arguments[0]), 6, 0.3);
}

TEST(Suggest, AnInnerRectangleIsAnOffset) {
  const auto best = Best(InnerRectangle());
  ASSERT_THAT(best, Not(::testing::IsEmpty()));
  EXPECT_EQ(best[0].action.operation->name, "offset");
  EXPECT_NEAR(std::get<double>(best[0].action.arguments[0]), -2, 0.2);
  EXPECT_EQ(best[0].action.successors[0].symbol, "RoofInner");
}

TEST(Suggest, ALineAcrossIsASplitWithASizeAndARest) {
  const auto best = Best(GroundFloor());
  ASSERT_THAT(best, Not(::testing::IsEmpty()));
  EXPECT_EQ(best[0].action.operation->name, "split");
  EXPECT_EQ(std::get<Axis>(best[0].action.arguments[0]), Axis::kY);
  EXPECT_NEAR(SizeOf(best[0].action, 0), 3.4, 0.15);
  EXPECT_EQ(best[0].action.successors[0].symbol, "Lower");
  EXPECT_EQ(best[0].action.successors[1].symbol, "Upper");
}

TEST(Suggest, EqualEndsOfASplitAreTiedAndShareAName) {
  const auto best = Best(CentralBay());
  ASSERT_THAT(best, Not(::testing::IsEmpty()));
  EXPECT_EQ(best[0].action.operation->name, "split");
  ASSERT_EQ(best[0].action.successors.size(), 3u);
  EXPECT_DOUBLE_EQ(SizeOf(best[0].action, 0), SizeOf(best[0].action, 2));
  EXPECT_NEAR(SizeOf(best[0].action, 0), 4, 0.2);
  EXPECT_EQ(best[0].action.successors[0].symbol, best[0].action.successors[2].symbol);
  EXPECT_NE(best[0].action.successors[0].symbol, best[0].action.successors[1].symbol);
}

TEST(Suggest, SizesThatThePenTellsApartAreNotTied) {
  // A ground floor of 4 m and a top floor of 3 m differ by 5 % of 19 m, and by 20 px.
  Camera camera;
  camera.eye = Vec3(42, 17, 47);
  camera.target = Vec3(10, 8.5, 7);
  camera.vertical_fov = Angle::Degrees(36);
  const auto facade = tests::Face({0, 0, 14}, {1, 0, 0}, {0, 0, 1}, 20, 19);
  int told_apart = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    Sketch s{facade, camera};
    for (const double y : {4.0, 16.0}) {
      s.strokes.push_back(Draw({At(facade, 0, y), At(facade, 20, y)}, camera, kShaky_px,
                               2 * seed + (y > 5 ? 1 : 0)));
    }
    const auto best = Best(s);
    ASSERT_FALSE(best.empty());
    EXPECT_EQ(best[0].action.operation->name, "split");
    const auto parts = grammar::Apply(best[0].action, facade).value();
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_NEAR(parts[0].item.scope.size.y, 4, 0.5);
    told_apart += parts[0].item.scope.size.y > parts[2].item.scope.size.y + 0.3 ? 1 : 0;
  }
  EXPECT_GE(told_apart, 9);
}

TEST(Suggest, EvenLinesAreARepeatFirstAndASplitToo) {
  const auto best = Best(EvenTiles());
  ASSERT_GE(best.size(), 2u);
  EXPECT_EQ(best[0].action.operation->name, "repeat");
  EXPECT_EQ(grammar::Apply(best[0].action, tests::Facade()).value().size(), 5u);
  EXPECT_EQ(best[0].action.successors[0].symbol, "Tile");
  EXPECT_TRUE(std::any_of(best.begin(), best.end(),
                          [](const Suggestion& s) { return s.action.operation->name == "split"; }));
}

TEST(Suggest, EdgesOfAVolumeAreACompOfferedTwice) {
  const auto best = Best(RoofEdges());
  ASSERT_GE(best.size(), 2u);
  EXPECT_EQ(best[0].action.operation->name, "comp");
  EXPECT_EQ(best[1].action.operation->name, "comp");
  EXPECT_EQ(best[0].action.successors[0].symbol, "Facade");
  EXPECT_EQ(best[0].action.successors[1].symbol, "Roof");
  EXPECT_EQ(best[1].action.successors.size(), 1u);
}

TEST(Suggest, IsSortedByScoreAndEveryActionApplies) {
  for (const Case& c : Cases()) {
    const Sketch sketch = c.draw();
    const auto best = Best(sketch);
    for (size_t i = 0; i < best.size(); ++i) {
      EXPECT_TRUE(grammar::Apply(best[i].action, sketch.item)) << grammar::TextOf(best[i].action);
      EXPECT_TRUE(std::isfinite(best[i].score) && std::isfinite(best[i].error));
    }
    EXPECT_EQ(best[0].action.operation->name, c.operation);
  }
}

TEST(SuggestMetamorphic, OrderAndDirectionOfStrokesDoNotMatter) {
  for (const Case& c : Cases()) {
    Sketch sketch = c.draw();
    std::reverse(sketch.strokes.begin(), sketch.strokes.end());
    for (Stroke& stroke : sketch.strokes) {
      std::reverse(stroke.begin(), stroke.end());
      for (StrokeSample& s : stroke) s.t_s = 100 - s.t_s;
    }
    EXPECT_EQ(Best(sketch)[0].action.operation->name, c.operation);
  }
}

TEST(SuggestMetamorphic, TurningTheWorldDoesNotMatter) {
  for (const Case& c : Cases()) {
    for (const double degrees : {37.0, 121.0, 250.0}) {
      Sketch sketch = c.draw();
      const auto before = Best(sketch);
      sketch.item = tests::Turned(sketch.item, Angle::Degrees(degrees));
      sketch.camera = tests::Turned(sketch.camera, Angle::Degrees(degrees));
      const auto after = Best(sketch);
      ASSERT_FALSE(after.empty());
      EXPECT_EQ(after[0].action.operation->name, c.operation);
      EXPECT_NEAR(after[0].score, before[0].score, 0.5);
    }
  }
}

TEST(SuggestMetamorphic, MirroringTheViewDoesNotMatter) {
  for (const Case& c : Cases()) {
    Sketch sketch = c.draw();
    // Mirrored in the plane x = 0 and walked through backwards, so that the normal stays.
    grammar::Scope& scope = sketch.item.scope;
    const Vec3 far = scope.ToWorld(Vec3(scope.size.x, 0, 0));
    scope.origin = Vec3(-far.x, far.y, far.z);
    scope.x = Vec3(scope.x.x, -scope.x.y, -scope.x.z);
    sketch.camera.eye.x *= -1;
    sketch.camera.target.x *= -1;
    for (Stroke& stroke : sketch.strokes) {
      for (StrokeSample& s : stroke) s.position.x = sketch.camera.width_px - s.position.x;
    }
    const auto best = Best(sketch);
    ASSERT_FALSE(best.empty());
    EXPECT_EQ(best[0].action.operation->name, c.operation);
  }
}

TEST(SuggestMetamorphic, SameInputSameBytes) {
  for (const Case& c : Cases()) {
    const auto first = Best(c.draw()), second = Best(c.draw());
    ASSERT_EQ(first.size(), second.size());
    for (size_t i = 0; i < first.size(); ++i) {
      EXPECT_EQ(first[i].action, second[i].action);
      EXPECT_EQ(first[i].score, second[i].score);
    }
  }
}

TEST(Suggest, LinesDrawnInTwoViewsAddUp) {
  const auto lot = tests::Lot();
  const Camera front = tests::HouseCamera();
  Camera side = front;
  side.eye = Vec3(-30, 14, 14);
  Configuration configuration;
  for (const Camera& camera : {front, side}) {
    const double x = camera.eye.x > 0 ? 20 : 0;
    const auto lines =
        LiftStroke(Draw({At(lot, x, 0), At(lot, x, 0, 5)}, camera, kShaky_px), lot, camera);
    ASSERT_TRUE(lines);
    configuration.lines.insert(configuration.lines.end(), lines->begin(), lines->end());
  }
  const auto found = Suggest(configuration, lot);
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)[0].action.operation->name, "extrude");
  EXPECT_NEAR(std::get<double>((*found)[0].action.arguments[0]), 5, 0.3);
  const Configuration settled = Settled(configuration, lot, (*found)[0].action);
  for (const WorldLine& line : settled.lines) {
    EXPECT_NEAR(std::max(line.world.a.y, line.world.b.y),
                std::get<double>((*found)[0].action.arguments[0]), 1e-9);
  }
}

TEST(Suggest, AHookedLineStillCounts) {
  Sketch s{tests::Facade()};
  for (int i = 1; i < 4; ++i) s.Add({At(s.item, 4.0 * i, 0), At(s.item, 4.0 * i, 9)});
  // The second line starts with a hook of a fifth of its length.
  Stroke& stroke = s.strokes[1];
  const Vec2 start = stroke.front().position;
  Stroke hooked;
  for (int i = 0; i < 8; ++i) {
    hooked.push_back({start + Vec2(40 - 5 * i, -4.0 * i), 0.01 * i});
  }
  for (StrokeSample sample : stroke) {
    if (glm::distance(sample.position, start) < 30) continue;
    sample.t_s += 0.1;
    hooked.push_back(sample);
  }
  stroke = hooked;
  const auto best = Best(s);
  ASSERT_FALSE(best.empty());
  EXPECT_EQ(best[0].action.operation->name, "repeat");
  EXPECT_EQ(grammar::Apply(best[0].action, s.item).value().size(), 4u);
}

TEST(SuggestErrors, ATapSaysSo) {
  const auto found = SuggestFromStrokes({StrokeFrom("5,5")}, tests::Lot(), tests::HouseCamera());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kTooShort);
}

TEST(SuggestErrors, NoStrokesNoLines) {
  EXPECT_EQ(SuggestFromStrokes({}, tests::Lot(), tests::HouseCamera()).error().code,
            ErrorCode::kTooShort);
  EXPECT_EQ(Suggest({}, tests::Lot()).error().code, ErrorCode::kTooShort);
}

TEST(SuggestErrors, AStrokeFarFromTheShapeFitsNothing) {
  const auto found =
      SuggestFromStrokes({StrokeFrom("5,5 20,6 40,7 70,8")}, tests::Lot(), tests::HouseCamera());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kNoFit);
}

TEST(SuggestErrors, AShapeWithoutSizeIsRefused) {
  grammar::Item flat = tests::Lot();
  flat.scope.size.y = 0;
  const auto found = SuggestFromStrokes(Riser().strokes, flat, tests::HouseCamera());
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kDegenerateGeometry);
}

TEST(SuggestErrors, ACameraOnItsTargetIsRefused) {
  Camera camera = tests::HouseCamera();
  camera.eye = camera.target;
  const auto found = SuggestFromStrokes(Riser().strokes, tests::Lot(), camera);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kBadNumber);
}

TEST(SuggestErrors, AShapeBehindTheEyeIsRefused) {
  Camera camera = tests::HouseCamera();
  camera.target = camera.eye * 2.0;
  const auto found = SuggestFromStrokes(Riser().strokes, tests::Lot(), camera);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kBehindEye);
}

TEST(SuggestErrors, NumbersThatAreNotFiniteAreRefused) {
  Sketch s = Riser();
  s.strokes[0][2].position.y = std::numeric_limits<double>::infinity();
  const auto found = SuggestFromStrokes(s.strokes, s.item, s.camera);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kBadNumber);
}

}  // namespace
}  // namespace parti::sketch
