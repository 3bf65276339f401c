#include "app/line_spacing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace parti::app {
namespace {

/// Two triangles.
render::Faces Rectangle(float wide_m, float high_m) {
  render::Faces faces;
  faces.corners = {{0, 0, 0},           {wide_m, 0, 0}, {wide_m, high_m, 0},
                   {wide_m, high_m, 0}, {0, high_m, 0}, {0, 0, 0}};
  return faces;
}

TEST(LineSpacing, IsNearlyTheWidthOfSquaresAndOfBands) {
  EXPECT_NEAR(LineSpacing_m(std::vector{Rectangle(10, 10)}), 5.86, 0.01);
  EXPECT_NEAR(LineSpacing_m(std::vector{Rectangle(1000, 0.5)}), 0.5, 0.01);
}

TEST(LineSpacing, IsThatOfTheManySmallFacesBesideALargeOne) {
  std::vector<render::Faces> faces(4000, Rectangle(1, 1));
  faces.push_back(Rectangle(200, 200));
  EXPECT_NEAR(LineSpacing_m(faces), 0.586, 0.001);
}

TEST(LineSpacing, IsNothingWithoutFacesOrWithoutTheirSizes) {
  EXPECT_EQ(LineSpacing_m({}), 0);
  EXPECT_EQ(LineSpacing_m(std::vector{render::Faces{}, Rectangle(0, 0)}), 0);
  EXPECT_EQ(LineSpacing_m(std::vector{Rectangle(NAN, 1), Rectangle(1e30f, 1e30f)}), 0);
}

}  // namespace
}  // namespace parti::app
