#include "app/placing/layer_grip.h"

#include <algorithm>
#include <cmath>

namespace parti::app {
namespace {

using grammar::InteractiveLayer;
using grammar::LayerHandle;

/// One rectangle as it is seen.
class SeenRectangle {
 public:
  SeenRectangle(const PlacedLayer& placed, const View& view) : layer_(placed.rules.layer) {
    for (size_t i = 0; i < corners_px_.size(); ++i) {
      const Vec2 at = PlaceOf(layer_, kLayerHandles[i]);
      corners_px_[i] = view.Project(placed.frame.ToWorld({at, 0}));
    }
  }

  /// How far a corner, or an edge that is seen whole, is from a pixel; infinite where it is not
  /// seen.
  double DistanceTo(LayerHandle handle, const Vec2& px) const {
    if (handle.across != 0 && handle.up != 0) {
      const auto& corner = corners_px_[CornerOf(handle.across, handle.up)];
      return corner ? glm::distance(*corner, px) : INFINITY;
    }
    const auto& [a, b] = EndsOf(handle);
    return a && b ? DistanceToLine(*a, *b, px) : INFINITY;
  }

  bool Holds(const Vec2& at) const {
    return at.x >= layer_.left && at.x <= layer_.left + layer_.width && at.y >= layer_.bottom &&
           at.y <= layer_.bottom + layer_.height;
  }

  /// A quarter of the shorter side.
  double ReachWithin_px() const {
    double shortest = INFINITY;
    for (size_t i = 0; i < 4; ++i) {
      const auto &a = corners_px_[i], &b = corners_px_[(i + 1) % 4];
      if (a && b) shortest = std::min(shortest, glm::distance(*a, *b));
    }
    return shortest / 4;
  }

 private:
  static size_t CornerOf(int across, int up) {
    if (up < 0) return across < 0 ? 0 : 1;
    return across < 0 ? 3 : 2;
  }

  std::pair<std::optional<Vec2>, std::optional<Vec2>> EndsOf(LayerHandle edge) const {
    if (edge.up != 0)
      return {corners_px_[CornerOf(-1, edge.up)], corners_px_[CornerOf(1, edge.up)]};
    return {corners_px_[CornerOf(edge.across, -1)], corners_px_[CornerOf(edge.across, 1)]};
  }

  static double DistanceToLine(const Vec2& a, const Vec2& b, const Vec2& px) {
    const Vec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(px - a, along) / length2, 0.0, 1.0) : 0;
    return glm::distance(a + along * t, px);
  }

  const InteractiveLayer& layer_;
  std::array<std::optional<Vec2>, 4> corners_px_;
};

/// Corners go before edges, edges before the whole.
int RankOf(LayerHandle handle) {
  if (handle.whole()) return 2;
  return handle.across != 0 && handle.up != 0 ? 0 : 1;
}

}  // namespace

Vec2 PlaceOf(const InteractiveLayer& layer, LayerHandle handle) {
  return {layer.left + layer.width * (handle.across + 1) / 2,
          layer.bottom + layer.height * (handle.up + 1) / 2};
}

SeenElement SeenAs(const grammar::Scope& frame, const InteractiveLayer& layer, const View& view) {
  SeenElement seen;
  for (const LayerHandle handle : kLayerHandles) {
    const auto px = view.Project(frame.ToWorld({PlaceOf(layer, handle), 0}));
    if (!px) continue;
    const bool first = seen.handles_px.empty();
    seen.low_px = first ? *px : glm::min(seen.low_px, *px);
    seen.high_px = first ? *px : glm::max(seen.high_px, *px);
    seen.handles_px.push_back(*px);
  }
  return seen;
}

std::optional<Vec2> OnFrame(const grammar::Scope& frame, const View& view, const Vec2& px) {
  if (!IsFinite(px)) return std::nullopt;
  const auto point =
      Intersect(view.RayThrough(px), Plane{frame.z, glm::dot(frame.z, frame.origin)});
  if (!point) return std::nullopt;
  const Vec3 local = frame.ToLocal(*point);
  return Vec2(local.x, local.y);
}

std::optional<LayerGrip> GripAt(const PlacedLayers& placed, const View& view, const Vec2& px,
                                double reach_px) {
  if (glm::dot(placed.face.z, view.camera().eye - placed.face.origin) <= 0) return std::nullopt;
  std::optional<LayerGrip> grip;
  double nearest_px = INFINITY;
  const auto consider = [&](const LayerGrip& other, double off_px) {
    const int rank = RankOf(other.handle), best = grip ? RankOf(grip->handle) : 3;
    if (rank > best || (rank == best && off_px >= nearest_px)) return;
    grip = other;
    nearest_px = off_px;
  };
  std::vector<SeenRectangle> seen;
  seen.reserve(placed.layers.size());
  for (size_t i = 0; i < placed.layers.size(); ++i) {
    seen.emplace_back(placed.layers[i], view);
    const auto at = OnFrame(placed.layers[i].frame, view, px);
    if (!at || !seen[i].Holds(*at)) continue;
    reach_px = std::min(reach_px, seen[i].ReachWithin_px());
    consider({i, {}}, 0);
  }
  for (size_t i = 0; i < seen.size(); ++i) {
    for (const LayerHandle handle : kLayerHandles) {
      const double off_px = seen[i].DistanceTo(handle, px);
      if (off_px <= reach_px) consider({i, handle}, off_px);
    }
  }
  return grip;
}

}  // namespace parti::app
