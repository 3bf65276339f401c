#include "app/covered_edges.h"

#include <cmath>
#include <memory>
#include <utility>

#include "app/edge_cover.h"
#include "grammar/layers/region_index.h"

namespace parti::app {
namespace {

using grammar::Box2;
using grammar::Item;

/// What lies between the corners of a scope's box, seen from above.
Box2 PlanOf(const grammar::Scope& scope) {
  const Vec3 half = scope.size * 0.5, middle = scope.ToWorld(half);
  Vec2 reach(0, 0);
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = scope.axis(i) * half[i];
    reach += glm::abs(Vec2(axis.x, axis.z));
  }
  return {Vec2(middle.x, middle.z) - reach, Vec2(middle.x, middle.z) + reach};
}

bool IsFinite(const Box2& box) {
  return std::isfinite(box.low.x + box.low.y) && std::isfinite(box.high.x + box.high.y);
}

class Sorter {
 public:
  explicit Sorter(std::vector<EdgeCover> covers) : covers_(std::move(covers)) {
    Box2 all{Vec2(INFINITY, INFINITY), Vec2(-INFINITY, -INFINITY)};
    std::vector<Box2> plans;
    for (const EdgeCover& cover : covers_) {
      plans.push_back(PlanOf(cover.face.scope));
      if (!IsFinite(plans.back())) continue;
      all.low = glm::min(all.low, plans.back().low);
      all.high = glm::max(all.high, plans.back().high);
    }
    if (!IsFinite(all)) return;
    index_ = std::make_unique<grammar::RegionIndex>(all, covers_.size());
    for (size_t i = 0; i < plans.size(); ++i) {
      if (IsFinite(plans[i])) index_->Add(static_cast<uint32_t>(i), plans[i]);
    }
    by_cover_.resize(covers_.size());
  }

  void Add(const Item& item, grammar::ShapeIndex owner) {
    FindNear(item, owner);
    if (near_.empty()) return grammar::EdgesOf(item, &sorted_.open);
    bool is_covered = false;
    for (const Segment3& edge : grammar::EdgesOf(item)) {
      if (AddCovered(item, edge)) {
        is_covered = true;
      } else {
        sorted_.open.push_back(edge);
      }
    }
    if (is_covered) sorted_.covered_shapes.push_back(owner);
  }

  SortedEdges Take() {
    for (size_t i = 0; i < by_cover_.size(); ++i) {
      if (by_cover_[i].empty()) continue;
      sorted_.covered.push_back({covers_[i].face.scope.z, std::move(by_cover_[i])});
    }
    return std::move(sorted_);
  }

 private:
  void FindNear(const Item& item, grammar::ShapeIndex owner) {
    near_.clear();
    if (!index_) return;
    const Box2 plan = PlanOf(item.scope);
    if (!IsFinite(plan)) return;
    for (const uint32_t number : index_->Near(plan)) {
      const EdgeCover& cover = covers_[number];
      if (cover.owner != owner && MayCover(cover, item)) near_.push_back(number);
    }
  }

  /// The first face that covers a part of the edge takes that part. False where none does.
  bool AddCovered(const Item& item, const Segment3& edge) {
    for (const uint32_t number : near_) {
      const std::vector<EdgeSpan> spans = CoveredSpans(covers_[number], item, edge);
      if (spans.empty()) continue;
      Split(edge, spans, number);
      return true;
    }
    return false;
  }

  void Split(const Segment3& edge, const std::vector<EdgeSpan>& spans, uint32_t number) {
    const auto at = [&edge](double t) { return t == 1 ? edge.b : edge.a + (edge.b - edge.a) * t; };
    double done = 0;
    for (const EdgeSpan& span : spans) {
      if (span.from > done) sorted_.open.push_back({at(done), at(span.from)});
      by_cover_[number].push_back({at(span.from), at(span.to)});
      done = span.to;
    }
    if (done < 1) sorted_.open.push_back({at(done), edge.b});
  }

  std::vector<EdgeCover> covers_;
  std::unique_ptr<grammar::RegionIndex> index_;  ///< of covers in plan; null: there are none
  std::vector<uint32_t> near_;                   ///< covers that the item in hand may end at
  std::vector<std::vector<Segment3>> by_cover_;
  SortedEdges sorted_;
};

}  // namespace

SortedEdges SortEdges(const grammar::ShapeTree& tree, std::span<const grammar::ShapeIndex> shapes) {
  std::vector<EdgeCover> covers;
  for (const grammar::ShapeIndex i : shapes) AddCovers(tree[i].item, i, &covers);
  Sorter sorter(std::move(covers));
  for (const grammar::ShapeIndex i : shapes) sorter.Add(tree[i].item, i);
  return sorter.Take();
}

}  // namespace parti::app
