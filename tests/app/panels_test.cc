// Panels through their input only: a tap here is that command there.
#include "app/panels/panels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/input-event-codes.h>

#include "tests/app/panels_driver.h"

namespace parti::app::tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(PanelsTest, WithoutASessionTheyShowTheWayToBegin) {
  PanelDriver panels;
  const PanelOutput& output = panels.Frame();
  EXPECT_THAT(output.commands, IsEmpty());
  EXPECT_FALSE(output.mesh.commands.empty());
  EXPECT_TRUE(std::any_of(output.texts.begin(), output.texts.end(), [](const PanelText& text) {
    return text.text.starts_with("Draw a closed outline");
  }));
}

TEST(PanelsTest, ATapOnUndoUndoes) {
  PanelDriver panels;
  panels.view.session = HouseBeforePick(1);
  EXPECT_THAT(panels.Tap("Tools/Undo"), ElementsAre(PanelCommand(Command(Undo{}))));
}

TEST(PanelsTest, WhatCantBeDoneCantBeTapped) {
  PanelDriver panels;
  panels.view.session = HouseBeforePick(1);
  EXPECT_FALSE(panels.Find("Tools/Redo").enabled);
  EXPECT_THAT(panels.Tap("Tools/Redo"), IsEmpty());
}

TEST(PanelsTest, ATapOnASuggestionPicksIt) {
  PanelDriver panels;
  panels.view.session = HouseBeforePick(1);
  EXPECT_THAT(panels.Tap("Suggestions/1 Extrude 19 m"),
              ElementsAre(PanelCommand(Command(Pick{1, "extrude"}))));
}

TEST(PanelsTest, HoveringASuggestionPreviewsIt) {
  PanelDriver panels;
  panels.view.session = HouseBeforePick(1);
  EXPECT_FALSE(panels.Frame().preview);
  EXPECT_EQ(panels.Hover("Suggestions/1 Extrude 19 m").preview, std::optional<size_t>(0));
}

bool SaysNote(const PanelOutput& output, const std::string& words) {
  return std::any_of(output.texts.begin(), output.texts.end(),
                     [&](const PanelText& text) { return text.text == words; });
}

TEST(PanelsTest, ANoteGoesWhereItsButtonIsPressedUntilThePointerHasLeft) {
  PanelDriver panels;
  panels.view.session = WholeHouse();
  EXPECT_TRUE(SaysNote(panels.Hover("Menu/Rules"), "Rules   R"));
  const Vec2 at = MiddleOf(panels.Find("Menu/Rules"));
  panels.Frame({PanelPointer{at, true}, PanelPointer{at, false}});
  EXPECT_FALSE(SaysNote(panels.Frame(), "Rules   R")) << "it would lie on what was opened";
  panels.Frame({PanelPointer{{600, 400}, false}});
  EXPECT_TRUE(SaysNote(panels.Hover("Menu/Rules"), "Rules   R"));
}

TEST(PanelsTest, EnterPressesWhatTabCameTo) {
  PanelDriver panels;
  panels.view.session = HouseBeforePick(1);
  EXPECT_THAT(panels.PressByKeys("Tools/Undo"), ElementsAre(PanelCommand(Command(Undo{}))));
}

TEST(PanelsTest, ThePointerIsTheirsOnlyOverThem) {
  PanelDriver panels;
  EXPECT_TRUE(panels.Hover("Tools/Undo").takes_pointer);
  EXPECT_FALSE(panels.Frame({PanelPointer{{800, 500}, false}}).takes_pointer);
  EXPECT_FALSE(panels.Frame({PanelPointer{{800, 500}, true}}).takes_pointer);
}

}  // namespace
}  // namespace parti::app::tests
