// What of a window can be told without a server: its icon, and the scale that desktops ask for.
#include "render/x11_window.h"

#include <gtest/gtest.h>

#include "render/window_icon.h"

namespace parti::render {
namespace {

TEST(X11Windows, TheScaleIsReadFromTheDesktopsResources) {
  EXPECT_EQ(ScaleIn("Xft.dpi:\t192\n"), 2);
  EXPECT_EQ(ScaleIn("Xcursor.size: 24\nXft.dpi: 144"), 1.5);
  EXPECT_EQ(ScaleIn(""), 1);
  EXPECT_EQ(ScaleIn("NotXft.dpi: 192\n"), 1);
  EXPECT_EQ(ScaleIn("Xft.dpi: quite a lot\n"), 1);
  EXPECT_EQ(ScaleIn("Xft.dpi: 9600\n"), 4);
  EXPECT_EQ(ScaleIn("Xft.dpi: nan\n"), 1);
}

TEST(WindowIcons, AreAHouseOnASheetAtEverySize) {
  for (const int side : {16, 32, 128}) {
    const Image icon = WindowIcon(side);
    ASSERT_EQ(icon.pixels.size(), size_t{4} * side * side);
    const auto pixel = [&](double x, double y) {
      return &icon.pixels[4 *
                          (static_cast<size_t>(y * side) * side + static_cast<size_t>(x * side))];
    };
    EXPECT_EQ(pixel(0, 0)[3], 0) << "round corners";
    EXPECT_EQ(pixel(0.5, 0.6)[3], 255);
    EXPECT_GT(pixel(0.5, 0.6)[0], 230) << "paper";
    EXPECT_LT(pixel(0.5, 0.77)[0], 120) << "the ground line";
    EXPECT_GT(pixel(0.5, 0.36)[0], pixel(0.5, 0.36)[2] + 50) << "the roof";
  }
}

}  // namespace
}  // namespace parti::render
