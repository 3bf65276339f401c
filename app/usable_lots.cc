#include "app/usable_lots.h"

#include <fmt/format.h>

#include <utility>

#include "app/lot_values.h"

namespace parti::app {
namespace {

constexpr std::string_view kRemedy = "--skip-bad-lots leaves such lots out";

tl::unexpected<Error> WithRemedy(Error error) {
  error.hint =
      error.hint.empty() ? std::string(kRemedy) : fmt::format("{}; {}", error.hint, kRemedy);
  return tl::unexpected<Error>(std::move(error));
}

/// Takes lots out whose properties rules don't take.
void SkipUnfit(const std::string& file, const RuleSource& source, const grammar::RuleSet& rules,
               std::vector<Lot>* lots, std::vector<Error>* skipped) {
  std::erase_if(*lots, [&](const Lot& lot) {
    const auto values = ValuesOf(lot, rules, source.settings);
    if (values) return false;
    skipped->push_back(values.error());
    skipped->back().message = fmt::format("{}: {}", file, skipped->back().message);
    return true;
  });
}

/// Takes lots out that rules fail on.
void SkipFailed(const std::string& file, const std::vector<grammar::LotFailures::One>& failures,
                std::vector<Lot>* lots, std::vector<Error>* skipped) {
  std::vector<Lot> rest;
  size_t next = 0;
  for (size_t i = 0; i < lots->size(); ++i) {
    if (next == failures.size() || failures[next].lot != i) {
      rest.push_back(std::move((*lots)[i]));
      continue;
    }
    Error& error = skipped->emplace_back(failures[next++].error);
    error.message = fmt::format("{}: lot '{}': {}", file, (*lots)[i].name, error.message);
  }
  *lots = std::move(rest);
}

/// errors  those of ParseLots, naming the remedy where there are better lots.
Result<std::vector<Lot>> ReadLots(const std::string& lot, bool skip_bad,
                                  std::vector<Error>* skipped) {
  if (skip_bad) return ParseLots(lot, skipped);
  auto lots = ParseLots(lot);
  std::vector<Error> others;
  if (!lots && ParseLots(lot, &others)) return WithRemedy(lots.error());
  return lots;
}

Result<std::shared_ptr<const Ground>> GroundFor(const std::vector<Lot>& lots,
                                                std::shared_ptr<const RuleSource> source,
                                                const grammar::RuleSet& rules,
                                                const grammar::RuleThreads& threads,
                                                grammar::LotFailures* failures) {
  if (rules.rules.empty()) return GroundOf(lots);
  grammar::RuleThreads watched = threads;
  watched.failures = failures;
  return GroundOf(lots, std::move(source), rules, watched);
}

}  // namespace

Result<UsedLots> UseLots(const std::string& lot, const std::shared_ptr<const RuleSource>& source,
                         const grammar::RuleSet& rules, const grammar::RuleThreads& threads,
                         bool skip_bad) {
  UsedLots used;
  auto lots = ReadLots(lot, skip_bad, &used.skipped);
  if (!lots) return Fail(lots);
  SkipUnfit(lot, *source, rules, &*lots, &used.skipped);
  while (true) {
    if (lots->empty()) return tl::unexpected<Error>(used.skipped.front());
    if (!skip_bad && !used.skipped.empty()) return WithRemedy(used.skipped.front());
    grammar::LotFailures failures{skip_bad, {}};
    auto ground = GroundFor(*lots, source, rules, threads, &failures);
    if (ground) {
      used.ground = std::move(*ground);
      return used;
    }
    if (failures.found.empty() || (!skip_bad && lots->size() == 1)) return Fail(ground);
    if (!skip_bad) return WithRemedy(ground.error());
    SkipFailed(lot, failures.found, &*lots, &used.skipped);
  }
}

}  // namespace parti::app
