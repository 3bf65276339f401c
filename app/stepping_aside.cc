#include "app/stepping_aside.h"

#include <algorithm>
#include <cmath>

namespace parti::app {
namespace {

double DistanceTo(const PanelSheet& sheet, const Vec2& px) {
  return glm::distance(px, glm::clamp(px, sheet.low_px, sheet.high_px));
}

}  // namespace

void SteppingAside::SetSheets(const std::vector<PanelSheet>& sheets) {
  std::vector<Place> places;
  for (const PanelSheet& sheet : sheets) {
    const auto before = std::find_if(places_.begin(), places_.end(), [&](const Place& place) {
      return place.sheet.name == sheet.name;
    });
    places.push_back(before != places_.end() ? *before : Place{});
    if (before == places_.end()) places.back().level = params_.levels;  // there at once
    places.back().sheet = sheet;
  }
  places_ = std::move(places);
  opacities_.resize(places_.size());
  for (size_t i = 0; i < places_.size(); ++i) opacities_[i] = OpacityOf(places_[i]);
}

float SteppingAside::OpacityOf(const Place& place) const {
  const float there = static_cast<float>(place.level) / static_cast<float>(params_.levels);
  return place.aside ? 1 - there : there;
}

void SteppingAside::PenAt(const Vec2& px, double reach_px, double scale, double now_s) {
  if (!down_px_) down_px_ = px;
  draws_ = draws_ || glm::distance(px, *down_px_) > params_.slack_px * scale;
  if (!draws_) return;
  for (Place& place : places_) {
    if (!place.aside && DistanceTo(place.sheet, px) < reach_px) Turn(&place, now_s);
  }
}

void SteppingAside::PenLifted(double now_s) {
  down_px_.reset();
  draws_ = false;
  for (Place& place : places_) {
    if (place.aside) Turn(&place, now_s);
  }
}

/// Where it is on its way, it goes back from there.
void SteppingAside::Turn(Place* place, double now_s) const {
  place->aside = !place->aside;
  place->level = params_.levels - place->level;
  place->since_s = now_s - Step_s() * place->level;
}

bool SteppingAside::Step(double now_s) {
  bool changed = false;
  for (size_t i = 0; i < places_.size(); ++i) {
    Place& place = places_[i];
    while (place.level < params_.levels && NextOf(place) <= now_s) ++place.level;
    const float opacity = OpacityOf(place);
    changed |= opacity != opacities_[i];
    opacities_[i] = opacity;
  }
  return changed;
}

std::optional<double> SteppingAside::next_s() const {
  std::optional<double> next;
  for (const Place& place : places_) {
    if (place.level == params_.levels) continue;
    next = std::min(next.value_or(NextOf(place)), NextOf(place));
  }
  return next;
}

bool SteppingAside::IsOverSheet(const Vec2& px) const {
  return std::any_of(places_.begin(), places_.end(),
                     [&](const Place& place) { return !place.aside && place.sheet.Contains(px); });
}

}  // namespace parti::app
