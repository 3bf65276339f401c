#include "sketch/target.h"

#include <algorithm>
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

// Mean distance of the drawn ends from the item's edges; the reach for an item out of it.
double MeanDistance(const std::vector<Segment2>& drawn, const grammar::Item& item, const View& view,
                    double reach_px) {
  std::vector<Segment2> edges;
  for (const Segment3& edge : grammar::EdgesOf(item)) {
    const auto screen = view.Project(edge);
    if (screen) edges.push_back(*screen);
  }
  double sum = 0;
  for (const Segment2& line : drawn) {
    sum += DistanceToEdges(line.a, edges, reach_px) + DistanceToEdges(line.b, edges, reach_px);
  }
  return sum / (2.0 * static_cast<double>(drawn.size()));
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
  for (const Segment3& edge : grammar::EdgesOf(item)) {
    const auto screen = view.Project(edge);
    if (!screen) continue;
    box.Add(screen->a);
    box.Add(screen->b);
  }
  return box;
}

std::vector<size_t> ItemsNear(const std::vector<Segment2>& drawn,
                              std::span<const grammar::Item> items, const View& view,
                              double reach_px) {
  ScreenBox sketch;
  for (const Segment2& line : drawn) {
    sketch.Add(line.a);
    sketch.Add(line.b);
  }
  std::vector<size_t> near;
  for (size_t i = 0; i < items.size(); ++i) {
    if (BoxOf(items[i], view).Meets(sketch, reach_px)) near.push_back(i);
  }
  return near;
}

// The items to compare in full: those whose edges the drawn ends lie nearest to. A rectangle drawn
// inside a face touches none of its edges, so hidden ones are dropped before they take a place.
std::vector<Nearness> Shortlist(const std::vector<Segment2>& drawn,
                                std::span<const grammar::Item> items,
                                const std::vector<size_t>& near, const View& view,
                                const TargetParameters& target) {
  std::vector<Nearness> list;
  for (const size_t i : near) {
    list.push_back({i, MeanDistance(drawn, items[i], view, target.reach_px)});
  }
  std::stable_sort(list.begin(), list.end(), [](const Nearness& a, const Nearness& b) {
    return a.distance_px < b.distance_px;
  });
  return list;
}

std::vector<Segment2> LikeliestLines(const std::vector<std::vector<StrokeReading>>& strokes) {
  std::vector<Segment2> lines;
  for (const std::vector<StrokeReading>& stroke : strokes) {
    const std::vector<Segment2>& some = stroke.front().lines;
    lines.insert(lines.end(), some.begin(), some.end());
  }
  return lines;
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
  const std::vector<Segment2> drawn = LikeliestLines(*readings);
  const View view(camera);
  const std::vector<size_t> near = ItemsNear(drawn, items, view, target.reach_px);
  const std::vector<Facet> facets = FacetsOf(items, near);
  std::vector<RankedTarget> ranked;
  int compared = 0;
  for (const Nearness& candidate : Shortlist(drawn, items, near, view, target)) {
    if (compared == target.most_compared) break;
    const double hidden = HiddenShare(candidate.item, facets, view);
    if (hidden >= 1) continue;
    ++compared;
    auto reading = ReadSketch(*readings, items[candidate.item], camera, parameters);
    if (!reading) continue;
    const double score =
        reading->worth - target.hidden * hidden - target.lost_line * reading->lost_lines;
    ranked.push_back({candidate.item, score, hidden, std::move(*reading)});
  }
  if (ranked.empty()) {
    return Fail(ErrorCode::kNoFit, "the sketch fits none of the shapes that can be seen",
                "start or end a line at a corner or an edge of the shape that is meant");
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const RankedTarget& a, const RankedTarget& b) { return a.score > b.score; });
  return ranked;
}

}  // namespace parti::sketch
