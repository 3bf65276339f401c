// Ui's keyboard focus: Tab goes through everything that can be tapped in the order drawn, arrows go
// to what lies that way, Enter and the space bar press it.
#include <imgui_internal.h>
#include <linux/input-event-codes.h>

#include "app/panels/ui.h"

namespace parti::app::panels {
namespace {

/// How far `to` lies from `from` in a direction; sideways counts double. Negative: not that way.
float Way(const Box& from, const Box& to, int dx, int dy) {
  const float x = to.middle_x() - from.middle_x(), y = to.middle_y() - from.middle_y();
  const float along = x * static_cast<float>(dx) + y * static_cast<float>(dy);
  const float across = std::abs(x * static_cast<float>(dy)) + std::abs(y * static_cast<float>(dx));
  return along <= 1 || across > 3 * along ? -1 : along + 2 * across;
}

}  // namespace

void Ui::MoveFocus(const KeyEvent& key) {
  if (key.code == KEY_TAB) {
    if (!editing_.empty()) ImGui::ClearActiveID();  // the field takes what was typed
    FocusNext(ImGui::GetIO().KeyShift ? -1 : 1);
  }
  if (!editing_.empty() || focus_.empty() || ImGui::GetIO().KeyShift) return;
  const bool arrow =
      key.code == KEY_LEFT || key.code == KEY_RIGHT || key.code == KEY_UP || key.code == KEY_DOWN;
  took_key_ = took_key_ || arrow || key.code == KEY_ESC;
  switch (key.code) {
    case KEY_ESC:
      return focus_.clear();
    case KEY_LEFT:
      return FocusBeside(-1, 0);
    case KEY_RIGHT:
      return FocusBeside(1, 0);
    case KEY_UP:
      return FocusBeside(0, -1);
    case KEY_DOWN:
      return FocusBeside(0, 1);
    default:
      return;
  }
}

void Ui::FocusNext(int step) {
  const auto n = static_cast<int>(places_before_.size());
  if (n == 0) return;
  const auto at = std::find_if(places_before_.begin(), places_before_.end(),
                               [&](const Place& place) { return place.name == focus_; });
  const auto i = static_cast<int>(at - places_before_.begin());
  const int next = i == n ? (step > 0 ? 0 : n - 1) : (i + step + n) % n;
  focus_ = places_before_[static_cast<size_t>(next)].name;
  focus_moved_ = took_key_ = true;
}

void Ui::FocusBeside(int dx, int dy) {
  const auto at = std::find_if(places_before_.begin(), places_before_.end(),
                               [&](const Place& place) { return place.name == focus_; });
  if (at == places_before_.end()) return;
  const Place* nearest = nullptr;
  float least = 0;
  for (const Place& place : places_before_) {
    const float way = Way(at->box, place.box, dx, dy);
    if (way < 0 || (nearest && way >= least)) continue;
    nearest = &place;
    least = way;
  }
  if (!nearest) return;
  focus_ = nearest->name;
  focus_moved_ = true;
}

bool Ui::TakeEnter(const std::string& full) {
  if (focus_ != full || !editing_.empty() || !key_ || !key_->pressed || key_->repeat) return false;
  const bool enter =
      key_->code == KEY_ENTER || key_->code == KEY_KPENTER || key_->code == KEY_SPACE;
  if (enter) {
    key_.reset();
    took_key_ = true;
  }
  return enter;
}

void Ui::ShowFocus(const std::string& full, const Box& box) {
  if (focus_ != full) return;
  const Box ring = box.Inset(U(1.5f));
  list()->AddRect({ring.x0, ring.y0}, {ring.x1, ring.y1}, palette_->accent_text,
                  U(kMeasures.small_radius), 0, U(2));
  if (focus_moved_) ScrollTo(box);
}

}  // namespace parti::app::panels
