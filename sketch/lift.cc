#include "sketch/lift.h"

#include <algorithm>
#include <limits>
#include <map>

#include "sketch/score.h"

namespace parti::sketch {
namespace {

struct Hit {
  size_t sample;
  size_t edge;  // within the sample
  double squared_px;
};

struct Reading {
  Segment3 world;
  double squared_px;
  const grammar::Operation* operation;
  Cover cover;
};

// A drawn line, and what it may be compared with.
struct Drawn {
  Segment2 line;
  double free_end_squared_px;  // price of an end along an edge
};

template <typename Point>
Point Between(const Point& a, const Point& b, double t) {
  return a + (b - a) * t;
}
template <typename Point>
Segment<Point> Between(const Segment<Point>& a, const Segment<Point>& b, double t) {
  return {Between(a.a, b.a, t), Between(a.b, b.b, t)};
}

// Shares of the edge that the drawn line covers; all of it where it may not be drawn in part.
Cover CoverAt(const Drawn& drawn, size_t edge, const Candidates& candidates) {
  const bool part = !candidates.on_item.empty() && candidates.on_item[edge] != 0;
  return CoverOf(drawn.line, *candidates.screen[edge],
                 part ? drawn.free_end_squared_px : std::numeric_limits<double>::infinity());
}

double CostOf(const Cover& cover, const Drawn& drawn) {
  return cover.free_ends == 0 ? cover.squared_px
                              : cover.squared_px + cover.free_ends * drawn.free_end_squared_px;
}

std::vector<Hit> HitsWithin(double greatest_squared_px, const Drawn& drawn,
                            const Candidates& candidates) {
  std::vector<Hit> hits;
  for (size_t s = 0; s < candidates.samples.size(); ++s) {
    const Sample& sample = candidates.samples[s];
    for (size_t e = 0; e < sample.count; ++e) {
      const auto& screen = candidates.screen[sample.first + e];
      if (!screen) continue;
      const double squared = candidates.on_item.empty()
                                 ? SquaredEndDistance(drawn.line, *screen)
                                 : CostOf(CoverAt(drawn, sample.first + e, candidates), drawn);
      if (squared <= greatest_squared_px) hits.push_back({s, e, squared});
    }
  }
  const auto fitter = [](const Hit& a, const Hit& b) { return a.squared_px < b.squared_px; };
  std::stable_sort(hits.begin(), hits.end(), fitter);
  return hits;
}

// Share of the way from `here` to `there` at which the projection is nearest to `drawn`: the least
// squares solution for the four coordinates.
double BestShare(const Segment2& drawn, const Segment2& here, const Segment2& there) {
  const auto squared = [](const Vec2& v) { return glm::dot(v, v); };
  const Vec2 to_a = drawn.a - here.a, to_b = drawn.b - here.b;
  const Vec2 move_a = there.a - here.a, move_b = there.b - here.b;
  const double moved = squared(move_a) + squared(move_b);
  if (moved <= 0) return 0;
  return std::clamp((glm::dot(to_a, move_a) + glm::dot(to_b, move_b)) / moved, 0.0, 1.0);
}

Segment2 PartOf(const Segment2& edge, const Cover& cover) {
  return {Between(edge.a, edge.b, cover.at_a), Between(edge.a, edge.b, cover.at_b)};
}

// Tries the way towards one neighbour in the family; only samples of the same make-up are a family.
void MoveTowards(size_t neighbour, const Hit& hit, const Drawn& drawn, const Candidates& c,
                 Reading* best) {
  const Sample& here = c.samples[hit.sample];
  const Sample& there = c.samples[neighbour];
  if (there.family != here.family || there.count != here.count) return;
  const size_t i = here.first + hit.edge, j = there.first + hit.edge;
  if (!c.screen[i] || !c.screen[j]) return;
  const Cover cover = CoverAt(drawn, i, c);
  const Segment2 part_here = PartOf(*c.screen[i], cover), part_there = PartOf(*c.screen[j], cover);
  const double t = BestShare(drawn.line, part_here, part_there);
  const double squared = SquaredEndDistance(drawn.line, Between(part_here, part_there, t)) +
                         CostOf(cover, drawn) - cover.squared_px;
  if (squared >= best->squared_px) return;
  best->squared_px = squared;
  best->cover = cover;
  best->world = Between(c.edges[i], c.edges[j], t);
}

Reading Refine(const Hit& hit, const Drawn& drawn, const Candidates& c) {
  const Sample& sample = c.samples[hit.sample];
  const size_t edge = sample.first + hit.edge;
  Reading best{c.edges[edge], hit.squared_px, sample.action.operation,
               c.on_item.empty() ? Cover{} : CoverAt(drawn, edge, c)};
  if (hit.sample > 0) MoveTowards(hit.sample - 1, hit, drawn, c, &best);
  if (hit.sample + 1 < c.samples.size()) MoveTowards(hit.sample + 1, hit, drawn, c, &best);
  return best;
}

// Lines whose ends lie this near each other, of their length, are one reading.
bool SameReading(const Reading& r, const Reading& s) {
  constexpr double kSame = 0.04;
  if (r.operation != s.operation) return false;
  const double reach = kSame * glm::distance(r.world.a, r.world.b);
  const auto near = [&](const Vec3& p, const Vec3& q) { return glm::distance(p, q) <= reach; };
  return (near(r.world.a, s.world.a) && near(r.world.b, s.world.b)) ||
         (near(r.world.a, s.world.b) && near(r.world.b, s.world.a));
}

std::vector<Reading> Choose(const std::vector<Hit>& hits, const Drawn& drawn,
                            const Candidates& candidates, int most_per_operation) {
  std::vector<Reading> chosen;
  std::map<const grammar::Operation*, int> count;
  for (const Hit& hit : hits) {
    const grammar::Operation* operation = candidates.samples[hit.sample].action.operation;
    if (count[operation] >= most_per_operation) continue;
    const Reading reading = Refine(hit, drawn, candidates);
    const auto same = [&](const Reading& other) { return SameReading(reading, other); };
    const auto known = std::find_if(chosen.begin(), chosen.end(), same);
    if (known == chosen.end()) {
      chosen.push_back(reading);
      ++count[operation];
    } else if (reading.squared_px < known->squared_px) {
      *known = reading;
    }
  }
  const auto fitter = [](const Reading& a, const Reading& b) {
    return a.squared_px < b.squared_px;
  };
  std::stable_sort(chosen.begin(), chosen.end(), fitter);
  return chosen;
}

// What the drawn line covers of the edge. Shares on the screen are no shares in the world: the
// further end is foreshortened.
Segment3 CoveredPart(const Reading& reading, const Camera& camera) {
  const View view(camera);
  const Segment3& edge = reading.world;
  const double depth_a = view.Depth(edge.a), depth_b = view.Depth(edge.b);
  const auto at = [&](double share) {
    if (!(depth_a > 0 && depth_b > 0)) return Between(edge.a, edge.b, share);
    const double weighted = share * depth_a;
    return Between(edge.a, edge.b, weighted / (weighted + (1 - share) * depth_b));
  };
  return {at(std::min(reading.cover.at_a, reading.cover.at_b)),
          at(std::max(reading.cover.at_a, reading.cover.at_b))};
}

}  // namespace

Result<WorldLine> Lift(const Segment2& drawn, const Candidates& candidates, const Camera& camera,
                       const LiftParameters& parameters) {
  const double length_px = glm::distance(drawn.a, drawn.b);
  const double radius = parameters.radius_px + parameters.radius_relative * length_px;
  const double greatest = -std::log(parameters.least_fitness) * radius * radius;
  const Drawn sought{drawn, radius * radius};  // a fitness of 1/e
  const std::vector<Hit> hits = HitsWithin(greatest, sought, candidates);
  if (hits.empty()) {
    return Fail(ErrorCode::kNoFit, "no operation on this shape makes an edge near the drawn line",
                "start or end the line at a corner or an edge of the shape");
  }
  WorldLine line;
  line.drawn = drawn;
  line.camera = camera;
  for (const Reading& r : Choose(hits, sought, candidates, parameters.most_per_operation)) {
    const double fitness = std::exp(-r.squared_px / (radius * radius));  // (6.13)
    const Segment3 world = r.cover.free_ends > 0 ? CoveredPart(r, camera) : r.world;
    line.alternatives.push_back({world, fitness, r.operation, r.cover.free_ends});
  }
  line.world = line.alternatives.front().world;
  line.fitness = line.alternatives.front().fitness;
  return line;
}

}  // namespace parti::sketch
