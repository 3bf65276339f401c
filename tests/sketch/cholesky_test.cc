#include "sketch/cholesky.h"

#include <gtest/gtest.h>

#include <cmath>

namespace parti::sketch {
namespace {

TEST(Cholesky, SolvesAndGivesTheDeterminant) {
  SquareMatrix m(3);
  m.values = {4, 0, 0, 2, 5, 0, 1, 3, 6};  // lower triangle of a symmetric matrix
  const auto lower = Cholesky(m);
  ASSERT_TRUE(lower);
  const std::vector<double> x = Solve(*lower, {11, 21, 25});  // the matrix times (1, 2, 3)
  EXPECT_NEAR(x[0], (11 - 2 * x[1] - 1 * x[2]) / 4, 1e-12);
  EXPECT_NEAR(2 * x[0] + 5 * x[1] + 3 * x[2], 21, 1e-12);
  EXPECT_NEAR(1 * x[0] + 3 * x[1] + 6 * x[2], 25, 1e-12);
  // 4 (5*6 - 9) - 2 (2*6 - 3) + 1 (2*3 - 5) = 67
  EXPECT_NEAR(LogDeterminant(*lower), std::log(67.0), 1e-12);
}

TEST(Cholesky, RefusesWhatIsNotPositiveDefinite) {
  SquareMatrix m(2);
  m.values = {1, 0, 2, 1};
  EXPECT_FALSE(Cholesky(m));
}

}  // namespace
}  // namespace parti::sketch
