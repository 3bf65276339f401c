#include "app/document_values.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace parti::app {
namespace {

TEST(DocumentValuesTest, CamerasComeBackToTheLastBit) {
  Camera camera;
  camera.eye = {0.1, 1.0 / 3, -1e-17};
  camera.target = {1e6, 2e-6, 3};
  camera.vertical_fov = Angle::Degrees(36.600000000000001);
  const auto back = CameraFrom(JsonOf(camera));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back, camera);
}

TEST(DocumentValuesTest, ACameraThatCannotSeeIsRefused) {
  EXPECT_FALSE(CameraFrom("{}"));
  EXPECT_FALSE(CameraFrom("[1,2]"));
  EXPECT_FALSE(CameraFrom(R"({"eye":[1,2,3],"target":[1,2,3],"up":[0,1,0],"vfov_deg":40,)"
                          R"("width":10,"height":10})"));
}

TEST(DocumentValuesTest, AnOutlineWithAHoleComesBackToTheLastBit) {
  grammar::Item item;
  item.scope.size = {10.1, 8.7, 0};
  item.facing = {0, 1, 0};
  item.polygon = std::make_shared<grammar::Polygon>(
      grammar::Polygon{{{0, 0}, {10.1, 0}, {1.0 / 3, 8.7}}, {{{2, 2}, {2, 2.1}, {2.1, 2}}}});
  const auto back = PlanarItemFrom(JsonOf(item));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(*back->polygon, *item.polygon);
  EXPECT_EQ(back->scope.size, item.scope.size);
  EXPECT_EQ(back->facing, item.facing);
}

TEST(DocumentValuesTest, AWholeRectangleStaysWithoutAnOutline) {
  grammar::Item item;
  item.scope.size = {3, 4, 0};
  const auto back = PlanarItemFrom(JsonOf(item));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->polygon, nullptr);
}

TEST(DocumentValuesTest, ALotKeepsItsStreetAndOneWithoutHasNone) {
  grammar::Item item;
  item.scope.size = {3, 4, 0};
  EXPECT_FALSE(PlanarItemFrom(JsonOf(item))->street_deg);
  item.street_deg = 33.3F;
  for (const auto& polygon :
       {std::shared_ptr<grammar::Polygon>(),
        std::make_shared<grammar::Polygon>(grammar::Polygon{{{0, 0}, {3, 0}, {3, 4}}, {}})}) {
    item.polygon = polygon;
    const auto back = PlanarItemFrom(JsonOf(item));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->street_deg, item.street_deg);
  }
  EXPECT_FALSE(PlanarItemFrom(R"({"origin":[0,0,0],"x":[1,0,0],"y":[0,1,0],"z":[0,0,1],)"
                              R"("size":[3,4,0],"facing":[0,0,1],"street_deg":"north"})"));
}

TEST(DocumentValuesTest, AnOutlineThatCrossesItselfIsRefused) {
  grammar::Item item;
  item.scope.size = {1, 1, 0};
  item.polygon =
      std::make_shared<grammar::Polygon>(grammar::Polygon{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}});
  EXPECT_FALSE(PlanarItemFrom(JsonOf(item)));
}

RC_GTEST_PROP(DocumentValuesTest, StrokesComeBackToTheLastBit, ()) {
  Stroke stroke;
  const auto number = [] { return *rc::gen::inRange(-1000000, 1000000) / 777.0; };
  for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
    StrokeSample sample{Vec2(number(), number()), number()};
    if (*rc::gen::arbitrary<bool>()) sample.pressure = *rc::gen::inRange(0, 1000) / 1000.0;
    stroke.push_back(sample);
  }
  const auto back = StrokeFromBytes(BytesOf(stroke));
  RC_ASSERT(back);
  RC_ASSERT(*back == stroke);
}

TEST(DocumentValuesTest, DamagedStrokesAreRefused) {
  const std::string bytes = BytesOf({{Vec2(1, 2), 3, 0.5}});
  EXPECT_FALSE(StrokeFromBytes(bytes.substr(1)));
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(StrokeFromBytes(BytesOf({{Vec2(infinite, 2), 3}})));
}

}  // namespace
}  // namespace parti::app
