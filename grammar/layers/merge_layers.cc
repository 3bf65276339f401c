#include "grammar/layers/merge_layers.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "grammar/layers/region_index.h"

namespace parti::grammar {
namespace {

/// Numbers of the shapes, the uppermost first.
std::vector<uint32_t> FromTop(std::span<const SceneShape> shapes) {
  std::vector<uint32_t> order(shapes.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const SceneShape &p = shapes[a], &q = shapes[b];
    return std::tuple(q.layer, p.depth, b) < std::tuple(p.layer, q.depth, a);
  });
  return order;
}

/// What covers so far: disjoint regions (the mask M of 4.18).
class Mask {
 public:
  Mask(const Box2& bounds, size_t count, const Negligible& negligible)
      : index_(bounds, count), negligible_(negligible) {}

  /// The parts of the region that are covered; disjoint.
  Result<std::vector<Region>> CoveredPartsOf(const Region& region) {
    std::vector<Region> parts;
    for (const uint32_t number : index_.Near(region.bounds)) {
      auto part = Shared(regions_[number], region, negligible_);
      if (!part) return Fail(part);
      if (!IsEmpty(*part)) parts.push_back(std::move(*part));
    }
    return parts;
  }

  void Add(Region region) {
    if (IsEmpty(region)) return;
    index_.Add(static_cast<uint32_t>(regions_.size()), region.bounds);
    regions_.push_back(std::move(region));
  }

  std::span<const Region> regions() const { return regions_; }

 private:
  RegionIndex index_;
  Negligible negligible_;
  std::vector<Region> regions_;
};

double AreaOf(std::span<const Region> regions) {
  double area = 0;
  for (const Region& region : regions) area += AreaOf(region);
  return area;
}

}  // namespace

Result<MergedLayers> MergeLayers(const Region& background, std::span<const SceneShape> shapes,
                                 const Negligible& negligible) {
  MergedLayers merged;
  merged.visible.resize(shapes.size());
  Mask mask(background.bounds, shapes.size(), negligible);
  for (const uint32_t number : FromTop(shapes)) {
    const SceneShape& shape = shapes[number];
    const Negligible& none = negligible;
    if (IsEmpty(shape.region) || AreaOf(shape.region) < none.area_m2) continue;
    const auto parts = mask.CoveredPartsOf(shape.region);
    if (!parts) return Fail(parts);
    const bool covered = AreaOf(*parts) > none.area_m2;
    if (covered && shape.fixed) continue;
    // What is covered by less than counts stays, but the mask is to be disjoint in any case.
    Region left = parts->empty() ? shape.region : Without(shape.region, *parts, none);
    merged.visible[number] = covered ? left : shape.region;
    mask.Add(std::move(left));
  }
  merged.uncovered = PolygonsOf(Without(background, mask.regions(), negligible));
  return merged;
}

}  // namespace parti::grammar
