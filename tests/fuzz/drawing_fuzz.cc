// Any bytes as a drawing: the reader never crashes, what it keeps can be written, and what is
// written reads back the same and whole. Its events, sensible or not, go through the state machines
// of hands, which keep their promises.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/check.h"
#include "input/drawing.h"
#include "input/gestures.h"
#include "input/key_repeat.h"
#include "input/palm_arbitration.h"
#include "input/pen_bindings.h"
#include "input/stroke_predictor.h"
#include "input/strokes_from_events.h"

namespace parti::input {
namespace {

void Gesture(const TouchEvent& touch, Gestures* gestures) {
  for (const auto& gesture : gestures->Feed({touch, touch.position_mm * 4.0, 4})) {
    const auto* pan = std::get_if<PanZoomGesture>(&gesture);
    CHECK(!pan || (std::isfinite(pan->scale) && pan->scale > 0), "zooming stays within reason");
  }
}

void Handle(const std::vector<InputEvent>& events) {
  PalmArbitration palms;
  Gestures gestures;
  PenBindings bindings;
  StrokePredictor predictor;
  KeyRepeat repeat;
  gestures.SetFingerDraws(events.size() % 2 == 1);
  for (const InputEvent& event : events) {
    const Passage passage = palms.Feed(event);
    for (const TouchEvent& cancelled : passage.cancelled) Gesture(cancelled, &gestures);
    const auto* touch = std::get_if<TouchEvent>(&event);
    if (touch && passage.passes) Gesture(*touch, &gestures);
    for (const PenDrag& drag : bindings.Feed(event)) {
      CHECK(drag.act != PenAct::kNone, "drags are for something");
      if (drag.phase == DragPhase::kBegin) predictor.Begin();
      predictor.Add(drag.event.position_mm, drag.event.t_s);
      CHECK(IsFinite(*predictor.Predict(0.016)), "predictions are places");
    }
    repeat.Feed(event);
    if (const auto due_s = repeat.Due_s()) CHECK(repeat.Tick(*due_s), "what is due comes");
  }
}

}  // namespace
}  // namespace parti::input

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace parti::input;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const DrawingReading reading = ReadDrawing(text, "fuzz.pen");
  CHECK(!reading.damage || reading.damage->place, "damage has a place");
  if (reading.damage) parti::FormatError(*reading.damage);
  const auto written = WriteDrawing(reading.drawing);
  CHECK(written, "what was read can be written");
  const DrawingReading again = ReadDrawing(*written);
  CHECK(!again.damage, "what was written is whole");
  CHECK(again.drawing == reading.drawing, "what was written is what was read");
  StrokesOf(reading.drawing.events);
  Handle(reading.drawing.events);
  return 0;
}
