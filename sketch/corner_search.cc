#include "sketch/corner_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace parti::sketch {
namespace {

constexpr double kUnreached = std::numeric_limits<double>::infinity();

// The best way to a node, of those without a curve so far or of those with one.
struct Way {
  double cost = kUnreached;
  int previous = -1;
  bool previous_has_curve = false;
  bool after_curve = false;
};
using Ways = std::array<Way, 2>;  // [has a curve]

struct SegmentCosts {
  double length;  // what its length costs, of either kind
  double line;    // what its bow costs as a line
};

class Search {
 public:
  Search(const StrokePath& path, const std::vector<int>& candidates,
         const std::vector<double>& price, const SegmentationParameters& parameters)
      : path_(path), price_(price), p_(parameters), fits_(path) {
    nodes_.reserve(candidates.size() + 2);
    nodes_.push_back(0);
    nodes_.insert(nodes_.end(), candidates.begin(), candidates.end());
    nodes_.push_back(path.size() - 1);
    ways_.resize(nodes_.size());
    ways_[0][0].cost = 0;
  }

  std::vector<ChosenCorner> Run() {
    for (size_t to = 1; to < nodes_.size(); ++to) {
      for (size_t from = 0; from < to; ++from) Extend(from, to);
    }
    return Trace();
  }

 private:
  SegmentCosts CostsOf(size_t from, size_t to) const {
    const int steps = nodes_[to] - nodes_[from];
    const double length = steps * path_.step / path_.diagonal;
    const double bow = fits_.Bow(nodes_[from], nodes_[to]) / p_.usual_bow;
    return {p_.short_weight * std::max(0.0, std::log(p_.short_length / length)),
            p_.bow_weight * std::log1p(bow * bow)};
  }

  void Extend(size_t from, size_t to) {
    const SegmentCosts costs = CostsOf(from, to);
    const double corner = from > 0 ? price_[nodes_[from]] : 0;
    for (const bool has_curve : {false, true}) {
      const double base = ways_[from][has_curve].cost + corner + costs.length;
      const double curve = has_curve ? p_.further_curve_price : p_.curve_price;
      Offer(base + costs.line, from, has_curve, false, &ways_[to][has_curve]);
      Offer(base + curve, from, has_curve, true, &ways_[to][true]);
    }
  }

  static void Offer(double cost, size_t from, bool from_has_curve, bool curve, Way* way) {
    if (cost < way->cost) *way = {cost, static_cast<int>(from), from_has_curve, curve};
  }

  std::vector<ChosenCorner> Trace() const {
    std::vector<ChosenCorner> corners;
    bool has_curve = ways_.back()[true].cost < ways_.back()[false].cost;
    for (int at = static_cast<int>(nodes_.size()) - 1; at >= 0;) {
      const Way& way = ways_[at][has_curve];
      corners.push_back({nodes_[at], way.after_curve});
      at = way.previous;
      has_curve = way.previous_has_curve;
    }
    std::reverse(corners.begin(), corners.end());
    return corners;
  }

  const StrokePath& path_;
  const std::vector<double>& price_;
  const SegmentationParameters& p_;
  LineFits fits_;
  std::vector<int> nodes_;  // points of the path
  std::vector<Ways> ways_;
};

}  // namespace

std::vector<ChosenCorner> ChooseCorners(const StrokePath& path, const std::vector<int>& candidates,
                                        const std::vector<double>& price,
                                        const SegmentationParameters& parameters) {
  return Search(path, candidates, price, parameters).Run();
}

}  // namespace parti::sketch
