// Offsets as levels of a skeleton (LevelOf).
//
// In the face of an edge, the level runs parallel to the edge, from where the face's border comes
// down through it to where the border went up through it before. Each such crossing lies on an edge
// that two faces share, which the other one runs through the other way: there its piece begins. So
// pieces are linked by the numbers of nodes alone.
#include <map>
#include <utility>

#include "grammar/polygon_nesting.h"
#include "grammar/polygon_skeleton.h"

namespace parti::grammar {
namespace {

/// An edge of a face, in its direction there.
using Step = std::pair<uint32_t, uint32_t>;

class Level {
 public:
  Level(const Skeleton& skeleton, double distance) : skeleton_(skeleton), distance_(distance) {}

  std::vector<Polygon> Run() {
    for (const auto& face : skeleton_.faces) AddPieces(face);
    std::vector<Ring> outlines, holes;
    while (!next_.empty()) {
      Ring ring = TakeRing();
      DropRepeatedCorners(&ring);
      if (ring.size() < 3) continue;
      (SignedArea(ring) > 0 ? outlines : holes).push_back(std::move(ring));
    }
    return Nest(std::move(outlines), std::move(holes));
  }

 private:
  bool IsAbove(uint32_t i) const { return skeleton_.nodes[i].distance_m >= distance_; }

  /// The face's border, from its edge on, goes up and down through the level in turn.
  void AddPieces(const std::vector<uint32_t>& face) {
    Step up{0, 0};
    for (size_t i = 0; i < face.size(); ++i) {
      const uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (!IsAbove(a) && IsAbove(b)) up = {a, b};
      // The piece runs from the way down to the way up, which the next face runs down.
      if (IsAbove(a) && !IsAbove(b)) next_[{a, b}] = {up.second, up.first};
    }
  }

  Vec2 PointOn(const Step& down) const {
    const SkeletonNode &a = skeleton_.nodes[down.first], &b = skeleton_.nodes[down.second];
    const double t = (a.distance_m - distance_) / (a.distance_m - b.distance_m);
    return a.at + (b.at - a.at) * t;
  }

  Ring TakeRing() {
    Ring ring;
    for (auto at = next_.begin(); at != next_.end();) {
      ring.push_back(PointOn(at->first));
      const Step following = at->second;
      next_.erase(at);
      at = next_.find(following);
    }
    return ring;
  }

  const Skeleton& skeleton_;
  double distance_;
  std::map<Step, Step> next_;
};

}  // namespace

std::vector<Polygon> LevelOf(const Skeleton& skeleton, double distance_m) {
  return Level(skeleton, distance_m).Run();
}

}  // namespace parti::grammar
