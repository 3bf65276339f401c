// Where panels stand in a window of any shape, for either hand: pure functions.
// What is in them is the panels'; cards beside the pen are cards.h's.
#pragma once

#include <span>

#include "app/panels/box.h"

namespace parti::app::panels {

/// The window shared out. Tools are on the side of the hand that does not draw.
struct Layout {
  Box room;   ///< all of the window but its margin
  Box title;  ///< the document's name
  Box menu;   ///< the buttons that open sheets
  Box tools;  ///< as tall as its buttons need
  int tool_columns = 1;
  Box sheets;  ///< where sheets may lie: beside the tools, if the window is that wide
  Box rules;   ///< tree and node; over the drawing where the window is narrow
  Box bottom;  ///< what status.h may take: as high as it needs, from below
  Box free;    ///< what is left between them, for cards beside the pen
};

/// What a layout depends on.
struct LayoutNeeds {
  Vec2 size_px{1600, 1000};
  double scale = 1;  ///< used, not wanted (theme.h)
  bool left_handed = false;
  bool rules_shown = true;
  int tools = 10;
  int menu_buttons = 4;
  float bottom_px = 44;  ///< height of the status line
};

/// Everything lies within the window; title, menu, tools and bottom never overlap at the sizes that
/// UsedScale leaves.
Layout LayoutOf(const LayoutNeeds& needs);

/// A sheet of this size under a button, or over it where there is more room, within `room`.
Box SheetAt(const Box& button, float width, float height, const Box& room, float gap);

/// A word about what a pen hovers over: beside its tip and above it, on the side away from the
/// hand, where there is room on the other; within `room` where it fits at all. It moves up,
/// down or aside to cover none of `controls`, as far as a sheet is wide at most; else it covers as
/// few as it can.
Box WordBeside(const Vec2& pen_px, float width, float height, const Box& room, bool left_handed,
               double scale, std::span<const Box> controls = {});

}  // namespace parti::app::panels
