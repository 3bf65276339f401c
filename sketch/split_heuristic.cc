// split and repeat: lines across an item, evenly spaced or not (Jesus 2018, 6.5.3; errata 21).
#include <algorithm>
#include <numeric>
#include <optional>

#include "grammar/operation.h"
#include "sketch/actions.h"
#include "sketch/heuristic_geometry.h"
#include "sketch/heuristics.h"
#include "sketch/made_edges.h"

namespace parti::sketch {
namespace {

struct SplitAxis {
  const grammar::Item* item;
  int index;
  double whole_m;
  HeuristicParameters parameters;
};

bool InPlaneOf(const grammar::Item& item, const Segment3& line, double near_m) {
  return !grammar::IsFlat(item.type) ||
         (std::abs(line.a.z) <= near_m && std::abs(line.b.z) <= near_m);
}

// Where the fittest reading at right angles to the axis cuts it; nothing on the item's own ends,
// where a split has its implicit planes.
std::optional<double> CutOf(const WorldLine& line, const SplitAxis& axis) {
  const double margin = axis.parameters.plane_relative * axis.whole_m;
  const double near_m = axis.parameters.near_relative * DiagonalOf(*axis.item);
  Vec3 unit(0, 0, 0);
  unit[axis.index] = 1;
  for (const LiftCandidate& reading : ReadingsOf(line)) {
    const Segment3 local{axis.item->scope.ToLocal(reading.world.a),
                         axis.item->scope.ToLocal(reading.world.b)};
    if (!InPlaneOf(*axis.item, local, near_m)) continue;
    if (!Orthogonal(DirectionOf(local), unit, Angle::Degrees(axis.parameters.angle_deg))) continue;
    const double cut = (local.a[axis.index] + local.b[axis.index]) / 2;
    if (cut > margin && cut < axis.whole_m - margin) return cut;
  }
  return std::nullopt;
}

// Cuts near each other are one plane, at their mean. Ascending.
std::vector<double> PlanesOf(std::vector<double> cuts, double reach_m) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<double> planes;
  for (size_t i = 0; i < cuts.size();) {
    size_t end = i + 1;
    while (end < cuts.size() && cuts[end] - cuts[end - 1] <= reach_m) ++end;
    const double sum = std::accumulate(cuts.begin() + static_cast<std::ptrdiff_t>(i),
                                       cuts.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
    planes.push_back(sum / static_cast<double>(end - i));
    i = end;
  }
  return planes;
}

std::vector<double> SizesBetween(const std::vector<double>& planes, double whole_m) {
  std::vector<double> sizes;
  double last = 0;
  for (const double plane : planes) {
    sizes.push_back(plane - last);
    last = plane;
  }
  sizes.push_back(whole_m - last);
  return sizes;
}

// The same number for sizes that differ by at most reach_m from the smallest of their group.
std::vector<int> EqualGroups(const std::vector<double>& sizes, double reach_m) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t i, size_t j) { return sizes[i] < sizes[j]; });
  std::vector<int> groups(sizes.size());
  int group = -1;
  double smallest = 0;
  for (const size_t i : order) {
    if (group < 0 || sizes[i] - smallest > reach_m) {
      ++group;
      smallest = sizes[i];
    }
    groups[i] = group;
  }
  return groups;
}

std::vector<double> GroupMeans(const std::vector<double>& sizes, const std::vector<int>& groups) {
  std::vector<double> means(sizes.size());
  for (size_t i = 0; i < sizes.size(); ++i) {
    double sum = 0, count = 0;
    for (size_t j = 0; j < sizes.size(); ++j) {
      if (groups[j] != groups[i]) continue;
      sum += sizes[j];
      ++count;
    }
    means[i] = sum / count;
  }
  return means;
}

// Groups of two and more, as dial numbers: a split's only dials are its sizes, in their order.
std::vector<std::vector<size_t>> TiesOf(const std::vector<int>& groups) {
  std::vector<std::vector<size_t>> ties(groups.size());
  for (size_t i = 0; i < groups.size(); ++i) ties[static_cast<size_t>(groups[i])].push_back(i);
  std::erase_if(ties, [](const std::vector<size_t>& tie) { return tie.size() < 2; });
  return ties;
}

double DeviationOverMean(const std::vector<double>& sizes) {
  const double n = static_cast<double>(sizes.size());
  const double mean = std::accumulate(sizes.begin(), sizes.end(), 0.0) / n;
  double sum = 0;
  for (const double size : sizes) sum += (size - mean) * (size - mean);
  return std::sqrt(sum / n) / mean;
}

Segment3 Along(const SplitAxis& axis) {
  Vec3 from = axis.item->scope.size / 2.0, to = from;
  from[axis.index] = 0;
  to[axis.index] = axis.whole_m;
  return {axis.item->scope.ToWorld(from), axis.item->scope.ToWorld(to)};
}

// Free cuts can be told in any order, so that each set of them is that much likelier.
double LogOrders(size_t free_cuts) { return std::lgamma(static_cast<double>(free_cuts) + 1); }

void AddSplits(const std::vector<double>& sizes, const SplitAxis& axis,
               std::vector<Hypothesis>* hypotheses) {
  const grammar::Operation* split = grammar::FindOperation("split");
  if (!split) return;
  const auto name = static_cast<grammar::Axis>(axis.index);
  const std::vector<int> groups = EqualGroups(sizes, axis.parameters.equal_relative * axis.whole_m);
  std::vector<int> each(sizes.size());
  std::iota(each.begin(), each.end(), 0);
  const auto ties = TiesOf(groups);
  hypotheses->push_back({SplitAction(*split, name, sizes, each)});
  hypotheses->back().price = -LogOrders(sizes.size() - 1);
  if (ties.empty()) return;
  Hypothesis tied{SplitAction(*split, name, GroupMeans(sizes, groups), groups)};
  tied.equal = ties;
  tied.spaced_along = Along(axis);
  size_t tied_sizes = 0;
  for (const std::vector<size_t>& tie : ties) tied_sizes += tie.size() - 1;
  tied.price = axis.parameters.tie * static_cast<double>(tied_sizes) -
               LogOrders(sizes.size() - 1 - tied_sizes);
  const bool all_alike = ties.front().size() == sizes.size();
  if (all_alike && sizes.size() > 2) tied.price = axis.parameters.repeat_is_meant;
  hypotheses->push_back(std::move(tied));
}

void AddRepeat(const std::vector<double>& sizes, const SplitAxis& axis,
               std::vector<Hypothesis>* hypotheses) {
  const grammar::Operation* repeat = grammar::FindOperation("repeat");
  if (!repeat || DeviationOverMean(sizes) > axis.parameters.repeat_deviation) return;
  const double size_m = axis.whole_m / static_cast<double>(sizes.size());
  Hypothesis even{RepeatAction(*repeat, static_cast<grammar::Axis>(axis.index), size_m)};
  even.spaced_along = Along(axis);
  if (sizes.size() == 2) even.price = axis.parameters.repeat_of_two;
  hypotheses->push_back(std::move(even));
}

void AddAlong(const SplitAxis& axis, const Configuration& configuration,
              std::vector<Hypothesis>* hypotheses) {
  std::vector<double> cuts;
  for (const WorldLine& line : configuration.lines) {
    const auto cut = CutOf(line, axis);
    if (!cut && !axis.parameters.partly) return;
    if (cut) cuts.push_back(*cut);
  }
  if (cuts.empty()) return;
  const std::vector<double> planes =
      PlanesOf(std::move(cuts), axis.parameters.plane_relative * axis.whole_m);
  const std::vector<double> sizes = SizesBetween(planes, axis.whole_m);
  AddSplits(sizes, axis, hypotheses);
  AddRepeat(sizes, axis, hypotheses);
}

}  // namespace

std::vector<Hypothesis> SplitHeuristic(const Configuration& configuration,
                                       const grammar::Item& item,
                                       const HeuristicParameters& parameters) {
  std::vector<Hypothesis> hypotheses;
  const int axes = grammar::IsFlat(item.type) ? 2 : 3;
  for (int index = 0; index < axes; ++index) {
    const double whole_m = item.scope.size[index];
    if (whole_m <= 0) continue;
    AddAlong({&item, index, whole_m, parameters}, configuration, &hypotheses);
  }
  return hypotheses;
}

}  // namespace parti::sketch
