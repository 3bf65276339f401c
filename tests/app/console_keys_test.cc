// The keys of a console: which ask for another one, and which are the program's.
#include "app/display/console_keys.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

namespace parti::app {
namespace {

KeyEvent Key(uint32_t code, bool pressed = true) { return {0, 1, code, pressed}; }

TEST(ConsoleKeysTest, CtrlAltAndAFunctionKeyAskForThatConsole) {
  ConsoleKeys keys;
  EXPECT_FALSE(keys.Feed(Key(KEY_F3)));
  EXPECT_FALSE(keys.Feed(Key(KEY_LEFTCTRL)));
  EXPECT_FALSE(keys.Feed(Key(KEY_F3)));
  EXPECT_FALSE(keys.Feed(Key(KEY_RIGHTALT)));
  EXPECT_EQ(keys.Feed(Key(KEY_F1))->console, 1);
  EXPECT_EQ(keys.Feed(Key(KEY_F10))->console, 10);
  EXPECT_EQ(keys.Feed(Key(KEY_F12))->console, 12);
  EXPECT_FALSE(keys.Feed(Key(KEY_F3, false)));
  EXPECT_FALSE(keys.Feed(Key(KEY_A)));
  keys.Feed(Key(KEY_RIGHTALT, false));
  EXPECT_FALSE(keys.Feed(Key(KEY_F3)));
}

TEST(ConsoleKeysTest, CtrlAltBackspaceAsksToEnd) {
  ConsoleKeys keys;
  keys.Feed(Key(KEY_RIGHTCTRL));
  keys.Feed(Key(KEY_LEFTALT));
  const auto wish = keys.Feed(Key(KEY_BACKSPACE));
  ASSERT_TRUE(wish);
  EXPECT_TRUE(wish->end);
  EXPECT_FALSE(wish->console);
  KeyEvent repeated = Key(KEY_BACKSPACE);
  repeated.repeat = true;
  EXPECT_FALSE(keys.Feed(repeated)) << "asked once";
}

TEST(ConsoleKeysTest, KeysThatWereHeldBeforeAnotherConsoleCameAreForgotten) {
  ConsoleKeys keys;
  keys.Feed(Key(KEY_LEFTCTRL));
  keys.Feed(Key(KEY_LEFTALT));
  keys.Forget();
  EXPECT_FALSE(keys.Feed(Key(KEY_F2)));
}

}  // namespace
}  // namespace parti::app
