// Any bytes as a drawing: the reader never crashes, what it keeps can be written, and what is
// written reads back the same and whole.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "input/drawing.h"
#include "input/strokes_from_events.h"

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
  return 0;
}
