#include "app/tablet_mapping.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

DeviceFacts Tablet(double width_mm, double height_mm) {
  DeviceFacts facts;
  facts.size_mm = Vec2(width_mm, height_mm);
  return facts;
}

Camera View(double width_px, double height_px) {
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  return camera;
}

TEST(TabletMappingTest, ATabletOfTheViewsShapeIsMappedCornerToCorner) {
  const TabletMapping mapping(Tablet(320, 200), View(1600, 1000));
  EXPECT_EQ(mapping.ToView_px({0, 0}), Vec2(0, 0));
  EXPECT_EQ(mapping.ToView_px({320, 200}), Vec2(1600, 1000));
}

TEST(TabletMappingTest, ATallerTabletReachesTheWholeViewWithItsMiddle) {
  const TabletMapping mapping(Tablet(320, 300), View(1600, 1000));
  EXPECT_EQ(mapping.px_per_mm(), 5);
  EXPECT_EQ(mapping.ToView_px({160, 150}), Vec2(800, 500));
  EXPECT_EQ(mapping.ToView_px({0, 50}), Vec2(0, 0));
}

TEST(TabletMappingTest, AspectIsKeptWhateverTheShapes) {
  for (const double height : {50.0, 200.0, 900.0}) {
    const TabletMapping mapping(Tablet(320, height), View(1600, 1000));
    const Vec2 step = mapping.ToView_px({11, 11}) - mapping.ToView_px({10, 10});
    EXPECT_NEAR(step.x, step.y, 1e-12);
  }
}

TEST(TabletMappingTest, ThereAndBackIsTheSamePoint) {
  const TabletMapping mapping(Tablet(279, 181), View(1920, 1200));
  const Vec2 mm(33.3, 77.7);
  EXPECT_LT(glm::distance(mapping.ToTablet_mm(mapping.ToView_px(mm)), mm), 1e-12);
}

TEST(TabletMappingTest, ADeviceWithoutASizeIsTakenForAUsualTablet) {
  const TabletMapping usual(Tablet(TabletMapping::kUsualSize_mm.x, TabletMapping::kUsualSize_mm.y),
                            View(1600, 1000));
  EXPECT_EQ(TabletMapping(DeviceFacts{}, View(1600, 1000)).px_per_mm(), usual.px_per_mm());
  EXPECT_EQ(TabletMapping(Tablet(0, 0), View(1600, 1000)).px_per_mm(), usual.px_per_mm());
}

TEST(TabletMappingTest, TimesAndPressuresStay) {
  input::PenStroke stroke;
  stroke.samples = {{{1, 2}, 3.5, 0.25, {}}, {{2, 2}, 3.6, {}, {}}};
  const Stroke mapped = TabletMapping(Tablet(320, 200), View(1600, 1000)).ToView(stroke);
  ASSERT_EQ(mapped.size(), 2u);
  EXPECT_EQ(mapped[0], (StrokeSample{{5, 10}, 3.5, 0.25}));
  EXPECT_EQ(mapped[1].pressure, std::nullopt);
}

}  // namespace
}  // namespace parti::app
