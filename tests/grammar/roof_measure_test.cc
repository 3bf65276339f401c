// Roofs and offsets on random, jittered and real outlines, all of them
// right. Prints one line per class. Times are of the processor, so that other programs don't count;
// they are printed, not asserted (tests/bench/roofs_bench.cc measures them). PARTI_OUTLINES=20
// tries twenty times as many random outlines.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "grammar/polygon_setback.h"
#include "grammar/roof.h"
#include "tests/grammar/roof_checks.h"
#include "tests/grammar/roof_shapes.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

/// Seeds of a class that has `usual` of them by default.
uint64_t Seeds(uint64_t usual) {
  const char* times = std::getenv("PARTI_OUTLINES");
  return usual * (times != nullptr ? std::max(1UL, std::strtoul(times, nullptr, 10)) : 1);
}

/// What happened to the outlines of one class.
class Tally {
 public:
  explicit Tally(std::string name) : name_(std::move(name)) {}
  ~Tally() {
    fmt::print("{:<22} {:>4} outlines, {:>5} of {:>5} right, slowest {:5.1f} ms\n", name_,
               outlines_, right_, tried_, slowest_ms_);
    EXPECT_EQ(right_, tried_) << name_;
    EXPECT_GT(tried_, 0) << name_;
  }
  Tally(const Tally&) = delete;
  Tally& operator=(const Tally&) = delete;

  void Add(const Polygon& polygon) {
    ++outlines_;
    Try("hip", [&] { return Wrong(polygon, HipRoof(polygon, {false, 35}, 0)); });
    Try("gable", [&] { return Wrong(polygon, GableRoof(polygon, {false, 40}, {}, Vec2(0, -1))); });
    Try("setback", [&] { return WrongSetback(polygon, 1.5); });
    const double distance = outlines_ % 2 == 0 ? 0.4 : 2.0;
    Try("inset", [&] { return WrongInset(polygon, distance); });
    Try("outset", [&] { return WrongOutset(polygon, distance); });
  }

 private:
  static std::string Wrong(const Polygon& polygon, const Result<Mesh>& roof) {
    return roof ? WrongWithRoof(polygon, *roof) : roof.error().message;
  }

  static std::string WrongInset(const Polygon& polygon, double distance) {
    const auto pieces = Offset(polygon, distance);
    if (!pieces) return pieces.error().message;
    const std::string wrong = WrongWithInset(polygon, *pieces, distance);
    if (!wrong.empty()) return wrong;
    double sum = 0;
    for (const Polygon& piece : *pieces) sum += Area(piece);
    for (const Polygon& piece : Border(polygon, *pieces)) sum += Area(piece);
    const bool adds_up = std::abs(sum - Area(polygon)) <= kAreaWithin * Area(polygon);
    return adds_up ? "" : "inside and border are not the whole";
  }

  static std::string WrongOutset(const Polygon& polygon, double distance) {
    const auto pieces = Offset(polygon, -distance);
    if (!pieces) return pieces.error().message;
    if (pieces->size() != 1) return "an outset in several pieces";
    const Polygon& grown = pieces->front();
    for (const Vec2& p : polygon.outer) {
      if (!Contains(grown, p)) return "a corner lies outside of the outset";
      if (DistanceToBorder(grown, p) < distance - kFlatWithin_m) return "a corner is too near";
    }
    return Area(grown) > Area(polygon) ? "" : "the outset is too small";
  }

  /// Every third edge moves.
  static std::string WrongSetback(const Polygon& polygon, double distance) {
    size_t count = polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
    std::vector<EdgeSetback> edges(count);
    for (size_t i = 0; i < count; i += 3) edges[i] = {distance, 0};
    const auto parts = Setback(polygon, edges);
    if (!parts) return parts.error().message;
    double sum = 0;
    for (const Polygon& piece : parts->strips[0]) sum += Area(piece);
    for (const Polygon& piece : parts->remainder) sum += Area(piece);
    const bool adds_up = std::abs(sum - Area(polygon)) <= kAreaWithin * Area(polygon);
    return adds_up ? "" : "strips and remainder are not the whole";
  }

  void Try(std::string_view what, const std::function<std::string()>& make_and_check) {
    const std::clock_t start = std::clock();
    const std::string wrong = make_and_check();
    slowest_ms_ =
        std::max(slowest_ms_, 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    ++tried_;
    right_ += wrong.empty() ? 1 : 0;
    EXPECT_EQ(wrong, "") << name_ << " " << outlines_ - 1 << ", " << what;
  }

  std::string name_;
  int outlines_ = 0, tried_ = 0, right_ = 0;
  double slowest_ms_ = 0;
};

TEST(RoofMeasure, RandomPolygons) {
  for (const int corners : {12, 24}) {
    Tally stars(fmt::format("{}-gons, stars", corners));
    Tally tangles(fmt::format("{}-gons, tangles", corners));
    for (uint64_t seed = 0; seed < Seeds(200); ++seed) {
      Random random(seed);
      stars.Add({RandomStar(corners, &random), {}});
      tangles.Add({RandomTangle(corners, &random), {}});
    }
  }
}

TEST(RoofMeasure, LettersAsSurveysLeaveThem) {
  struct Survey {
    std::string_view name;
    int pieces;
    double jitter_m;
    uint64_t outlines;
  };
  for (const Survey& survey :
       {Survey{"exact", 1, 0, 20}, Survey{"2 cm", 1, 0.02, 100},
        Survey{"8 points, 5 cm", 8, 0.05, 100}, Survey{"8 points, 0.1 mm", 8, 1e-4, 20}}) {
    for (const auto& [letter, name] : kLetters) {
      Tally tally(fmt::format("{}, {}", name, survey.name));
      for (uint64_t seed = 0; seed < Seeds(survey.outlines); ++seed) {
        Random random(seed);
        const double turn = seed % 2 == 0 ? 0 : random.Uniform(0, 360);
        const Ring ring = Turned(LetterRing(letter, &random), turn);
        tally.Add({Surveyed(ring, survey.pieces, survey.jitter_m, &random), {}});
      }
    }
  }
}

TEST(RoofMeasure, Courtyards) {
  Tally tally("courtyards");
  for (uint64_t seed = 0; seed < Seeds(200); ++seed) {
    Random random(seed);
    Polygon polygon = seed % 2 == 0 ? Skyline(&random) : StarPolygon(&random);
    if (polygon.holes.empty()) continue;
    tally.Add(polygon);
  }
}

void AddFile(const std::string& path, std::string_view name) {
  Tally tally((std::string(name)));
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.empty()) continue;
    std::vector<Ring> rings;
    const auto json = nlohmann::json::parse(line);
    for (const auto& ring : json.at("rings")) {
      rings.emplace_back();
      for (const auto& p : ring) rings.back().emplace_back(p.at(0), p.at(1));
    }
    const auto polygon = PolygonFrom(rings);
    ASSERT_TRUE(polygon.has_value()) << line;
    tally.Add(*polygon);
  }
}

TEST(RoofMeasure, RealFootprints) {
  PARTI_NEED_DATA(path, "buildings/footprints-dev.jsonl");
  AddFile(path, "footprints");
}

TEST(RoofMeasure, RealPlots) {
  PARTI_NEED_DATA(path, "buildings/plots-dev.jsonl");
  AddFile(path, "plots");
}

}  // namespace
}  // namespace parti::grammar::tests
