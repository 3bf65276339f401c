// Gable roofs: hip roofs whose triangular ends are put upright.
//
// The planes to the left and right of a triangular end go on until they meet over its eave: there
// the new top stands. The end keeps its edge and its corners; its slope is shared out to its
// neighbours, so that the mesh stays closed and every plane stays where it was.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "grammar/polygon_crossing.h"
#include "grammar/roof_plan.h"

namespace parti::grammar {
namespace {

using Loop = std::vector<uint32_t>;
constexpr uint32_t kNone = UINT32_MAX;

/// An edge of the outline: dot(inward, p) - offset is the distance from its line.
struct Eave {
  Vec2 inward{0, 0};
  double offset = 0;
  Vec2 along{0, 0};
  double turn_before_deg = 0, turn_after_deg = 0;  ///< of the outline, to the left
  uint32_t before = 0, after = 0;                  ///< neighbours in the ring
};

double TurnDegrees(const Vec2& in, const Vec2& out) {
  return Angle::Radians(std::atan2(Cross(in, out), glm::dot(in, out))).degrees();
}

void AddEaves(const Ring& ring, std::vector<Eave>* eaves) {
  const auto first = static_cast<uint32_t>(eaves->size());
  const auto n = static_cast<uint32_t>(ring.size());
  for (uint32_t i = 0; i < n; ++i) {
    Eave eave;
    eave.along = glm::normalize(ring[(i + 1) % n] - ring[i]);
    eave.inward = Vec2(-eave.along.y, eave.along.x);
    eave.offset = glm::dot(eave.inward, ring[i]);
    eave.before = first + (i + n - 1) % n;
    eave.after = first + (i + 1) % n;
    eaves->push_back(eave);
  }
  for (uint32_t i = first; i < first + n; ++i) {
    Eave& eave = (*eaves)[i];
    eave.turn_before_deg = TurnDegrees((*eaves)[eave.before].along, eave.along);
    eave.turn_after_deg = TurnDegrees(eave.along, (*eaves)[eave.after].along);
  }
}

/// Where two lines at signed distances from two eaves cross.
Vec2 Crossing(const Eave& a, double distance_a, const Eave& b, double distance_b) {
  const double det = Cross(a.inward, b.inward);
  const double u = a.offset + distance_a, v = b.offset + distance_b;
  return Vec2(u * b.inward.y - v * a.inward.y, v * a.inward.x - u * b.inward.x) / det;
}

class Gables {
 public:
  Gables(RoofPlan* plan, double slope) : plan_(plan), slope_(slope) {
    AddEaves(plan->polygon.outer, &eaves_);
    for (const Ring& hole : plan->polygon.holes) AddEaves(hole, &eaves_);
    top_.assign(eaves_.size(), kNone);
  }

  void PutUpright(const Vec2& front) {
    std::vector<uint32_t> order(eaves_.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto sideways = [&](uint32_t e) { return std::abs(glm::dot(eaves_[e].inward, front)); };
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return sideways(a) < sideways(b) - kSameWay; });
    for (const uint32_t e : order) {
      if (IsGable(e)) PutUpright(e);
    }
  }

  /// Moves the outline outward; false, and nothing is changed, where it would touch itself then.
  bool Overhang(double eave_run, double gable) {
    const auto beyond = [&](uint32_t e) { return top_[e] == kNone ? eave_run : gable; };
    std::vector<Vec2> moved;
    for (uint32_t e = 0; e < eaves_.size(); ++e) {
      const Eave &eave = eaves_[e], &other = eaves_[eave.before];
      const Vec2 corner(plan_->points[e]);
      moved.push_back(std::abs(eave.turn_before_deg) < kParallel_deg
                          ? corner - eave.inward * beyond(e)
                          : Crossing(other, -beyond(eave.before), eave, -beyond(e)));
    }
    if (!KeepsShape(moved)) return false;
    for (uint32_t e = 0; e < eaves_.size(); ++e) {
      plan_->points[e] = Vec3(moved[e], -eave_run * slope_);
    }
    for (uint32_t e = 0; e < eaves_.size(); ++e) {
      if (top_[e] != kNone) plan_->points[top_[e]] = TopOver(e, gable);
    }
    return true;
  }

 private:
  static constexpr double kSameWay = 1e-6;
  static constexpr double kParallel_deg = 1e-3;

  bool IsGable(uint32_t e) const {
    const Eave& eave = eaves_[e];
    return plan_->faces[e].size() == 3 && top_[eave.before] == kNone && top_[eave.after] == kNone &&
           eave.turn_before_deg >= kGableCorner_deg && eave.turn_after_deg >= kGableCorner_deg &&
           eave.turn_before_deg + eave.turn_after_deg >= kGableTurn_deg;
  }

  /// Where the neighbours' planes meet the upright plane `beyond` outside of the edge.
  Vec3 TopOver(uint32_t e, double beyond) const {
    const Eave &eave = eaves_[e], &left = eaves_[eave.before], &right = eaves_[eave.after];
    // On the line p = foot + t along, where both planes are as high.
    const Vec2 foot = eave.inward * (eave.offset - beyond);
    const double rise = glm::dot(left.inward - right.inward, eave.along);
    const double gap = glm::dot(right.inward - left.inward, foot) + left.offset - right.offset;
    const Vec2 at = foot + eave.along * (gap / rise);
    return {at, slope_ * (glm::dot(left.inward, at) - left.offset)};
  }

  static void InsertAfter(uint32_t from, uint32_t between, Loop* loop) {
    loop->insert(std::find(loop->begin(), loop->end(), from) + 1, between);
  }

  /// The edge a -> b -> apex. The apex stays for what lies behind; a line runs to it from the top.
  void PutUpright(uint32_t e) {
    Loop& loop = plan_->faces[e];
    const uint32_t a = loop[0], apex = loop[2];
    const auto top = static_cast<uint32_t>(plan_->points.size());
    plan_->points.push_back(TopOver(e, 0));
    top_[e] = top;
    loop[2] = top;
    // The left neighbour runs a -> apex, the right one apex -> b.
    Loop& left = plan_->faces[eaves_[e].before];
    Loop& right = plan_->faces[eaves_[e].after];
    InsertAfter(a, top, &left);
    InsertAfter(apex, top, &right);
    const auto meeting = std::count_if(
        plan_->faces.begin(), plan_->faces.end(),
        [&](const Loop& face) { return std::find(face.begin(), face.end(), apex) != face.end(); });
    if (meeting > 2) return;
    std::erase(left, apex);  // on the ridge now, and nothing else meets there
    std::erase(right, apex);
  }

  bool KeepsShape(const std::vector<Vec2>& moved) const {
    std::vector<Ring> rings;
    size_t at = 0;
    const auto add = [&](const Ring& ring) {
      rings.emplace_back(moved.begin() + static_cast<std::ptrdiff_t>(at),
                         moved.begin() + static_cast<std::ptrdiff_t>(at + ring.size()));
      at += ring.size();
    };
    add(plan_->polygon.outer);
    for (const Ring& hole : plan_->polygon.holes) add(hole);
    for (uint32_t e = 0; e < eaves_.size(); ++e) {
      const uint32_t after = eaves_[e].after;
      if (glm::dot(moved[after] - moved[e], eaves_[e].along) <= kLengthTolerance_m) return false;
    }
    return !FindContact(rings, kLengthTolerance_m).has_value();
  }

  RoofPlan* plan_;
  double slope_;
  std::vector<Eave> eaves_;
  std::vector<uint32_t> top_;  ///< of gables: the point over the edge
};

}  // namespace

Result<Mesh> GableRoof(const Polygon& polygon, const RoofPitch& pitch,
                       const GableOverhang& overhang, const Vec2& front) {
  auto skeleton = StraightSkeleton(polygon);
  if (!skeleton) return Fail(skeleton);
  const auto slope = SlopeOf(pitch, Furthest(*skeleton));
  if (!slope) return Fail(slope);
  const double run = std::max(0.0, overhang.eave_m) / std::sqrt(1 + *slope * *slope);
  RoofPlan plan = Lifted(std::move(*skeleton), *slope, 0);
  Gables gables(&plan, *slope);
  gables.PutUpright(front);
  if (run <= 0 && overhang.gable_m <= 0) return MeshOf(plan);
  if (gables.Overhang(run, std::max(0.0, overhang.gable_m))) return MeshOf(plan);
  // Eaves would meet across a notch: the outline grows as a whole, gables as far as eaves.
  const auto grown = Offset(polygon, -run);
  if (!grown) return Fail(grown);
  skeleton = StraightSkeleton(grown->front());
  if (!skeleton) return Fail(skeleton);
  plan = Lifted(std::move(*skeleton), *slope, 0);
  Gables(&plan, *slope).PutUpright(front);
  for (Vec3& p : plan.points) p.z -= run * *slope;
  return MeshOf(plan);
}

}  // namespace parti::grammar
