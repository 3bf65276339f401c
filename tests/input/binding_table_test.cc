#include "input/binding_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace parti::input {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(BindingTable, TheDefaultsReadAsPeopleWouldSayThem) {
  EXPECT_EQ(BindingsText(DefaultBindings()),
            "pen=draw pen+lower=erase pen+upper=select eraser=erase mouse+left=draw "
            "ctrl+mouse+left=erase shift+mouse+left=select mouse+middle=pan mouse+right=orbit "
            "wheel=zoom shift+wheel=pan");
}

TEST(BindingTable, TheRowWithTheMostConditionsWins) {
  const auto table = *ReadBindings("pen=draw pen+lower=erase shift+pen+lower=pan ctrl+pen=select");
  EXPECT_EQ(ActFor(table, PenSource::kPen, 0, {{}, kShift}), PenAct::kDraw);
  EXPECT_EQ(ActFor(table, PenSource::kPen, 0, {{BTN_STYLUS}, 0}), PenAct::kErase);
  EXPECT_EQ(ActFor(table, PenSource::kPen, 0, {{BTN_STYLUS2, BTN_STYLUS}, kShift | kCtrl}),
            PenAct::kPan);
  EXPECT_EQ(ActFor(table, PenSource::kEraser, 0, {}), PenAct::kNone);
}

TEST(BindingTable, BlanksBetweenRowsDontMatter) {
  EXPECT_EQ(*ReadBindings("  pen=draw   wheel=none "),
            (BindingTable{{PenSource::kPen, 0, 0, PenAct::kDraw},
                          {PenSource::kWheel, 0, 0, PenAct::kNone}}));
  EXPECT_THAT(*ReadBindings(""), IsEmpty());
}

TEST(BindingTable, WordsThatAreNotKnownAreNamedWithThoseThatAre) {
  for (const char* text : {"pencil=draw", "pen=paint", "pen", "=draw", "mouse=draw",
                           "mouse+lower=draw", "wheel+left=pan", "pen+lower+upper=erase",
                           "hyper+pen=draw", "pen+=draw=draw", "+pen=draw"}) {
    const auto table = ReadBindings(text);
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().code, ErrorCode::kBadText);
    EXPECT_THAT(table.error().message, HasSubstr(text)) << text;
    EXPECT_THAT(table.error().hint, HasSubstr("shift+mouse+left=select"));
  }
}

TEST(BindingTable, TwoRowsForTheSameThingAreRefused) {
  const auto table = ReadBindings("pen=draw shift+ctrl+wheel=pan ctrl+shift+wheel=zoom");
  ASSERT_FALSE(table);
  EXPECT_THAT(table.error().message, HasSubstr("\"ctrl+shift+wheel=zoom\" is given twice"));
}

RC_GTEST_PROP(BindingTable, WhatIsWrittenIsReadBack, ()) {
  BindingTable table;
  const int rows = *rc::gen::inRange(0, 12);
  for (int i = 0; i < rows; ++i) {
    Binding row;
    row.source = static_cast<PenSource>(*rc::gen::inRange(0, 4));
    if (row.source == PenSource::kMouse) row.button = *rc::gen::element(BTN_LEFT, BTN_EXTRA);
    if (row.source < PenSource::kMouse) row.button = *rc::gen::element(0, BTN_STYLUS, BTN_STYLUS3);
    row.modifiers = static_cast<uint8_t>(*rc::gen::inRange(0, 8));
    row.act = static_cast<PenAct>(*rc::gen::inRange(0, 7));
    const auto same = [&](const Binding& b) {
      return b.source == row.source && b.button == row.button && b.modifiers == row.modifiers;
    };
    if (std::none_of(table.begin(), table.end(), same)) table.push_back(row);
  }
  RC_ASSERT(*ReadBindings(BindingsText(table)) == table);
}

}  // namespace
}  // namespace parti::input
