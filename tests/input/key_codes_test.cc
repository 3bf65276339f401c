// The codes of keys on the layouts of several countries, through the real xkbcommon.
#include "input/key_codes.h"

#include <gtest/gtest.h>

#include <map>

#include "input/keyboard.h"

namespace parti::input {
namespace {

/// What a layout makes of the key in a place: a tap of it.
Keystroke Tap(Keyboard* keyboard, uint32_t place) {
  Keystroke pressed = keyboard->Feed(place, true);
  EXPECT_EQ(keyboard->Feed(place, false).code, pressed.code) << "a release is its press's";
  return pressed;
}

uint32_t CodeIn(const KeyLayout& layout, uint32_t place) {
  Keyboard keyboard(layout);
  return Tap(&keyboard, place).code;
}

TEST(KeyCodes, LettersAreWhereTheLayoutHasThem) {
  const KeyLayout german{.layout = "de"}, french{.layout = "fr"};
  EXPECT_EQ(CodeIn(german, KEY_Y), uint32_t{KEY_Z});
  EXPECT_EQ(CodeIn(german, KEY_Z), uint32_t{KEY_Y});
  EXPECT_EQ(CodeIn(german, KEY_S), uint32_t{KEY_S});
  EXPECT_EQ(CodeIn(french, KEY_W), uint32_t{KEY_Z});
  EXPECT_EQ(CodeIn(french, KEY_Z), uint32_t{KEY_W});
  EXPECT_EQ(CodeIn(french, KEY_Q), uint32_t{KEY_A});
  EXPECT_EQ(CodeIn(french, KEY_SEMICOLON), uint32_t{KEY_M});
}

TEST(KeyCodes, OtherKeysStayWhereTheyAre) {
  for (const char* layout : {"us", "de", "fr", "ru", "gr"}) {
    for (const uint32_t place : {KEY_1, KEY_9, KEY_ENTER, KEY_ESC, KEY_LEFTCTRL, KEY_LEFT, KEY_F1,
                                 KEY_SPACE, KEY_BACKSPACE, KEY_KPENTER, KEY_102ND}) {
      EXPECT_EQ(CodeIn({.layout = layout}, place), place) << layout;
    }
  }
}

TEST(KeyCodes, AKeyThatALetterWasTakenFromIsNotThatLetter) {
  EXPECT_EQ(CodeIn({.layout = "fr"}, KEY_M), uint32_t{KEY_SEMICOLON}) << "it types a comma";
  EXPECT_EQ(CodeIn({.layout = "us", .variant = "dvorak"}, KEY_E), uint32_t{KEY_DOT})
      << "e is on D, d on H, and so on, until v is where the dot was";
}

TEST(KeyCodes, DifferentKeysHaveDifferentCodes) {
  for (const KeyLayout& layout :
       {KeyLayout{.layout = "us"}, KeyLayout{.layout = "us", .variant = "dvorak"},
        KeyLayout{.layout = "de"}, KeyLayout{.layout = "fr"},
        KeyLayout{.layout = "fr", .variant = "bepo"}, KeyLayout{.layout = "tr", .variant = "f"},
        KeyLayout{.layout = "cz"}, KeyLayout{.layout = "ru"}, KeyLayout{.layout = "gr"},
        KeyLayout{.layout = "fr,ru"}}) {
    Keyboard keyboard(layout);
    std::map<uint32_t, uint32_t> places;
    for (uint32_t place = KEY_ESC; place <= KEY_MICMUTE; ++place) {
      const auto [other, fresh] = places.emplace(Tap(&keyboard, place).code, place);
      EXPECT_TRUE(fresh) << layout.layout << " " << layout.variant << ": " << place << " and "
                         << other->second << " are both " << other->first;
    }
  }
}

TEST(KeyCodes, LayoutsOfOtherLettersHaveThoseOfTheirPlace) {
  for (const char* layout : {"ru", "gr"}) {
    for (const uint32_t letter : kLetterKeys) {
      EXPECT_EQ(CodeIn({.layout = layout}, letter), letter) << layout;
    }
  }
}

TEST(KeyCodes, ALayoutOfLatinLettersBesideStandsInForThem) {
  Keyboard keyboard(KeyLayout{.layout = "ru,de", .options = "grp:alt_shift_toggle"});
  const Keystroke russian = Tap(&keyboard, KEY_Y);
  EXPECT_EQ(russian.text, "н");
  EXPECT_EQ(russian.code, uint32_t{KEY_Z});
  keyboard.Feed(KEY_LEFTALT, true);
  Tap(&keyboard, KEY_LEFTSHIFT);
  keyboard.Feed(KEY_LEFTALT, false);
  const Keystroke german = Tap(&keyboard, KEY_Y);
  EXPECT_EQ(german.text, "z");
  EXPECT_EQ(german.code, uint32_t{KEY_Z});
}

TEST(KeyCodes, ModifiersDontMatter) {
  Keyboard keyboard(KeyLayout{.layout = "de"});
  for (const uint32_t held : {KEY_LEFTSHIFT, KEY_LEFTCTRL, KEY_RIGHTALT, KEY_CAPSLOCK}) {
    keyboard.Feed(held, true);
    EXPECT_EQ(Tap(&keyboard, KEY_Y).code, uint32_t{KEY_Z}) << held;
    keyboard.Feed(held, false);
  }
}

TEST(KeyCodes, AKeyKeepsItsCodeWhileItIsHeld) {
  Keyboard keyboard(KeyLayout{.layout = "us,de", .options = "grp:alt_shift_toggle"});
  EXPECT_EQ(keyboard.Feed(KEY_Y, true).code, uint32_t{KEY_Y});
  keyboard.Feed(KEY_LEFTALT, true);
  Tap(&keyboard, KEY_LEFTSHIFT);
  keyboard.Feed(KEY_LEFTALT, false);
  EXPECT_EQ(keyboard.Feed(KEY_Y, false).code, uint32_t{KEY_Y});
  EXPECT_EQ(Tap(&keyboard, KEY_Y).code, uint32_t{KEY_Z});
}

TEST(KeyCodes, PlacesThatNoKeyHasAreNoTrouble) {
  Keyboard keyboard(KeyLayout{.layout = "de"});
  for (const uint32_t place : {0u, 700u, 0xffffu, 0xffffffffu}) {
    EXPECT_EQ(Tap(&keyboard, place).code, place);
  }
}

TEST(KeyCodes, AKeyboardHasAllLetters) {
  EXPECT_TRUE(IsKeyboard([](uint32_t) { return true; }));
  EXPECT_FALSE(IsKeyboard([](uint32_t code) { return code == KEY_POWER; }));
  EXPECT_FALSE(IsKeyboard([](uint32_t code) { return code >= KEY_KP7 && code <= KEY_KPDOT; }));
  EXPECT_FALSE(IsKeyboard([](uint32_t code) { return code != KEY_Q; }));
}

}  // namespace
}  // namespace parti::input
