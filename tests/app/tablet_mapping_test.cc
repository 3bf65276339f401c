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
  const TabletMapping usual(Tablet(kUsualSize_mm.x, kUsualSize_mm.y), View(1600, 1000));
  EXPECT_EQ(TabletMapping(DeviceFacts{}, View(1600, 1000)).px_per_mm(), usual.px_per_mm());
  EXPECT_EQ(TabletMapping(Tablet(0, 0), View(1600, 1000)).px_per_mm(), usual.px_per_mm());
}

TEST(TabletMappingTest, ADeviceThatPointsIntoTheViewIsTakenAtItsWord) {
  DeviceFacts mouse = Tablet(50, 20);
  mouse.view_px_per_mm = 4;
  for (const bool left_handed : {false, true}) {
    const TabletMapping mapping(
        mouse, View(1600, 1000),
        {.left_handed = left_handed, .own_output = ViewRect{{5, 5}, {9, 9}}});
    EXPECT_EQ(mapping.ToView_px({100, 50}), Vec2(400, 200));
    EXPECT_EQ(mapping.ToTablet_mm({400, 200}), Vec2(100, 50));
    EXPECT_EQ(mapping.px_per_mm(), 4);
  }
}

TEST(TabletMappingTest, ATurnedTabletIsTheSameTurnedBy180Degrees) {
  const DeviceFacts tablet = Tablet(320, 300);
  const TabletMapping usual(tablet, View(1600, 1000));
  const TabletMapping turned(tablet, View(1600, 1000), {.left_handed = true});
  EXPECT_EQ(turned.px_per_mm(), usual.px_per_mm());
  for (const Vec2 mm : {Vec2(0, 0), Vec2(33, 77), Vec2(320, 300)}) {
    EXPECT_LT(glm::distance(turned.ToView_px(mm), usual.ToView_px(*tablet.size_mm - mm)), 1e-9);
    EXPECT_LT(glm::distance(turned.ToTablet_mm(turned.ToView_px(mm)), mm), 1e-9);
  }
}

DeviceFacts Screen(double width_mm, double height_mm) {
  DeviceFacts facts = Tablet(width_mm, height_mm);
  facts.has_display = true;
  return facts;
}

TEST(TabletMappingTest, ADisplayTabletIsItsOwnOutputCornerToCorner) {
  const ViewRect output{{1600, 100}, {1920, 1080}};
  for (const bool left_handed : {false, true}) {
    const TabletMapping mapping(Screen(344, 194), View(3520, 1200),
                                {.left_handed = left_handed, .own_output = output});
    EXPECT_EQ(mapping.ToView_px({0, 0}), output.origin_px);
    EXPECT_LT(glm::distance(mapping.ToView_px({344, 194}), output.origin_px + output.size_px),
              1e-9);
    EXPECT_NEAR(mapping.px_per_mm(), 1920 / 344.0, 0.02);
  }
}

TEST(TabletMappingTest, AScreenOfNearlyTheViewsShapeIsTheView) {
  const TabletMapping mapping(Screen(297.76, 169.24), View(1280, 720));
  EXPECT_EQ(mapping.ToView_px({0, 0}), Vec2(0, 0));
  EXPECT_LT(glm::distance(mapping.ToView_px({297.76, 169.24}), Vec2(1280, 720)), 1e-9);
}

TEST(TabletMappingTest, AScreenOfAnotherShapeKeepsItsAspectAndIsNeverTurned) {
  const DeviceFacts screen = Screen(320, 300);
  const TabletMapping opaque(Tablet(320, 300), View(1600, 1000));
  const TabletMapping mapping(screen, View(1600, 1000), {.left_handed = true});
  EXPECT_EQ(mapping.ToView_px({33, 44}), opaque.ToView_px({33, 44}));
}

TEST(TabletMappingTest, ATouchScreenOfUnknownSizeIsTheView) {
  DeviceFacts screen;
  screen.has_display = screen.has_touch = true;
  const TabletMapping mapping(screen, View(1000, 2000));
  EXPECT_LT(glm::distance(mapping.ToView_px(kUsualSize_mm), Vec2(1000, 2000)), 1e-9);
}

TEST(TabletMappingTest, AnOpaqueTabletHasNoOutputOfItsOwn) {
  const TabletMapping mapping(Tablet(320, 200), View(1600, 1000),
                              {.own_output = ViewRect{{5, 5}, {9, 9}}});
  EXPECT_EQ(mapping.ToView_px({320, 200}), Vec2(1600, 1000));
}

constexpr ViewRect kView{{0, 0}, {1920, 1080}};

TEST(OwnOutputTest, OfSeveralItIsTheOneOfItsSize) {
  const OutputPlace desk{Vec2(598, 336), std::nullopt}, own{Vec2(300, 170), kView};
  const DeviceFacts tablet = Screen(297.76, 169.24);
  EXPECT_EQ(OwnOutput(tablet, std::vector{desk, own}), kView);
  EXPECT_EQ(OwnOutput(tablet, std::vector{own, desk}), kView);
}

TEST(OwnOutputTest, WhereItsOwnIsNotShownThereIsNone) {
  const OutputPlace desk{Vec2(598, 336), kView}, own{Vec2(300, 170), std::nullopt};
  EXPECT_EQ(OwnOutput(Screen(297.76, 169.24), std::vector{desk, own}), std::nullopt);
}

TEST(OwnOutputTest, OfTwoAlikeTheOneThatIsShown) {
  const OutputPlace one{Vec2(300, 170), std::nullopt}, other{Vec2(300, 170), kView};
  EXPECT_EQ(OwnOutput(Screen(300, 170), std::vector{one, other}), kView);
}

TEST(OwnOutputTest, AnOnlyOneThatDoesNotSayItsSizeIsIt) {
  EXPECT_EQ(OwnOutput(Screen(300, 170), std::vector{OutputPlace{std::nullopt, kView}}), kView);
  const std::vector<OutputPlace> two(2, OutputPlace{std::nullopt, kView});
  EXPECT_EQ(OwnOutput(Screen(300, 170), two), std::nullopt);
  EXPECT_EQ(OwnOutput(Screen(300, 170), {}), std::nullopt);
}

TEST(OwnOutputTest, AnotherSizeAndAnOpaqueTabletHaveNone) {
  const std::vector screens{OutputPlace{Vec2(300, 170), kView}};
  EXPECT_EQ(OwnOutput(Screen(344, 194), screens), std::nullopt);
  EXPECT_EQ(OwnOutput(Tablet(300, 170), screens), std::nullopt);
  EXPECT_EQ(OwnOutput(Screen(0, -1), screens), std::nullopt);
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
