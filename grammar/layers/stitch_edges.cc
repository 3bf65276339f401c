#include "grammar/layers/stitch_edges.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "grammar/layers/coordinate_table.h"
#include "grammar/layers/vertex_grid.h"

namespace parti::grammar {
namespace {

/// A corner by the numbers of its coordinates.
struct Corner {
  uint32_t x = 0, y = 0;
  auto operator<=>(const Corner&) const = default;
};

template <typename Use>
void EachRing(std::span<const Polygon> polygons, const Use& use) {
  for (const Polygon& polygon : polygons) {
    use(polygon.outer);
    for (const Ring& hole : polygon.holes) use(hole);
  }
}

class Builder {
 public:
  Builder(std::span<const Polygon> plus, std::span<const Polygon> minus, double tolerance)
      : tolerance_(tolerance) {
    AddCoordinates(plus, true);
    AddCoordinates(minus, false);
    xs_.Merge(tolerance);
    ys_.Merge(tolerance);
    AddCorners(plus, false);
    AddCorners(minus, true);
    NumberCorners();
  }

  StitchGraph Build() {
    StitchGraph graph;
    graph.vertices.reserve(corners_.size());
    for (const Corner& corner : corners_) graph.vertices.emplace_back(xs_[corner.x], ys_[corner.y]);
    CutEdges(graph.vertices);
    graph.edges = Uncancelled();
    return graph;
  }

 private:
  void AddCoordinates(std::span<const Polygon> polygons, bool leading) {
    EachRing(polygons, [&](const Ring& ring) {
      for (const Vec2& p : ring) {
        xs_.Add(p.x, leading);
        ys_.Add(p.y, leading);
      }
    });
  }

  Corner CornerOf(const Vec2& p) const { return {xs_.IndexOf(p.x), ys_.IndexOf(p.y)}; }

  void AddCorners(std::span<const Polygon> polygons, bool reversed) {
    EachRing(polygons, [&](const Ring& ring) {
      Corner before = CornerOf(ring.back());
      for (const Vec2& p : ring) {
        const Corner here = CornerOf(p);
        if (here != before) {
          given_.push_back(reversed ? std::pair(here, before) : std::pair(before, here));
        }
        before = here;
      }
    });
  }

  uint32_t NumberOf(const Corner& corner) const {
    return static_cast<uint32_t>(std::lower_bound(corners_.begin(), corners_.end(), corner) -
                                 corners_.begin());
  }

  /// Sorted by x and then y, so that the corners of an upright line have neighbouring numbers;
  /// level_ and rank_ are the same by y and then x.
  void NumberCorners() {
    corners_.reserve(given_.size());
    for (const auto& [from, to] : given_) corners_.push_back(from);
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    level_.resize(corners_.size());
    rank_.resize(corners_.size());
    for (uint32_t i = 0; i < level_.size(); ++i) level_[i] = i;
    std::sort(level_.begin(), level_.end(), [&](uint32_t a, uint32_t b) {
      return std::pair(corners_[a].y, corners_[a].x) < std::pair(corners_[b].y, corners_[b].x);
    });
    for (uint32_t i = 0; i < rank_.size(); ++i) rank_[level_[i]] = i;
  }

  void AddUpright(uint32_t from, uint32_t to) {
    const uint32_t step = from < to ? 1 : -1;
    for (uint32_t i = from; i != to; i += step) edges_.push_back({i, i + step});
  }
  void AddLevel(uint32_t from, uint32_t to) {
    const uint32_t step = rank_[from] < rank_[to] ? 1 : -1;
    for (uint32_t i = rank_[from]; i != rank_[to]; i += step) {
      edges_.push_back({level_[i], level_[i + step]});
    }
  }
  void AddSlanted(uint32_t from, uint32_t to, const VertexGrid& grid) {
    for (const uint32_t at : grid.Along(from, to, tolerance_)) {
      edges_.push_back({from, at});
      from = at;
    }
    edges_.push_back({from, to});
  }

  void CutEdges(std::span<const Vec2> vertices) {
    const auto is_slanted = [](const auto& edge) {
      return edge.first.x != edge.second.x && edge.first.y != edge.second.y;
    };
    const bool slanted = std::any_of(given_.begin(), given_.end(), is_slanted);
    const VertexGrid grid(slanted ? vertices : std::span<const Vec2>());
    edges_.reserve(2 * given_.size());
    for (const auto& edge : given_) {
      const uint32_t from = NumberOf(edge.first), to = NumberOf(edge.second);
      if (edge.first.x == edge.second.x) {
        AddUpright(from, to);
      } else if (edge.first.y == edge.second.y) {
        AddLevel(from, to);
      } else {
        AddSlanted(from, to, grid);
      }
    }
  }

  /// Edges that run one way more often than the other, as often as they do.
  std::vector<StitchEdge> Uncancelled() {
    const auto line = [](const StitchEdge& e) {
      return std::pair(std::min(e.from, e.to), std::max(e.from, e.to));
    };
    std::sort(edges_.begin(), edges_.end(),
              [&](const StitchEdge& a, const StitchEdge& b) { return line(a) < line(b); });
    std::vector<StitchEdge> left;
    for (size_t i = 0; i < edges_.size();) {
      const auto [low, high] = line(edges_[i]);
      int forward = 0;
      for (; i < edges_.size() && line(edges_[i]) == std::pair(low, high); ++i) {
        forward += edges_[i].from == low ? 1 : -1;
      }
      for (; forward > 0; --forward) left.push_back({low, high});
      for (; forward < 0; ++forward) left.push_back({high, low});
    }
    std::sort(left.begin(), left.end(), [](const StitchEdge& a, const StitchEdge& b) {
      return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    return left;
  }

  double tolerance_;
  CoordinateTable xs_, ys_;
  std::vector<std::pair<Corner, Corner>> given_;
  std::vector<Corner> corners_;
  std::vector<uint32_t> level_, rank_;
  std::vector<StitchEdge> edges_;
};

}  // namespace

StitchGraph StitchGraphOf(std::span<const Polygon> plus, std::span<const Polygon> minus,
                          double tolerance_m) {
  return Builder(plus, minus, tolerance_m).Build();
}

}  // namespace parti::grammar
