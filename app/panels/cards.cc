#include "app/panels/cards.h"

#include <algorithm>
#include <array>

namespace parti::app::panels {
namespace {

constexpr float kTip = 24;  ///< what a hand covers beyond the pen's tip
constexpr float kGap = 16;  ///< between cards and a stroke beside them
constexpr float kAbove =
    60;  ///< above it, clear of a hand at its end and of the word beside the pen

float Units(double scale, float units) { return static_cast<float>(scale * units); }

/// In the order in which they are wanted.
std::array<Box, 8> PlacesOf(const CardNeeds& needs) {
  const Box &stroke = needs.stroke, &room = needs.room;
  const float width = needs.width, height = needs.height, gap = Units(needs.scale, kGap);
  const float x0 = stroke.x0 - gap - width, x1 = stroke.x1 + gap;
  const float y0 = stroke.y0 - Units(needs.scale, kAbove) - height, y1 = stroke.y1 + gap;
  const float near = needs.left_handed ? x1 : x0, far = needs.left_handed ? x0 : x1;
  const float level = stroke.middle_y() - height / 2;
  return {
      BoxAt(near, level, width, height),
      BoxAt(stroke.middle_x() - width / 2, y0, width, height),
      BoxAt(far, level, width, height),
      BoxAt(stroke.middle_x() - width / 2, y1, width, height),
      BoxAt(room.x0, room.y0, width, height),
      BoxAt(room.x1 - width, room.y0, width, height),
      BoxAt(room.x0, room.y1 - height, width, height),
      BoxAt(room.x1 - width, room.y1 - height, width, height),
  };
}

std::ptrdiff_t Covered(const Box& box, const std::vector<Box>& things) {
  return std::count_if(things.begin(), things.end(),
                       [&](const Box& thing) { return box.Overlaps(thing); });
}

}  // namespace

Box HandAt(const Vec2& pen_px, bool left_handed, double scale) {
  const auto x = static_cast<float>(pen_px.x), y = static_cast<float>(pen_px.y);
  const float tip = Units(scale, kTip), width = Units(scale, 300), height = Units(scale, 320);
  return left_handed ? Box{x - width, y - tip, x + tip, y + height}
                     : Box{x - tip, y - tip, x + width, y + height};
}

Box StandingCards::Stand(const CardNeeds& now) {
  const bool same_size =
      std::abs(at.width() - now.width) < 0.5f && std::abs(at.height() - now.height) < 0.5f;
  const bool clear = now.clear_of == needs.clear_of || Covered(at, now.clear_of) == 0;
  if (now.stroke == needs.stroke && now.room == needs.room && same_size && clear) {
    needs.clear_of = now.clear_of;
    return at;
  }
  needs = now;
  return at = CardsBeside(now);
}

Box CardsBeside(const CardNeeds& needs) {
  const Box& stroke = needs.stroke;
  const auto is_under_hand = [&](const Box& place) {
    return needs.pen_px && place.Overlaps(HandAt(*needs.pen_px, needs.left_handed, needs.scale));
  };
  std::array<Box, 8> places = PlacesOf(needs);
  const Box* best = nullptr;
  std::ptrdiff_t least = 0;
  for (Box& place : places) {
    place = Within(place, needs.room);
    if (place.Overlaps(stroke) || is_under_hand(place)) continue;
    const std::ptrdiff_t covered = Covered(place, needs.clear_of);
    if (best && covered >= least) continue;
    best = &place;
    least = covered;
  }
  if (best) return *best;
  const Vec2 pen = needs.pen_px.value_or(Vec2(stroke.middle_x(), stroke.middle_y()));
  return *std::max_element(places.begin(), places.end(), [&](const Box& a, const Box& b) {
    return a.DistanceTo(pen) < b.DistanceTo(pen);
  });
}

}  // namespace parti::app::panels
