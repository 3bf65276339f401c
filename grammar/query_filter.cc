#include "grammar/query_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <unordered_map>

#include "grammar/query_region.h"

namespace parti::grammar {
namespace {

using enum FilterArguments;

constexpr std::array kFilters = {
    FilterRow{"north", kNone, "faces north (-z), within 45 degrees"},
    FilterRow{"south", kNone, "faces south (+z), within 45 degrees"},
    FilterRow{"east", kNone, "faces east (+x), within 45 degrees"},
    FilterRow{"west", kNone, "faces west (-x), within 45 degrees"},
    FilterRow{"up", kNone, "faces up, 45 degrees or more above the horizon"},
    FilterRow{"down", kNone, "faces down, 45 degrees or more below the horizon"},
    FilterRow{"first", kNone, "is the first of its siblings with the same symbol"},
    FilterRow{"last", kNone, "is the last of its siblings with the same symbol"},
    FilterRow{"middle", kNone, "is neither the first nor the last"},
    FilterRow{"ends", kNone, "is the first or the last"},
    FilterRow{"even", kNone, "is the second, fourth … of its siblings with the same symbol"},
    FilterRow{"odd", kNone, "is the first, third … of its siblings with the same symbol"},
    FilterRow{"nth", kOneOrTwoCounts, "nth(k): is the k-th; nth(k, step): and every step-th after"},
    FilterRow{"leaf", kNone, "has no children: is visible"},
    FilterRow{"inside", kVolume, "lies in the volume, or in a shape that the query selects"},
    FilterRow{"intersects", kVolume, "touches the volume, or a shape that the query selects"},
    FilterRow{"facing", kQuery, "looks towards a shape that the query selects"},
    FilterRow{"within", kQueryAndMetres, "is at most that far from a shape that the query selects"},
    FilterRow{"larger", kArea, "has more area than that many square metres"},
    FilterRow{"smaller", kArea, "has less area than that many square metres"},
};

/// Where shapes stand among their siblings with the same symbol, counted from 1 (errata 11); groups
/// of siblings are numbered when one of them is first asked for.
class Positions {
 public:
  explicit Positions(const ShapeTree& tree) : tree_(tree), numbers_(tree.size()) {}

  struct Number {
    uint32_t position = 0;
    uint32_t count = 0;
  };
  Number operator()(ShapeIndex i) {
    if (numbers_[i].position == 0) NumberSiblingsOf(i);
    return numbers_[i];
  }

 private:
  void NumberSiblingsOf(ShapeIndex i) {
    const ShapeIndex parent = tree_.node(i).parent;
    if (parent == kNoShape) {
      numbers_[i] = {1, 1};
      return;
    }
    std::unordered_map<NameId, uint32_t> counts;
    const ShapeIndex first = tree_.node(parent).first_child;
    for (ShapeIndex s = first; s != kNoShape; s = tree_.node(s).next_sibling) {
      numbers_[s].position = ++counts[tree_[s].symbol];
    }
    for (ShapeIndex s = first; s != kNoShape; s = tree_.node(s).next_sibling) {
      numbers_[s].count = counts[tree_[s].symbol];
    }
  }

  const ShapeTree& tree_;
  std::vector<Number> numbers_;
};

using PositionTest = std::function<bool(Positions::Number)>;

PositionTest PositionTestOf(const Filter& filter) {
  using Number = Positions::Number;
  const std::string& name = filter.name;
  const auto at_end = [](Number n) { return n.position == 1 || n.position == n.count; };
  if (name == "first") return [](Number n) { return n.position == 1; };
  if (name == "last") return [](Number n) { return n.position == n.count; };
  if (name == "ends") return at_end;
  if (name == "middle") return [at_end](Number n) { return !at_end(n); };
  if (name == "even") return [](Number n) { return n.position % 2 == 0; };
  if (name == "odd") return [](Number n) { return n.position % 2 == 1; };
  if (name != "nth") return nullptr;
  const double start = filter.numbers[0];
  const double step = filter.numbers.size() > 1 ? filter.numbers[1] : 0;
  return [start, step](Number n) {
    if (step == 0) return n.position == start;
    return n.position >= start && std::fmod(n.position - start, step) == 0;
  };
}

constexpr bool IsDirection(std::string_view name) {
  return name == "north" || name == "south" || name == "east" || name == "west" || name == "up" ||
         name == "down";
}

}  // namespace

std::span<const FilterRow> Filters() { return kFilters; }

const FilterRow* FindFilter(std::string_view name) {
  for (const FilterRow& row : kFilters) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

Result<const FilterRow*> FilterNamed(std::string_view name) {
  if (const FilterRow* row = FindFilter(name)) return row;
  std::vector<std::string> names;
  for (const FilterRow& row : kFilters) names.emplace_back(row.name);
  const auto meant = DidYouMean(name, names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no filter '{}'", name),
              meant ? fmt::format("did you mean '{}'?", *meant)
                    : "filters: north … down, first, last, middle, ends, even, odd, nth, leaf, "
                      "inside, intersects, facing, within, larger, smaller");
}

size_t NumbersOfVolume(std::string_view volume) {
  return volume == "sphere" ? 4 : volume == "box" ? 6 : volume == "cylinder" ? 5 : 0;
}

Result<void> CheckFilter(const Filter& filter) {
  const auto row = FilterNamed(filter.name);
  if (!row) return Fail(row);
  const auto fail = [&](std::string_view wanted) {
    return Fail(ErrorCode::kBadArguments, fmt::format("{} takes {}", filter.name, wanted));
  };
  const std::vector<double>& n = filter.numbers;
  const auto finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(n.begin(), n.end(), finite)) return fail("finite numbers");
  const auto is_count = [](double x) { return x >= 1 && x <= 1e9 && x == std::floor(x); };
  const bool one_query = filter.queries.size() == 1 && !filter.queries[0].selectors.empty();
  const bool no_query = filter.queries.empty() && filter.volume.empty();
  switch ((*row)->arguments) {
    case kNone:
      if (!n.empty() || !no_query) return fail("no arguments");
      break;
    case kOneOrTwoCounts:
      if (n.empty() || n.size() > 2 || !no_query || !std::all_of(n.begin(), n.end(), is_count)) {
        return fail("the first position and a step, whole numbers from 1: nth(2, 3)");
      }
      break;
    case kArea:
      if (n.size() != 1 || n[0] < 0 || !no_query) return fail("one area in square metres");
      break;
    case kVolume:
      if (filter.volume.empty() && n.empty() && one_query) break;
      if (!filter.queries.empty() || n.empty() || n.size() != NumbersOfVolume(filter.volume)) {
        return fail("sphere(x,y,z,r), box(x,y,z,w,h,d), cylinder(x,y,z,r,h) or (query)");
      }
      // The sizes are the numbers after the position.
      if (!std::all_of(n.begin() + 3, n.end(), [](double x) { return x >= 0; })) {
        return fail("a volume whose sizes are not negative");
      }
      break;
    case kQuery:
      if (!n.empty() || !one_query || !filter.volume.empty()) return fail("one query");
      break;
    case kQueryAndMetres:
      if (n.size() != 1 || n[0] < 0 || !one_query || !filter.volume.empty()) {
        return fail("a query and a distance in metres, not negative: within(#Door, 5)");
      }
      break;
  }
  return {};
}

std::string_view DirectionOf(const Vec3& facing) {
  constexpr double kBorder = 1e-9;
  const double across = std::hypot(facing.x, facing.z);
  if (!(across + std::abs(facing.y) > 0.5)) return "";  // none, or not a number
  if (std::abs(facing.y) >= across - kBorder) return facing.y > 0 ? "up" : "down";
  const double north = -facing.z;
  const double east = facing.x;
  // Going round clockwise from north, each sector holds its first border and not its last.
  const auto before = [](double a, double b) { return a < b - kBorder; };
  if (!before(east, -north) && before(east, north)) return "north";
  if (!before(east, north) && before(-north, east)) return "east";
  if (!before(-north, east) && before(north, east)) return "south";
  return "west";
}

Result<ShapeTest> TestOf(const Filter& filter, const ShapeTree& tree) {
  const auto checked = CheckFilter(filter);
  if (!checked) return Fail(checked);
  if (IsDirection(filter.name)) {
    return [&tree, name = filter.name](ShapeIndex i) {
      return DirectionOf(tree[i].item.facing) == name;
    };
  }
  if (filter.name == "leaf") return [&tree](ShapeIndex i) { return tree.IsLeaf(i); };
  if (const PositionTest test = PositionTestOf(filter)) {
    return [test, positions = std::make_shared<Positions>(tree)](ShapeIndex i) {
      return test((*positions)(i));
    };
  }
  return RegionTestOf(filter, tree);
}

}  // namespace parti::grammar
