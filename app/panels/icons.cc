#include "app/panels/icons.h"

#include <imgui.h>

#include <array>
#include <charconv>
#include <string_view>

namespace parti::app::panels {
namespace {

/// Drawings on a square of 24 units, y down. "m x y" starts a line and "l x y" goes on; "z" closes
/// it; "a x y r from to" is an arc in degrees from the right, clockwise; "d x y r" a dot.
struct Drawing {
  Icon icon;
  std::string_view lines;
};

constexpr Drawing kDrawings[] = {
    {Icon::kDraw, "m 4 20 l 5 15.5 l 16 4.5 l 19.5 8 l 8.5 19 z m 13.5 7 l 17 10.5"},
    {Icon::kErase,
     "m 8.5 19.5 l 4 15 l 14 5 l 20 11 l 11.5 19.5 z m 9 10 l 15 16 m 11 19.5 l 20 19.5"},
    {Icon::kSelect, "m 5 4 l 19 11 l 12.5 12.5 l 9.5 19 z"},
    {Icon::kOrbit, "a 12 12 8 200 480 m 3.2 12.8 l 4.4 9.2 l 7.8 10.8 d 12 12 1.8"},
    {Icon::kPan,
     "m 12 3 l 12 21 m 3 12 l 21 12 m 9.5 5.5 l 12 3 l 14.5 5.5 m 9.5 18.5 l 12 21 l 14.5 18.5 "
     "m 5.5 9.5 l 3 12 l 5.5 14.5 m 18.5 9.5 l 21 12 l 18.5 14.5"},
    {Icon::kZoom,
     "a 10.5 10.5 6.5 0 360 m 15.3 15.3 l 20.5 20.5 m 7.5 10.5 l 13.5 10.5 m 10.5 7.5 l 10.5 13.5"},
    {Icon::kFit,
     "m 3.5 8 l 3.5 3.5 l 8 3.5 m 16 3.5 l 20.5 3.5 l 20.5 8 m 20.5 16 l 20.5 20.5 l 16 20.5 "
     "m 8 20.5 l 3.5 20.5 l 3.5 16 m 8 9 l 12 7 l 16 9 l 16 15 l 12 17 l 8 15 z"},
    {Icon::kUndo, "m 8.5 4.5 l 4 9 l 8.5 13.5 m 4 9 l 14.5 9 a 14.5 14 5 270 450 m 14.5 19 l 9 19"},
    {Icon::kRedo,
     "m 15.5 4.5 l 20 9 l 15.5 13.5 m 20 9 l 9.5 9 a 9.5 14 5 270 90 m 9.5 19 l 15 19"},
    {Icon::kFinger,
     "m 10 13.5 l 10 5 a 11.75 5 1.75 180 360 m 13.5 5 l 13.5 11 l 18 12 l 18.5 16 l 16.5 20.5 "
     "l 10.5 20.5 l 5.5 14.5 l 7 13 l 10 15.5"},
    {Icon::kDocument, "m 6 3.5 l 14 3.5 l 18.5 8 l 18.5 20.5 l 6 20.5 z m 14 3.5 l 14 8 l 18.5 8"},
    {Icon::kNew,
     "m 6 3.5 l 14 3.5 l 18.5 8 l 18.5 20.5 l 6 20.5 z m 12 10 l 12 17 m 8.5 13.5 l 15.5 13.5"},
    {Icon::kOpen,
     "m 3.5 19 l 3.5 5.5 l 9 5.5 l 11 8 l 18 8 l 18 11 m 3.5 19 l 6.5 11 l 21 11 l 18 19 z"},
    {Icon::kSave, "m 12 3.5 l 12 14 m 8 10 l 12 14 l 16 10 m 4 14.5 l 4 20 l 20 20 l 20 14.5"},
    {Icon::kFolder, "m 3.5 19 l 3.5 5.5 l 9 5.5 l 11 8 l 20.5 8 l 20.5 19 z"},
    {Icon::kBookmark, "m 7 3.5 l 17 3.5 l 17 20.5 l 12 16.5 l 7 20.5 z"},
    {Icon::kExport, "m 12 14.5 l 12 3.5 m 8 7.5 l 12 3.5 l 16 7.5 m 5 11 l 5 20 l 19 20 l 19 11"},
    {Icon::kRules,
     "m 4 4 l 10 4 l 10 8.5 l 4 8.5 z m 7 8.5 l 7 18.5 l 13 18.5 m 7 12.5 l 13 12.5 "
     "m 13 10.5 l 20 10.5 l 20 14.5 l 13 14.5 z m 13 16.5 l 20 16.5 l 20 20.5 l 13 20.5 z"},
    {Icon::kSettings,
     "m 4 7 l 12.5 7 m 17.5 7 l 20 7 a 15 7 2.5 0 360 m 4 17 l 6.5 17 m 11.5 17 l 20 17 "
     "a 9 17 2.5 0 360"},
    {Icon::kClose, "m 6 6 l 18 18 m 18 6 l 6 18"},
    {Icon::kUp, "m 6 14.5 l 12 8.5 l 18 14.5"},
    {Icon::kDown, "m 6 9.5 l 12 15.5 l 18 9.5"},
    {Icon::kLeft, "m 14.5 6 l 8.5 12 l 14.5 18"},
    {Icon::kRight, "m 9.5 6 l 15.5 12 l 9.5 18"},
    {Icon::kDelete,
     "m 4.5 7 l 19.5 7 m 9 7 l 9 4 l 15 4 l 15 7 m 6.5 7 l 7.5 20.5 l 16.5 20.5 l 17.5 7 "
     "m 10.3 11 l 10.5 17 m 13.7 11 l 13.5 17"},
    {Icon::kGrip, "d 9 6 1.4 d 15 6 1.4 d 9 12 1.4 d 15 12 1.4 d 9 18 1.4 d 15 18 1.4"},
    {Icon::kPlus, "m 12 5.5 l 12 18.5 m 5.5 12 l 18.5 12"},
    {Icon::kMinus, "m 5.5 12 l 18.5 12"},
    {Icon::kReset, "a 12 12.5 7.5 300 570 m 15.2 2.5 l 15.7 6 l 12.2 7.2"},
    {Icon::kEye,
     "m 2.5 12 l 6.5 7.8 l 12 6 l 17.5 7.8 l 21.5 12 l 17.5 16.2 l 12 18 l 6.5 16.2 z a 12 12 3 0 "
     "360"},
    {Icon::kEyeOff,
     "m 2.5 12 l 6.5 7.8 l 12 6 l 17.5 7.8 l 21.5 12 l 17.5 16.2 l 12 18 l 6.5 16.2 z m 4 20 l 20 "
     "4"},
    {Icon::kCheck, "m 5 12.5 l 10 17.5 l 19 7"},
    {Icon::kWarning, "m 12 3.5 l 21.5 20 l 2.5 20 z m 12 9.5 l 12 14.5 d 12 17.2 1.1"},
    {Icon::kLock,
     "m 5.5 11 l 18.5 11 l 18.5 20.5 l 5.5 20.5 z m 8 11 l 8 8 a 12 8 4 180 360 m 16 8 l 16 11"},
    {Icon::kBusy,
     "m 7 3.5 l 17 3.5 m 7 20.5 l 17 20.5 m 8 3.5 l 8 7 l 16 17 l 16 20.5 m 16 3.5 l 16 7 l 8 17 l "
     "8 20.5"},
    {Icon::kHint,
     "a 12 10 6 135 405 m 7.8 14.3 l 9.5 17 l 14.5 17 l 16.2 14.3 m 10 20.5 l 14 20.5"},
    {Icon::kSun,
     "a 12 12 4 0 360 m 12 2.5 l 12 5 m 12 19 l 12 21.5 m 2.5 12 l 5 12 m 19 12 l 21.5 12 "
     "m 5.3 5.3 l 7 7 m 17 17 l 18.7 18.7 m 5.3 18.7 l 7 17 m 17 7 l 18.7 5.3"},
    {Icon::kMoon,
     "a 12 12 8.5 -10 280 m 20.4 10.5 l 17.5 13 l 14 12.8 l 11.3 10 l 11.5 6.5 l 13.5 3.6"},
    {Icon::kBackspace,
     "m 8.5 5.5 l 21 5.5 l 21 18.5 l 8.5 18.5 l 2.5 12 z m 11.5 9 l 17.5 15 m 17.5 9 l 11.5 15"},
    {Icon::kEnter, "m 20 5 l 20 13 l 4.5 13 m 8.5 9 l 4.5 13 l 8.5 17"},
    {Icon::kShift, "m 12 4 l 20 12.5 l 16 12.5 l 16 20 l 8 20 l 8 12.5 l 4 12.5 z"},
    {Icon::kExtrude,
     "m 4 17.5 l 12 21 l 20 17.5 l 12 14 z m 12 11 l 12 2.5 m 8.5 6 l 12 2.5 l 15.5 6"},
    {Icon::kComp,
     "m 3.5 9 l 3.5 18 l 10 21 l 10 12 z m 13.5 12.5 l 13.5 21 l 20.5 18 l 20.5 9.5 z "
     "m 4.5 5.5 l 12 2.5 l 19.5 5.5 l 12 8.5 z"},
    {Icon::kSplitUpward, "m 5 3.5 l 19 3.5 l 19 20.5 l 5 20.5 z m 5 15.5 l 19 15.5 m 5 8 l 19 8"},
    {Icon::kSplitAcross, "m 3.5 5 l 20.5 5 l 20.5 19 l 3.5 19 z m 8 5 l 8 19 m 15.5 5 l 15.5 19"},
    {Icon::kRepeatUpward,
     "m 5 3.5 l 19 3.5 l 19 20.5 l 5 20.5 z m 5 7.75 l 19 7.75 m 5 12 l 19 12 m 5 16.25 l 19 "
     "16.25"},
    {Icon::kRepeatAcross,
     "m 3.5 5 l 20.5 5 l 20.5 19 l 3.5 19 z m 7.75 5 l 7.75 19 m 12 5 l 12 19 m 16.25 5 l 16.25 "
     "19"},
    {Icon::kOffset, "m 3.5 4.5 l 20.5 4.5 l 20.5 19.5 l 3.5 19.5 z m 8 9 l 16 9 l 16 15 l 8 15 z"},
    {Icon::kColor, "m 12 3 l 17 9.5 l 18 13 a 12 14 6 -10 190 m 6 13 l 7 9.5 l 12 3"},
    {Icon::kTag, "m 3.5 4 l 11 4 l 20.5 13.5 l 13.5 20.5 l 3.5 11 z d 7.8 8.2 1.5"},
    {Icon::kOperation,
     "m 12 3 l 20 7.5 l 20 16.5 l 12 21 l 4 16.5 l 4 7.5 z m 4 7.5 l 12 12 l 20 7.5 m 12 12 l 12 "
     "21"},
    {Icon::kRecord, "a 12 12 8.5 0 360 d 12 12 4"},
    {Icon::kSameSize,
     "m 3.5 6.5 l 10.5 6.5 l 10.5 17.5 l 3.5 17.5 z m 13.5 6.5 l 20.5 6.5 l 20.5 17.5 l 13.5 17.5 "
     "z"},
    {Icon::kAlignLeft,
     "m 4 3.5 l 4 20.5 m 7 6 l 19 6 l 19 10.5 l 7 10.5 z m 7 13.5 l 14 13.5 l 14 18 l 7 18 z"},
    {Icon::kCenterAcross,
     "m 12 3 l 12 6 m 12 10.5 l 12 13.5 m 12 18 l 12 21 m 5 6 l 19 6 l 19 10.5 l 5 10.5 z "
     "m 8 13.5 l 16 13.5 l 16 18 l 8 18 z"},
    {Icon::kAlignRight,
     "m 20 3.5 l 20 20.5 m 5 6 l 17 6 l 17 10.5 l 5 10.5 z m 10 13.5 l 17 13.5 l 17 18 l 10 18 z"},
    {Icon::kAlignTop,
     "m 3.5 4 l 20.5 4 m 6 7 l 10.5 7 l 10.5 19 l 6 19 z m 13.5 7 l 18 7 l 18 14 l 13.5 14 z"},
    {Icon::kCenterUp,
     "m 3 12 l 6 12 m 10.5 12 l 13.5 12 m 18 12 l 21 12 m 6 5 l 10.5 5 l 10.5 19 l 6 19 z "
     "m 13.5 8 l 18 8 l 18 16 l 13.5 16 z"},
    {Icon::kAlignBottom,
     "m 3.5 20 l 20.5 20 m 6 5 l 10.5 5 l 10.5 17 l 6 17 z m 13.5 10 l 18 10 l 18 17 l 13.5 17 z"},
    {Icon::kQuery, "a 10.5 10.5 6.5 0 360 m 15.3 15.3 l 20.5 20.5"},
};

std::string_view LinesOf(Icon icon) {
  for (const Drawing& drawing : kDrawings) {
    if (drawing.icon == icon) return drawing.lines;
  }
  return {};
}

/// Reads a drawing and draws it.
class Pen {
 public:
  Pen(ImDrawList* list, const Box& box, Color color, float stroke)
      : list_(list), color_(color), stroke_(stroke) {
    unit_ = std::min(box.width(), box.height()) / 24;
    // Lines that lie on half pixels are sharp.
    x0_ = std::floor(box.middle_x() - 12 * unit_) + 0.5f;
    y0_ = std::floor(box.middle_y() - 12 * unit_) + 0.5f;
  }

  void Draw(std::string_view lines) {
    rest_ = lines;
    while (!rest_.empty()) Step();
    Lift(false);
  }

 private:
  void Step() {
    const char what = rest_.front();
    rest_.remove_prefix(1);
    if (what == 'm') Lift(false);
    if (what == 'm' || what == 'l') {
      const ImVec2 p = Point();
      list_->PathLineTo(p);
    } else if (what == 'z') {
      Lift(true);
    } else if (what == 'a') {
      Arc();
    } else if (what == 'd') {
      Lift(false);
      const ImVec2 p = Point();
      list_->AddCircleFilled(p, Number() * unit_, color_);
    }
  }

  void Arc() {
    Lift(false);
    const ImVec2 p = Point();
    const float radius = Number() * unit_;
    const float from = Radians(Number()), to = Radians(Number());
    list_->PathArcTo(p, radius, from, to, 24);
  }

  void Lift(bool closed) {
    if (list_->_Path.Size > 1) {
      list_->PathStroke(color_, closed ? ImDrawFlags_Closed : 0, stroke_);
    }
    list_->PathClear();
  }

  static float Radians(float degrees) { return degrees * static_cast<float>(kPi / 180); }

  ImVec2 Point() {
    const float x = Number();
    return {x0_ + x * unit_, y0_ + Number() * unit_};
  }

  float Number() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    float number = 0;
    const auto read = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    rest_.remove_prefix(static_cast<size_t>(read.ptr - rest_.data()));
    return number;
  }

  ImDrawList* list_;
  Color color_;
  float stroke_;
  float unit_, x0_, y0_;
  std::string_view rest_;
};

}  // namespace

void DrawIcon(ImDrawList* list, Icon icon, const Box& box, Color color, float stroke_px) {
  Pen(list, box, color, stroke_px).Draw(LinesOf(icon));
}

}  // namespace parti::app::panels
