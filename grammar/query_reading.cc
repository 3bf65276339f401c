#include "grammar/query_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "grammar/operation.h"
#include "grammar/query_filter.h"

namespace parti::grammar {
namespace {

std::string Ordinal(double number) {
  const auto n = static_cast<int64_t>(number);
  const bool teen = n % 100 >= 11 && n % 100 <= 13;
  const int64_t last = teen ? 0 : n % 10;
  return fmt::format("{}{}", n, last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

/// Words before the noun: "even", "3rd"; "" for filters that follow it.
std::string Adjective(const Filter& filter) {
  constexpr std::array<std::string_view, 5> kPlain = {"first", "last", "middle", "even", "odd"};
  if (std::find(kPlain.begin(), kPlain.end(), filter.name) != kPlain.end()) return filter.name;
  if (filter.name == "leaf") return "visible";
  if (filter.name != "nth") return "";
  if (filter.numbers.size() == 1) return Ordinal(filter.numbers[0]);
  return fmt::format("{} and each {} following", Ordinal(filter.numbers[0]),
                     Ordinal(filter.numbers[1]));
}

std::string Volume(const Filter& filter) {
  if (!filter.queries.empty()) return ReadingOf(filter.queries[0]);
  return fmt::format("{}({})", filter.volume, fmt::join(filter.numbers, ", "));
}

/// Words after the noun.
std::string Clause(const Filter& filter) {
  const std::string& name = filter.name;
  if (name == "ends") return " at either end";
  if (name == "inside") return " inside " + Volume(filter);
  if (name == "intersects") return " touching " + Volume(filter);
  if (name == "facing") return " looking at " + ReadingOf(filter.queries.at(0));
  if (name == "within") {
    return fmt::format(" at most {} m from {}", filter.numbers.at(0),
                       ReadingOf(filter.queries.at(0)));
  }
  if (name == "larger") return fmt::format(" larger than {} m²", filter.numbers.at(0));
  if (name == "smaller") return fmt::format(" smaller than {} m²", filter.numbers.at(0));
  return " facing " + name;
}

std::string ReadingOf(const QuerySelector& selector) {
  std::string words = "every";
  for (const Filter& filter : selector.filters) {
    if (const std::string adjective = Adjective(filter); !adjective.empty()) {
      words += " " + adjective;
    }
  }
  words += " " + (selector.symbol.empty() ? std::string("shape") : selector.symbol);
  if (!selector.operation.empty()) {
    std::string name = selector.operation;
    for (const Operation& row : Operations()) {
      if (row.word == selector.operation) name = row.name;
    }
    words += " made by " + name;
  }
  if (!selector.tags.empty()) words += fmt::format(" tagged {}", fmt::join(selector.tags, " and "));
  for (const Filter& filter : selector.filters) {
    if (Adjective(filter).empty()) words += Clause(filter);
  }
  return words;
}

std::string_view WordOf(Query::Relation relation) {
  switch (relation) {
    case Query::Relation::kDescendants:
      return " in ";
    case Query::Relation::kChildren:
      return " directly in ";
    case Query::Relation::kSiblings:
      break;
  }
  return " beside ";
}

}  // namespace

std::string ReadingOf(const Query& query) {
  std::string words;
  for (size_t i = query.selectors.size(); i-- > 0;) {
    words += ReadingOf(query.selectors[i]);
    if (i > 0) words += WordOf(query.relations[i - 1]);
  }
  return words;
}

}  // namespace parti::grammar
