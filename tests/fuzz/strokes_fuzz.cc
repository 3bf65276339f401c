// Any bytes as a line of `parti segment`: a stroke is refused with words, or its answer is whole.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "base/json.h"
#include "sketch/segmentation.h"

namespace {

void CheckWhole(const parti::sketch::Segmentation& answer, const parti::Stroke& stroke) {
  CHECK(answer.corners.size() == answer.segments.size() + 1, "a segment between two corners");
  CHECK(!answer.segments.empty(), "at least one segment");
  CHECK(answer.corners.front() == 0, "the first sample is a corner");
  CHECK(answer.corners.back() + 1 == static_cast<int>(stroke.size()), "and so is the last");
  for (size_t i = 0; i < answer.segments.size(); ++i) {
    CHECK(answer.segments[i].from == answer.corners[i], "segments lie between corners");
    CHECK(answer.segments[i].to == answer.corners[i + 1], "segments lie between corners");
    CHECK(answer.corners[i] < answer.corners[i + 1], "corners come in order");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const auto json = parti::ParseJson({reinterpret_cast<const char*>(data), size}, "fuzz.jsonl");
  if (!json || !json->is_object()) return 0;
  const auto stroke = parti::StrokeFrom(json->value("points", parti::Json()), "points");
  if (!stroke) {
    parti::FormatError(stroke.error());
    return 0;
  }
  const auto answer = parti::sketch::SegmentStroke(*stroke);
  if (answer) {
    CheckWhole(*answer, *stroke);
  } else {
    CHECK(!answer.error().message.empty(), "a refusal says why");
  }
  return 0;
}
