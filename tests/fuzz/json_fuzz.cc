// Any bytes as JSON, a stroke, a vector: a value that keeps its contract, or an error that prints.
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "base/json.h"

namespace {

void CheckStroke(const parti::Stroke& stroke) {
  for (size_t i = 0; i < stroke.size(); ++i) {
    CHECK(parti::IsFinite(stroke[i].position), "positions are finite");
    CHECK(i == 0 || stroke[i].t_s >= stroke[i - 1].t_s, "time does not run backwards");
    const double pressure = stroke[i].pressure.value_or(0);
    CHECK(pressure >= 0 && pressure <= 1, "pressure is in range");
  }
}

template <typename T>
void CheckError(const parti::Result<T>& result) {
  CHECK(result || !parti::FormatError(result.error()).empty(), "an error says what is wrong");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto parsed = parti::ParseJson(text, "fuzz");
  CheckError(parsed);
  if (!parsed) return 0;
  const auto stroke = parti::StrokeFrom(*parsed, "points");
  CheckError(stroke);
  if (stroke) CheckStroke(*stroke);
  CheckError(parti::Vec3From(*parsed, "point"));
  CheckError(parti::NumberFrom(*parsed, "number"));
  return 0;
}
