#include "base/random.h"

#include <gtest/gtest.h>

namespace parti {
namespace {

TEST(Random, GivesTheNumbersOfTheReferenceImplementation) {
  Random random(1234567);  // splitmix64.c, Vigna 2015
  EXPECT_EQ(random.Next(), 6457827717110365317ull);
  EXPECT_EQ(random.Next(), 3203168211198807973ull);
  EXPECT_EQ(random.Next(), 9817491932198370423ull);
  EXPECT_EQ(Random(0).Next(), 0xe220a8397b1dcdafull);
}

TEST(Random, UniformFillsItsIntervalEvenly) {
  Random random(1);
  constexpr int kDraws = 100'000;
  int below = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.Uniform(-2, 6);
    ASSERT_GE(u, -2);
    ASSERT_LT(u, 6);
    below += u < 0 ? 1 : 0;
  }
  EXPECT_NEAR(below, kDraws / 4.0, 700);  // five standard deviations
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random(1);
  constexpr int kDraws = 100'000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.Normal();
    ASSERT_TRUE(std::isfinite(x));
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kDraws, 0, 0.016);  // five standard deviations
  EXPECT_NEAR(squares / kDraws, 1, 0.023);
}

TEST(Random, ACopyGoesOnLikeItsOriginal) {
  Random random(7);
  random.Next();
  Random copy = random;
  EXPECT_EQ(copy.Next(), random.Next());
}

}  // namespace
}  // namespace parti
