#include "sketch/agreement.h"

#include <gmock/gmock.h>

namespace parti::sketch {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(AgreedValues, AreTheMeanOfTheReadingsThatAgree) {
  // The first line is fitter as 3 than as 10, but only 10 agrees with the second.
  EXPECT_THAT(AgreedValues({{{3, 0.9}, {10, 0.8}}, {{10.4, 0.9}}}, 1, 1),
              ElementsAre(DoubleNear(10.2, 1e-9)));
}

TEST(AgreedValues, KeepsRunnersUpApart) {
  EXPECT_THAT(AgreedValues({{{3, 0.9}, {3.1, 0.9}, {10, 0.2}}}, 1, 3),
              ElementsAre(DoubleNear(3, 0.2), DoubleNear(10, 1e-9)));
}

TEST(AgreedValues, RefuseWhereALineHasNoReading) {
  EXPECT_THAT(AgreedValues({{{3, 0.9}}, {}}, 1, 3), IsEmpty());
  EXPECT_THAT(AgreedValues({}, 1, 3), IsEmpty());
}

}  // namespace
}  // namespace parti::sketch
