#include "input/strokes_from_events.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace parti::input {
namespace {

int DeviceOf(const InputEvent& event) {
  return std::visit([](const auto& e) { return e.device; }, event);
}

}  // namespace

std::optional<PenStroke> StrokesFromEvents::Feed(const InputEvent& event) {
  const ContactChange change = contacts_.Feed(event);
  std::optional<PenStroke> finished;
  if (change.ended) finished = Take(DeviceOf(event), *change.ended);
  if (change.began || change.moved) Append(std::get<PenEvent>(event));
  return finished;
}

std::vector<PenStroke> StrokesFromEvents::Finish() {
  std::vector<PenStroke> cut = std::move(in_progress_);
  for (PenStroke& stroke : cut) stroke.end = StrokeEnd::kEndOfStream;
  *this = {};
  return cut;
}

std::optional<PenStroke> StrokesFromEvents::Take(int device, StrokeEnd end) {
  const auto found = std::find_if(in_progress_.begin(), in_progress_.end(),
                                  [&](const PenStroke& s) { return s.device == device; });
  if (found == in_progress_.end()) return std::nullopt;
  std::optional<PenStroke> stroke = std::move(*found);
  in_progress_.erase(found);
  stroke->end = end;
  return stroke;
}

void StrokesFromEvents::Append(const PenEvent& event) {
  if (!IsFinite(event.position_mm) || !std::isfinite(event.t_s)) return;
  auto stroke = std::find_if(in_progress_.begin(), in_progress_.end(),
                             [&](const PenStroke& s) { return s.device == event.device; });
  if (stroke == in_progress_.end()) {
    in_progress_.push_back({.device = event.device, .tool = event.tool, .samples = {}});
    stroke = std::prev(in_progress_.end());
  }
  PenSample sample{event.position_mm, event.t_s, event.pressure, event.tilt_deg};
  if (!stroke->samples.empty()) sample.t_s = std::max(sample.t_s, stroke->samples.back().t_s);
  stroke->samples.push_back(sample);
}

std::vector<PenStroke> StrokesOf(const std::vector<InputEvent>& events) {
  StrokesFromEvents machine;
  std::vector<PenStroke> strokes;
  for (const InputEvent& event : events) {
    if (auto stroke = machine.Feed(event)) strokes.push_back(std::move(*stroke));
  }
  auto cut = machine.Finish();
  std::move(cut.begin(), cut.end(), std::back_inserter(strokes));
  return strokes;
}

}  // namespace parti::input
