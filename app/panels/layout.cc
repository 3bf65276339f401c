#include "app/panels/layout.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "app/panels/theme.h"

namespace parti::app::panels {
namespace {

/// Mirrored about the middle of the window.
Box Mirrored(const Box& box, float width) {
  return {width - box.x1, box.y0, width - box.x0, box.y1};
}

constexpr int kMostLines = 8, kMostSteps = 8;  ///< that a word moves up or down, and aside

/// How far a word may move, first not at all, then up or down, then aside and up or down.
std::vector<Vec2> WaysOut(float line, float step) {
  std::vector<Vec2> ways;
  for (int aside = 0; aside <= kMostSteps; ++aside) {
    for (int up = 0; up <= kMostLines; ++up) ways.emplace_back(aside * step, up * line);
  }
  return ways;
}

float Units(double scale, float units) { return static_cast<float>(scale * units); }

}  // namespace

Layout LayoutOf(const LayoutNeeds& needs) {
  const auto u = [&](float units) { return Units(needs.scale, units); };
  const Box window{0, 0, static_cast<float>(needs.size_px.x), static_cast<float>(needs.size_px.y)};
  const float target = u(kMeasures.target), gap = u(kMeasures.gap), pad = u(kMeasures.pad);
  Layout layout;
  layout.room = window.Inset(pad);
  Box rest = layout.room;
  layout.bottom = rest.CutBottom(needs.bottom_px, pad);
  Box head = rest.CutTop(target + 2 * gap, pad);
  const auto buttons = static_cast<float>(needs.menu_buttons);
  layout.menu = head.CutRight(buttons * (target + gap) + gap, pad);
  layout.title = head.CutLeft(std::min(head.width(), u(300)));

  const float one = target + gap;
  const auto rows_in_one = static_cast<int>((rest.height() - gap) / one);
  layout.tool_columns =
      std::max(1, (needs.tools + std::max(1, rows_in_one) - 1) / std::max(1, rows_in_one));
  const int rows = (needs.tools + layout.tool_columns - 1) / layout.tool_columns;
  const auto columns = static_cast<float>(layout.tool_columns);
  Box side = rest.CutLeft(columns * one + gap, pad);
  layout.tools = side.CutTop(static_cast<float>(rows) * one + gap);

  layout.sheets = layout.room;
  if (layout.room.x1 - rest.x0 >= u(kMeasures.sheet)) layout.sheets.x0 = rest.x0;

  Box column = rest;
  layout.rules = column.CutRight(std::min(u(kMeasures.column), column.width()), pad);
  layout.free = needs.rules_shown && column.width() > u(300) ? column : rest;
  if (needs.left_handed) {
    for (Box* box : {&layout.title, &layout.menu, &layout.tools, &layout.sheets, &layout.rules,
                     &layout.free}) {
      *box = Mirrored(*box, window.x1);
    }
  }
  return layout;
}

Box SheetAt(const Box& button, float width, float height, const Box& room, float gap) {
  const bool down = room.y1 - button.y1 >= button.y0 - room.y0;
  const float most = down ? room.y1 - button.y1 - gap : button.y0 - gap - room.y0;
  const float h = std::min(height, most), w = std::min(width, room.width());
  const float y = down ? button.y1 + gap : button.y0 - gap - h;
  const bool left = button.middle_x() < room.middle_x();
  return Within(BoxAt(left ? button.x0 : button.x1 - w, y, w, h), room);
}

Box WordBeside(const Vec2& pen_px, float width, float height, const Box& room, bool left_handed,
               double scale, std::span<const Box> controls) {
  const auto x = static_cast<float>(pen_px.x), y = static_cast<float>(pen_px.y);
  const float aside = Units(scale, 10), above = Units(scale, 26), below = Units(scale, 14);
  const float left = x - aside - width, right = x + aside;
  const float near = left_handed ? right : left, far = left_handed ? left : right;
  std::optional<Box> best;
  std::ptrdiff_t least = 0;
  for (const Vec2& away : WaysOut(height + Units(scale, 4), Units(scale, 48))) {
    const auto up = static_cast<float>(away.y), out = static_cast<float>(away.x);
    const float over = y - above - height - up, under = y + below + up;
    const float out_near = near + (left_handed ? out : -out),
                out_far = far + (left_handed ? -out : out);
    for (const Box& place :
         {BoxAt(out_near, over, width, height), BoxAt(out_far, over, width, height),
          BoxAt(out_near, under, width, height), BoxAt(out_far, under, width, height)}) {
      const Box moved = Within(place, room);
      if (moved.x0 != place.x0 || moved.y0 != place.y0) continue;
      const auto covered = std::count_if(controls.begin(), controls.end(),
                                         [&](const Box& box) { return place.Overlaps(box); });
      if (covered == 0) return place;
      if (!best || covered < least) {
        best = place;
        least = covered;
      }
    }
  }
  return best ? *best : Within(BoxAt(near, y - above - height, width, height), room);
}

}  // namespace parti::app::panels
