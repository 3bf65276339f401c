#include "grammar/operations/split_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/polygon.h"

namespace parti::grammar {
namespace {

/// Counts this near to a whole number are it: 60 m hold 3 m twenty times, whatever rounding says.
constexpr double kWholeCount = 1e-9;

/// What a list of sizes asks for: metres, and shares of what is left.
struct Demand {
  double fixed = 0;
  double floating = 0;
};

class Resolver {
 public:
  Resolver(double length, std::vector<SplitPiece>* pieces)
      : length_(length), tolerance_(CutTolerance(length)), pieces_(pieces) {}

  /// Lays `list` out over [low, high]; successors are numbered from `number`.
  Result<void> Lay(std::span<const Successor> list, double low, double high, int number);
  /// Repeats `pattern` over [low, high] on its own.
  Result<void> Repeat(std::span<const Successor> pattern, double low, double high);

 private:
  Demand DemandOf(const Size& size) const {
    const double value = std::max(0.0, size.value);
    switch (size.kind) {
      case Size::Kind::kAbsolute:
        return {value, 0};
      case Size::Kind::kRelative:
        return {value * length_, 0};
      case Size::Kind::kFloating:
        return {0, value};
    }
    return {};
  }

  /// Without the groups, or with each of them once.
  Demand DemandOf(std::span<const Successor> list, bool with_groups) const {
    Demand sum;
    for (const Successor& s : list) {
      if (!s.repeat.empty() && !with_groups) continue;
      const Demand d =
          s.repeat.empty() ? DemandOf(std::get<Size>(s.key)) : DemandOf(s.repeat, true);
      sum.fixed += d.fixed;
      sum.floating += d.floating;
    }
    return sum;
  }

  Result<double> CountOf(const Demand& pattern, double share, bool rest_floats) const;
  Result<void> LayGroup(std::span<const Successor> pattern, double low, double high, double count,
                        int number);
  Result<void> Add(double low, double high, const Successor& successor, int number);

  double length_;
  double tolerance_;
  std::vector<SplitPiece>* pieces_;
};

int LeavesIn(std::span<const Successor> list) {
  int count = 0;
  for (const Successor& s : list) count += s.repeat.empty() ? 1 : LeavesIn(s.repeat);
  return count;
}

Result<void> TooMany() {
  return Fail(ErrorCode::kLimitReached,
              fmt::format("split would make more than {} pieces", kMostSplitPieces),
              "repeat with a larger size");
}

/// How often a pattern repeats in `share` metres.
Result<double> Resolver::CountOf(const Demand& pattern, double share, bool rest_floats) const {
  const double nominal = pattern.fixed + pattern.floating;
  if (!(nominal > kLengthTolerance_m)) {
    return Fail(ErrorCode::kBadArguments, "a split repeats a pattern that has no size",
                "give at least one size greater than 0 in { … }*");
  }
  const double times = share / nominal;
  double count;
  if (pattern.floating > 0) {
    count = std::max(1.0, std::round(times));
    const double most = std::max(1.0, std::floor(share / pattern.fixed + kWholeCount));
    if (pattern.fixed > 0) count = std::min(count, most);
  } else {
    const double slack = kWholeCount * std::max(1.0, times);
    count = rest_floats ? std::floor(times + slack) : std::ceil(times - slack);
  }
  if (count > kMostSplitPieces) return tl::unexpected<Error>(TooMany().error());
  return std::max(0.0, count);
}

Result<void> Resolver::Add(double low, double high, const Successor& successor, int number) {
  if (high - low <= kLengthTolerance_m) return {};
  if (pieces_->size() >= kMostSplitPieces) return TooMany();
  pieces_->push_back({low, high, number, successor.symbol == kNil});
  return {};
}

/// Each repetition of a pattern without floating sizes has its own size, else an equal part of
/// [low, high].
Result<void> Resolver::LayGroup(std::span<const Successor> pattern, double low, double high,
                                double count, int number) {
  const Demand demand = DemandOf(pattern, true);
  const double step = demand.floating > 0 ? (high - low) / count : demand.fixed;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double from = low + step * i;
    double to = low + step * (i + 1);
    if (to > high - tolerance_) to = high;
    if (to - from <= tolerance_) return {};
    if (auto laid = Lay(pattern, from, to, number); !laid) return laid;
  }
  return {};
}

Result<void> Resolver::Repeat(std::span<const Successor> pattern, double low, double high) {
  const auto count = CountOf(DemandOf(pattern, true), high - low, false);
  if (!count) return Fail(count);
  return LayGroup(pattern, low, high, *count, 0);
}

Result<void> Resolver::Lay(std::span<const Successor> list, double low, double high, int number) {
  const Demand own = DemandOf(list, false);
  Demand total = own;
  const auto groups =
      std::count_if(list.begin(), list.end(), [](const Successor& s) { return !s.repeat.empty(); });
  const double share = groups == 0 ? 0
                                   : std::max(0.0, high - low - own.fixed - own.floating) /
                                         static_cast<double>(groups);
  const bool floats = DemandOf(list, true).floating > 0;
  for (const Successor& s : list) {
    if (s.repeat.empty()) continue;
    const Demand pattern = DemandOf(s.repeat, true);
    const auto count = CountOf(pattern, share, floats);
    if (!count) return Fail(count);
    total.fixed += *count * pattern.fixed;
    total.floating += *count * pattern.floating;
  }
  const double scale =
      total.floating > 0 ? std::max(0.0, high - low - total.fixed) / total.floating : 0;
  double at = low;
  for (const Successor& s : list) {
    const bool is_group = !s.repeat.empty();
    const Demand d = is_group ? DemandOf(s.repeat, true) : DemandOf(std::get<Size>(s.key));
    const double count = is_group ? *CountOf(d, share, floats) : 1;
    const bool fills_share = is_group && !floats;
    double end = fills_share ? at + share : at + count * (d.fixed + scale * d.floating);
    if (end > high - tolerance_) end = high;
    auto laid = is_group ? LayGroup(s.repeat, at, end, count, number) : Add(at, end, s, number);
    if (!laid) return laid;
    number += is_group ? LeavesIn(s.repeat) : 1;
    at = std::max(at, end);
  }
  return {};
}

}  // namespace

Result<void> ResolveSplit(std::span<const Successor> successors, double length_m,
                          std::vector<SplitPiece>* pieces) {
  return Resolver(length_m, pieces).Lay(successors, 0, length_m, 0);
}

Result<void> ResolveRepeat(std::span<const Successor> pattern, double length_m,
                           std::vector<SplitPiece>* pieces) {
  return Resolver(length_m, pieces).Repeat(pattern, 0, length_m);
}

}  // namespace parti::grammar
