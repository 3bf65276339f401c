#include "input/keyboard.h"

#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

namespace parti::input {
namespace {

TEST(KeyLayout, IsReadFromDebiansConfiguration) {
  EXPECT_EQ(LayoutOf("# KEYBOARD CONFIGURATION FILE\n\nXKBMODEL=\"pc105\"\nXKBLAYOUT=\"de,us\"\n"
                     "XKBVARIANT=\"nodeadkeys,\"\r\nXKBOPTIONS=\"\"\nBACKSPACE=\"guess\"\n"),
            (KeyLayout{"pc105", "de,us", "nodeadkeys,", ""}));
  EXPECT_EQ(LayoutOf(""), KeyLayout());
  EXPECT_EQ(LayoutOf("XKBLAYOUT=cz"), (KeyLayout{.layout = "cz"}));
}

/// What keys type that are pressed and released one after the other.
std::string Typed(Keyboard* keyboard, std::initializer_list<uint32_t> keys) {
  std::string text;
  for (const uint32_t key : keys) {
    text += keyboard->Feed(key, true).text;
    EXPECT_EQ(keyboard->Feed(key, false).text, "");
  }
  return text;
}

TEST(Keyboard, TypesByItsLayout) {
  Keyboard us(KeyLayout{.layout = "us"}), german(KeyLayout{.layout = "de"});
  EXPECT_EQ(Typed(&us, {KEY_Y, KEY_Z, KEY_SEMICOLON}), "yz;");
  EXPECT_EQ(Typed(&german, {KEY_Y, KEY_Z, KEY_SEMICOLON}), "zyö");
}

TEST(Keyboard, ShiftIsHeldAndReleased) {
  Keyboard keyboard(KeyLayout{.layout = "us"});
  EXPECT_EQ(keyboard.Feed(KEY_LEFTSHIFT, true).text, "");
  EXPECT_EQ(Typed(&keyboard, {KEY_A, KEY_1}), "A!");
  keyboard.Feed(KEY_LEFTSHIFT, false);
  EXPECT_EQ(Typed(&keyboard, {KEY_A, KEY_1}), "a1");
}

TEST(Keyboard, KeysThatDoSomethingTypeNothing) {
  Keyboard keyboard(KeyLayout{.layout = "us"});
  EXPECT_EQ(Typed(&keyboard, {KEY_ENTER, KEY_ESC, KEY_BACKSPACE, KEY_F1, KEY_LEFT, KEY_TAB}), "");
  for (const uint32_t held : {KEY_LEFTCTRL, KEY_LEFTALT, KEY_LEFTMETA}) {
    keyboard.Feed(held, true);
    EXPECT_EQ(Typed(&keyboard, {KEY_C}), "") << held;
    keyboard.Feed(held, false);
  }
  EXPECT_EQ(Typed(&keyboard, {KEY_C}), "c");
}

TEST(Keyboard, LettersRepeatAndModifiersDont) {
  const Keyboard keyboard(KeyLayout{.layout = "us"});
  EXPECT_TRUE(keyboard.Repeats(KEY_A));
  EXPECT_TRUE(keyboard.Repeats(KEY_BACKSPACE));
  EXPECT_FALSE(keyboard.Repeats(KEY_LEFTSHIFT));
}

TEST(Keyboard, ALayoutThatIsNotKnownIsTheDefaultOne) {
  Keyboard keyboard(KeyLayout{.layout = "klingon"});
  EXPECT_EQ(Typed(&keyboard, {KEY_A}), "a");
}

TEST(Keyboard, CodesThatNoKeyHasTypeNothing) {
  Keyboard keyboard(KeyLayout{.layout = "us"});
  EXPECT_EQ(Typed(&keyboard, {0, 700, 0xffff}), "");
}

}  // namespace
}  // namespace parti::input
