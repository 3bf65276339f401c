#include "sketch/target.h"

#include <algorithm>
#include <functional>
#include <limits>

#include "sketch/stroke_reading.h"
#include "sketch/visibility.h"

namespace parti::sketch {
namespace {

struct Nearness {
  size_t item;
  double distance_px;  // mean over the drawn ends, each at most the reach
};

double DistanceToSegment(const Vec2& p, const Segment2& s) {
  const Vec2 along = s.b - s.a;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(p - s.a, along) / squared, 0.0, 1.0) : 0.0;
  return glm::distance(p, s.a + along * t);
}

double DistanceToEdges(const Vec2& p, const std::vector<Segment2>& edges, double reach_px) {
  double nearest = reach_px;
  for (const Segment2& edge : edges) nearest = std::min(nearest, DistanceToSegment(p, edge));
  return nearest;
}

std::vector<Segment2> ScreenEdges(const grammar::Item& item, const View& view) {
  std::vector<Segment2> edges;
  for (const Segment3& edge : grammar::EdgesOf(item)) {
    const auto screen = view.Project(edge);
    if (screen) edges.push_back(*screen);
  }
  return edges;
}

// Mean distance of the drawn ends from the item's edges: the reach for an item out of it, half the
// reach at most where the end lies over the item, as the corners of a rectangle on a roof do.
double MeanDistance(const std::vector<Vec2>& ends, size_t item,
                    std::span<const grammar::Item> items, const std::vector<Facet>& facets,
                    const View& view, double reach_px) {
  const std::vector<Segment2> edges = ScreenEdges(items[item], view);
  const auto own = std::ranges::equal_range(facets, item, std::less<>(), &Facet::item);
  double sum = 0;
  for (const Vec2& end : ends) {
    const bool over =
        std::ranges::any_of(own, [&](const Facet& facet) { return IsOver(end, facet, view); });
    sum += DistanceToEdges(end, edges, over ? reach_px / 2 : reach_px);
  }
  return sum / static_cast<double>(ends.size());
}

// A box on the screen, empty at first.
struct ScreenBox {
  Vec2 low{std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity()};

  void Add(const Vec2& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  bool Meets(const ScreenBox& other, double reach) const {
    return low.x <= other.high.x + reach && other.low.x <= high.x + reach &&
           low.y <= other.high.y + reach && other.low.y <= high.y + reach;
  }
};

ScreenBox BoxOf(const grammar::Item& item, const View& view) {
  ScreenBox box;
  for (const Segment2& edge : ScreenEdges(item, view)) {
    box.Add(edge.a);
    box.Add(edge.b);
  }
  return box;
}

std::vector<size_t> ItemsNear(const std::vector<Vec2>& ends, std::span<const grammar::Item> items,
                              const View& view, double reach_px) {
  ScreenBox sketch;
  for (const Vec2& end : ends) sketch.Add(end);
  std::vector<size_t> near;
  for (size_t i = 0; i < items.size(); ++i) {
    if (BoxOf(items[i], view).Meets(sketch, reach_px)) near.push_back(i);
  }
  return near;
}

// The items near the sketch, those whose edges the drawn ends lie nearest to first.
std::vector<Nearness> Shortlist(const std::vector<Vec2>& ends, std::span<const grammar::Item> items,
                                const std::vector<size_t>& near, const std::vector<Facet>& facets,
                                const View& view, const TargetParameters& target) {
  std::vector<Nearness> list;
  for (const size_t i : near) {
    list.push_back({i, MeanDistance(ends, i, items, facets, view, target.reach_px)});
  }
  std::ranges::stable_sort(list, std::less<>(), &Nearness::distance_px);
  return list;
}

std::vector<Vec2> LikeliestEnds(const std::vector<std::vector<StrokeReading>>& strokes) {
  std::vector<Vec2> ends;
  for (const std::vector<StrokeReading>& stroke : strokes) {
    for (const Segment2& line : stroke.front().lines) {
      ends.push_back(line.a);
      ends.push_back(line.b);
    }
  }
  return ends;
}

// A shape that may be meant, and the share of it that others hide.
struct Shown {
  size_t item;
  double hidden;
};

// Those of the shortlist that can be seen.
std::vector<Shown> ThoseShown(const std::vector<Nearness>& shortlist,
                              const std::vector<Facet>& facets, const View& view,
                              const TargetParameters& target) {
  std::vector<Shown> shown;
  int checked = 0;
  for (const Nearness& candidate : shortlist) {
    const int compared = static_cast<int>(shown.size());
    if (compared == target.most_compared || ++checked > target.most_checked) break;
    const double hidden = HiddenShare(candidate.item, facets, view);
    if (hidden < 1) shown.push_back({candidate.item, hidden});
  }
  return shown;
}

// The sketch read on each of the items, best first.
std::vector<RankedTarget> ReadOnAll(const std::vector<std::vector<StrokeReading>>& readings,
                                    const std::vector<Shown>& shown,
                                    std::span<const grammar::Item> items, const Camera& camera,
                                    const SketchParameters& parameters,
                                    const TargetParameters& target) {
  std::vector<RankedTarget> ranked;
  for (const auto& [item, hidden] : shown) {
    auto reading = ReadSketch(readings, items[item], camera, parameters);
    if (!reading) continue;
    const double score =
        reading->worth - target.hidden * hidden - target.lost_line * reading->lost_lines;
    ranked.push_back({item, score, hidden, std::move(*reading)});
  }
  std::ranges::stable_sort(ranked, std::greater<>(), &RankedTarget::score);
  return ranked;
}

}  // namespace

Result<std::vector<RankedTarget>> RankTargets(const std::vector<Stroke>& strokes,
                                              const Camera& camera,
                                              std::span<const grammar::Item> items,
                                              const SketchParameters& parameters,
                                              const TargetParameters& target) {
  if (const auto fine = Validate(camera); !fine) return tl::unexpected<Error>(fine.error());
  const auto readings = ReadStrokes(strokes, parameters.segmentation, parameters.lines);
  if (!readings) return Fail(readings);
  const std::vector<Vec2> ends = LikeliestEnds(*readings);
  const View view(camera);
  const std::vector<size_t> near = ItemsNear(ends, items, view, target.reach_px);
  const std::vector<Facet> facets = FacetsOf(items, near);
  const std::vector<Shown> shown =
      ThoseShown(Shortlist(ends, items, near, facets, view, target), facets, view, target);
  auto ranked = ReadOnAll(*readings, shown, items, camera, parameters, target);
  if (ranked.empty() || !ExplainsAll(ranked.front().reading, parameters.parts)) {
    auto generous = ReadOnAll(*readings, shown, items, camera, Generous(parameters), target);
    const bool better = !generous.empty() &&
                        (ranked.empty() || generous.front().score >
                                               ranked.front().score + parameters.parts.least_gain);
    if (better) ranked = std::move(generous);
  }
  if (ranked.empty()) {
    return Fail(ErrorCode::kNoFit, "the sketch fits none of the shapes that can be seen",
                "start or end a line at a corner or an edge of the shape that is meant");
  }
  return ranked;
}

}  // namespace parti::sketch
