#include "input/key_repeat.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <rapidcheck/gtest.h>

namespace parti::input {
namespace {

KeyEvent Key(uint32_t code, bool pressed, double t_s, int device = 0) {
  return {device, t_s, code, pressed, pressed ? "a" : "", false};
}

TEST(KeyRepeat, AHeldKeyTypesAgainAfterTheDelayAndThenSteadily) {
  KeyRepeat repeat;
  EXPECT_EQ(repeat.Due_s(), std::nullopt);
  repeat.Feed(Key(KEY_A, true, 10));
  EXPECT_EQ(repeat.Due_s(), 10.5);
  EXPECT_EQ(repeat.Tick(10.49), std::nullopt);
  const auto press = repeat.Tick(10.5);
  ASSERT_TRUE(press);
  EXPECT_EQ(*press, (KeyEvent{0, 10.5, KEY_A, true, "a", true}));
  EXPECT_EQ(repeat.Tick(10.5), std::nullopt);
  EXPECT_TRUE(repeat.Tick(10.54 + 1e-9));
}

TEST(KeyRepeat, ReleasingTheKeyEndsIt) {
  KeyRepeat repeat;
  repeat.Feed(Key(KEY_A, true, 10));
  repeat.Feed(Key(KEY_B, false, 10.1));  // another key's release doesn't
  EXPECT_TRUE(repeat.Due_s());
  repeat.Feed(Key(KEY_A, false, 10.2));
  EXPECT_EQ(repeat.Tick(99), std::nullopt);
}

TEST(KeyRepeat, TheKeyPressedLastIsTheOneThatRepeats) {
  KeyRepeat repeat;
  repeat.Feed(Key(KEY_A, true, 10));
  repeat.Feed(Key(KEY_B, true, 10.3));
  EXPECT_EQ(repeat.Tick(10.7), std::nullopt);
  EXPECT_EQ(repeat.Tick(10.9)->code, static_cast<uint32_t>(KEY_B));
}

TEST(KeyRepeat, ShiftDoesNotRepeatAndSilencesWhatDid) {
  KeyRepeat repeat;
  repeat.Feed(Key(KEY_A, true, 10));
  repeat.Feed(Key(KEY_LEFTSHIFT, true, 10.1), false);
  EXPECT_EQ(repeat.Tick(99), std::nullopt);
}

TEST(KeyRepeat, AKeyboardThatGoesHoldsNothing) {
  KeyRepeat repeat;
  repeat.Feed(Key(KEY_A, true, 10, 3));
  DeviceEvent gone{DeviceEvent::Kind::kRemoved, 10.1, 4, {}};
  repeat.Feed(gone);
  EXPECT_TRUE(repeat.Due_s());
  gone.device = 3;
  repeat.Feed(gone);
  EXPECT_EQ(repeat.Due_s(), std::nullopt);
}

RC_GTEST_PROP(KeyRepeat, Property_LateTicksGiveOnePressAndNoMoreThanOneAnInterval, ()) {
  KeyRepeat repeat;
  repeat.Feed(Key(KEY_A, true, 0));
  double now_s = 0;
  int presses = 0;
  for (int i = 0; i < 50; ++i) {
    now_s += *rc::gen::inRange(0, 300) * 1e-3;
    if (repeat.Tick(now_s)) ++presses;
    RC_ASSERT(!repeat.Tick(now_s));
  }
  const KeyRepeatParams params;
  RC_ASSERT(presses == 0 || presses <= (now_s - params.delay_s) / params.interval_s + 1);
}

}  // namespace
}  // namespace parti::input
