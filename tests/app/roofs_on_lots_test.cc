// Roofs over every footprint of the real city models, from the file to the watertight mesh.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/lot.h"
#include "grammar/action_text.h"
#include "tests/support/data.h"

namespace parti::app::tests {
namespace {

/// Area of a roof as seen from above; its bottom, which looks down, is left out.
double AreaFromAbove(const grammar::Item& roof) {
  double area = 0;
  for (const grammar::Item& face : grammar::FacesOf(roof)) {
    area += std::max(0.0, face.facing.y) * grammar::AreaOf(face);
  }
  return area;
}

void ExpectRoofs(const std::string& path, const char* action_text) {
  const auto lots = ParseLots(path);
  ASSERT_TRUE(lots.has_value()) << lots.error().message;
  const auto action = grammar::ParseAction(action_text);
  ASSERT_TRUE(action.has_value());
  for (const Lot& lot : *lots) {
    const auto roof = grammar::Apply(*action, lot.item);
    ASSERT_TRUE(roof.has_value()) << lot.name << ": " << roof.error().message;
    ASSERT_EQ(roof->size(), 1u) << lot.name;
    const double whole = grammar::AreaOf(lot.item);
    EXPECT_NEAR(AreaFromAbove(roof->front().item), whole, 1e-3 * whole) << lot.name;
    EXPECT_GT(grammar::VolumeOf(roof->front().item), 0) << lot.name;
  }
  fmt::print("{}: {} roofs\n", action_text, lots->size());
}

TEST(RoofsOnLots, CityModelOfTheHague) {
  PARTI_NEED_DATA(path, "buildings/DH_01_subs.city.json");
  ExpectRoofs(path, "roofHip(35) Roof");
  ExpectRoofs(path, "roofGable(40) Roof");
}

TEST(RoofsOnLots, CityModelOfDelft) {
  PARTI_NEED_DATA(path, "buildings/delft_1b.json");
  ExpectRoofs(path, "roofHip(35) Roof");
  ExpectRoofs(path, "roofGable(40) Roof");
}

}  // namespace
}  // namespace parti::app::tests
