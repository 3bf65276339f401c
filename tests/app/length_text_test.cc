#include "app/length_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace parti::app {
namespace {

using ::testing::HasSubstr;

double Metres(std::string_view text) {
  const auto length = ParseLength(text);
  EXPECT_TRUE(length) << text;
  return length.value_or(-1);
}

TEST(LengthTextTest, ANumberAloneIsMetres) {
  EXPECT_EQ(Metres("3.5"), 3.5);
  EXPECT_EQ(Metres(" -0.25 "), -0.25);
  EXPECT_EQ(Metres("1e-3"), 0.001);
}

TEST(LengthTextTest, ACommaIsADecimalPoint) {
  EXPECT_EQ(Metres("3,5"), 3.5);
  EXPECT_EQ(Metres("3,5 cm"), 3.5 * 0.01);
}

TEST(LengthTextTest, UnitsFollowTheNumber) {
  EXPECT_EQ(Metres("2m"), 2);
  EXPECT_EQ(Metres("350 cm"), 3.5);
  EXPECT_EQ(Metres("1200mm"), 1.2);
  EXPECT_EQ(Metres("10ft"), 3.048);
  EXPECT_EQ(Metres("10 in"), 0.254);
}

TEST(LengthTextTest, FeetAndInchesGoTogether) {
  EXPECT_DOUBLE_EQ(Metres("12'6\""), 12.5 * 0.3048);
  EXPECT_DOUBLE_EQ(Metres("12'6"), 12.5 * 0.3048);
  EXPECT_DOUBLE_EQ(Metres("12 ft 6 in"), 12.5 * 0.3048);
  EXPECT_DOUBLE_EQ(Metres("-1' 6\""), -1.5 * 0.3048);
}

TEST(LengthTextTest, WhatIsNoLengthIsRefusedWithExamples) {
  for (const char* text : {"", "m", "12 parsecs", "3.5.1", "1 2", "nan", "inf", "1e999", "12''",
                           "12'6m", "6in 12ft", "12'-6\"", "3 m 2 cm", "12mm x", "0x10", "--1"}) {
    const auto length = ParseLength(text);
    ASSERT_FALSE(length) << text;
    EXPECT_EQ(length.error().code, ErrorCode::kBadNumber) << text;
    EXPECT_THAT(length.error().hint, HasSubstr("350 cm")) << text;
  }
}

}  // namespace
}  // namespace parti::app
