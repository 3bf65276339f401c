#include "sketch/made_edges.h"

#include <algorithm>

#include "grammar/operation.h"

namespace parti::sketch {
namespace {

// "The same place", of the item's diagonal: above rounding, far below what a pen can tell.
constexpr double kSamePlace = 1e-6;

double SquaredDistance(const Vec3& p, const Vec3& from, const Vec3& along, double per_squared) {
  const Vec3 way = p - from;
  const Vec3 beside = way - along * std::clamp(glm::dot(way, along) * per_squared, 0.0, 1.0);
  return glm::dot(beside, beside);
}

bool SameSegment(const Segment3& s, const Segment3& t, double tolerance) {
  const auto near = [&](const Vec3& p, const Vec3& q) { return glm::distance(p, q) <= tolerance; };
  return (near(s.a, t.a) && near(s.b, t.b)) || (near(s.a, t.b) && near(s.b, t.a));
}

void KeepOneOfEach(double tolerance, std::vector<Segment3>* edges) {
  std::vector<Segment3> kept;
  for (const Segment3& edge : *edges) {
    const auto same = [&](const Segment3& other) { return SameSegment(edge, other, tolerance); };
    if (std::none_of(kept.begin(), kept.end(), same)) kept.push_back(edge);
  }
  *edges = std::move(kept);
}

}  // namespace

double DiagonalOf(const grammar::Item& item) { return glm::length(item.scope.size); }

Result<std::vector<Segment3>> AllEdges(const grammar::Action& action, const grammar::Item& item) {
  const auto products = grammar::Apply(action, item);
  if (!products) return Fail(products);
  std::vector<Segment3> edges;
  for (const grammar::Product& product : *products) {
    const std::vector<Segment3> some = grammar::EdgesOf(product.item);
    edges.insert(edges.end(), some.begin(), some.end());
  }
  // One product of the same make-up is the item again: a repeat that fits once.
  const bool changed =
      products->size() > 1 || (products->size() == 1 && products->front().item.type != item.type);
  if (changed || edges.size() != grammar::EdgesOf(item).size()) return edges;
  return Fail(ErrorCode::kNothingMade, "the operation leaves the shape as it is");
}

MadeEdges::MadeEdges(const grammar::Item& item)
    : item_(&item),
      item_edges_(grammar::EdgesOf(item)),
      diagonal_m_(DiagonalOf(item)),
      tolerance_m_(kSamePlace * diagonal_m_) {
  for (const Segment3& edge : item_edges_) {
    const Vec3 along = edge.b - edge.a;
    const double squared = glm::dot(along, along);
    rays_.push_back({edge.a, along, squared > 0 ? 1 / squared : 0});
  }
}

bool MadeEdges::LiesOnItem(const Segment3& edge) const {
  const double near = tolerance_m_ * tolerance_m_;
  return std::any_of(rays_.begin(), rays_.end(), [&](const Ray& known) {
    const auto& [from, along, per_squared] = known;
    return SquaredDistance(edge.a, from, along, per_squared) <= near &&
           SquaredDistance(edge.b, from, along, per_squared) <= near;
  });
}

bool MadeEdges::IsOnItem(const Segment3& edge) const {
  if (!grammar::IsFlat(item_->type)) return true;
  const auto within = [&](const Vec3& world) {
    const Vec3 p = item_->scope.ToLocal(world);
    const Vec3& size = item_->scope.size;
    return std::abs(p.z) <= tolerance_m_ && p.x >= -tolerance_m_ && p.y >= -tolerance_m_ &&
           p.x <= size.x + tolerance_m_ && p.y <= size.y + tolerance_m_;
  };
  return within(edge.a) && within(edge.b);
}

Result<std::vector<Segment3>> MadeEdges::Of(const grammar::Action& action, bool distinct) const {
  auto all = AllEdges(action, *item_);
  if (!all) return Fail(all);
  std::vector<Segment3> made;
  for (const Segment3& edge : *all) {
    if (!LiesOnItem(edge)) made.push_back(edge);
  }
  if (made.empty()) made = std::move(*all);
  if (distinct) KeepOneOfEach(tolerance_m_, &made);
  return made;
}

}  // namespace parti::sketch
