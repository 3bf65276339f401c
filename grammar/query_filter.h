// The filters that queries know, and what each asks of a shape (Jesus 2018, 5.3.1; errata 10, 11).
// Not responsible for volumes and distances (query_region.h).
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grammar/query.h"

namespace parti::grammar {

/// What stands in a filter's parentheses.
enum class FilterArguments : uint8_t {
  kNone,
  kOneOrTwoCounts,
  kArea,
  kVolume,
  kQuery,
  kQueryAndMetres
};

/// All that is known of a filter: the table that parser, help and completion share.
struct FilterRow {
  std::string_view name;
  FilterArguments arguments;
  std::string_view doc;  ///< in plain words, for help and completion
};

/// All rows, in the order of the manual.
std::span<const FilterRow> Filters();
/// nullptr when there is none.
const FilterRow* FindFilter(std::string_view name);
/// errors  kUnknownName  with "did you mean".
Result<const FilterRow*> FilterNamed(std::string_view name);

/// How many numbers the volume takes; 0 for one that does not exist.
size_t NumbersOfVolume(std::string_view volume);

/// errors  kBadArguments  numbers that the filter does not take, each explained.
Result<void> CheckFilter(const Filter& filter);

using ShapeTest = std::function<bool(ShapeIndex)>;

/// The filter as a test of the tree's shapes; the tree must outlive it. Geometric filters take the
/// product of their inner query here, once.
/// errors  those of FilterNamed, CheckFilter and of the inner query's ProductOf.
Result<ShapeTest> TestOf(const Filter& filter, const ShapeTree& tree);

/// The one of the six directions that a unit normal has; "" for none (errata 10). Angles within
/// 1e-9 of a sector's border count as on it.
std::string_view DirectionOf(const Vec3& facing);

}  // namespace parti::grammar
