// Any bytes as a file of lots (rings, GeoJSON, CityJSON): lots that can be built on, or an error
// for each that can't; never a crash.
#include <cmath>
#include <cstdint>

#include "app/lot.h"
#include "base/check.h"

namespace parti::app {
namespace {

void CheckLot(const Lot& lot) {
  CHECK(lot.item.type == grammar::ItemType::kPlanar, "a lot is a planar shape");
  const double area_m2 = grammar::AreaOf(lot.item);
  CHECK(std::isfinite(area_m2) && area_m2 > 0, "there is room on it");
  CHECK(lot.item.facing.y > 0.99, "it faces up");
  const Vec3& size = lot.item.scope.size;
  CHECK(size.x <= kWidestLot_m * 2 && size.y <= kWidestLot_m * 2, "no wider than lots are");
}

void Try(std::string_view text) {
  std::vector<Error> refused;
  const auto lots = LotsFrom(text, "fuzz.json", &refused);
  for (const Error& error : refused) CHECK(!FormatError(error).empty(), "a refusal says why");
  if (!lots) {
    CHECK(!FormatError(lots.error()).empty(), "an error says what is wrong");
    return;
  }
  CHECK(!lots->empty(), "no lot is an error");
  for (const Lot& lot : *lots) CheckLot(lot);
  const auto strict = LotsFrom(text, "fuzz.json");
  CHECK(strict.has_value() == refused.empty(), "a refused lot is an error where none may be");
}

}  // namespace
}  // namespace parti::app

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::app::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
