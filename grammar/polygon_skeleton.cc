#include "grammar/polygon_skeleton.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Straight_skeleton_2.h>
#include <CGAL/Straight_skeleton_builder_2.h>
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/random.h"
#include "grammar/polygon_crossing.h"
#include "grammar/polygon_nesting.h"
#include "grammar/skeleton_refine.h"

namespace parti::grammar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalRing = CGAL::Polygon_2<Kernel>;
using CgalSkeleton = CGAL::Straight_skeleton_2<Kernel>;

/// Faces may overlap or miss this share of the polygon before the division is none.
constexpr double kAreaShare = 1e-6;

/// How often CGAL may ask whether two nodes are one: several times what the worst outlines needed
/// (53 for each of 96 corners, 1,333 for each of 1,937).
constexpr size_t MostQuestions(size_t corners) { return corners * (200 + 5 * corners); }

/// A polygon on a grid around its middle. Its corners keep the numbers of the one it was made from.
struct Gridded {
  Vec2 middle{0, 0};
  double grid = 0;
  bool is_shaken = false;   ///< corners lie beside their places, by up to two cells
  std::vector<Ring> rings;  ///< outline, then holes

  Gridded(const Polygon& polygon, double grid_m, bool shaken) : grid(grid_m), is_shaken(shaken) {
    const Box2 box = Bounds(polygon);
    middle = (box.low + box.high) * 0.5;
    Add(polygon.outer);
    for (const Ring& hole : polygon.holes) Add(hole);
  }

  void Add(const Ring& ring) {
    Ring& rounded = rings.emplace_back();
    Random random(rings.size());
    for (const Vec2& p : ring) {
      Vec2 at = (p - middle) / grid;
      if (is_shaken) {
        at.x += random.Uniform(-1.5, 1.5);
        at.y += random.Uniform(-1.5, 1.5);
      }
      rounded.push_back(glm::round(at) * grid);
    }
  }

  /// Rounding has moved no corner across an edge; corners that touch are left to CGAL.
  bool IsSimple() const {
    const auto contact = FindContact(rings, 0);
    return !contact || !contact->crosses;
  }
};

CgalRing ToCgal(const Ring& ring) {
  CgalRing result;
  for (const Vec2& p : ring) result.push_back({p.x, p.y});
  return result;
}

/// Where CGAL has joined nodes wrongly, it may go around a face for ever and ask of the same two
/// nodes again and again whether they are one. Here it may ask only so often.
class BoundedTraits : public CGAL::Straight_skeleton_builder_traits_2<Kernel> {
  using Base = CGAL::Straight_skeleton_builder_traits_2<Kernel>;

 public:
  explicit BoundedTraits(size_t questions) : left_(questions) {}

  using Base::get;
  Are_ss_events_simultaneous_2 get(const Are_ss_events_simultaneous_2* which) const {
    if (left_ == 0) throw std::runtime_error("the straight skeleton does not end");
    --left_;
    return Base::get(which);
  }

 private:
  mutable size_t left_;
};

/// nullptr where CGAL finds none.
boost::shared_ptr<CgalSkeleton> Run(const Gridded& gridded) {
  size_t corners = 0;
  for (const Ring& ring : gridded.rings) corners += ring.size();
  CGAL::Straight_skeleton_builder_2<BoundedTraits, CgalSkeleton> builder(
      boost::none, BoundedTraits(MostQuestions(corners)));
  try {
    for (const Ring& ring : gridded.rings) {
      const CgalRing points = ToCgal(ring);
      builder.enter_contour(points.vertices_begin(), points.vertices_end());
    }
    return builder.construct_skeleton();
  } catch (const std::exception&) {
    return nullptr;
  }
}

/// CGAL numbers vertices and halfedges by creation: contour vertices first, ring by ring.
std::optional<Skeleton> FromCgal(const CgalSkeleton& given, const Gridded& gridded) {
  Skeleton skeleton;
  std::vector<uint32_t> number(given.size_of_vertices() + 1, UINT32_MAX);
  size_t corner = 0;
  const auto number_of = [&](const auto& vertex) -> uint32_t& {
    const auto id = static_cast<size_t>(vertex->id());
    if (id >= number.size()) number.resize(id + 1, UINT32_MAX);
    return number[id];
  };
  for (auto v = given.vertices_begin(); v != given.vertices_end(); ++v) {
    if (v->has_infinite_time()) return std::nullopt;
    if (!v->is_contour()) continue;
    number_of(v) = static_cast<uint32_t>(corner++);
    skeleton.nodes.push_back({Vec2(v->point().x(), v->point().y()), 0});
  }
  size_t at = 0;
  for (const Ring& ring : gridded.rings) {
    for (const Vec2& p : ring) {
      if (at >= corner || skeleton.nodes[at++].at != p) return std::nullopt;
    }
  }
  if (at != corner) return std::nullopt;
  for (auto v = given.vertices_begin(); v != given.vertices_end(); ++v) {
    if (v->is_contour()) continue;
    number_of(v) = static_cast<uint32_t>(skeleton.nodes.size());
    skeleton.nodes.push_back({Vec2(v->point().x(), v->point().y()), v->time()});
  }
  skeleton.faces.resize(corner);
  for (auto face = given.faces_begin(); face != given.faces_end(); ++face) {
    const auto edge = face->halfedge()->defining_contour_edge();
    const uint32_t first = number_of(edge->opposite()->vertex());
    std::vector<uint32_t>& loop = skeleton.faces[first];
    if (!loop.empty()) return std::nullopt;
    auto at_edge = edge;
    do {
      loop.push_back(number_of(at_edge->opposite()->vertex()));
      at_edge = at_edge->next();
    } while (at_edge != edge);
  }
  return skeleton;
}

/// Numbers the nodes inside as the faces come to them, and drops those that none does. CGAL's
/// numbers depend on the addresses of what meets at once, and so would the order of rings and
/// pieces.
void NumberByFaces(size_t corners, Skeleton* skeleton) {
  std::vector<uint32_t> number(skeleton->nodes.size(), UINT32_MAX);
  std::iota(number.begin(), number.begin() + static_cast<ptrdiff_t>(corners), 0U);
  std::vector<SkeletonNode> nodes(skeleton->nodes.begin(),
                                  skeleton->nodes.begin() + static_cast<ptrdiff_t>(corners));
  for (std::vector<uint32_t>& face : skeleton->faces) {
    for (uint32_t& i : face) {
      if (number[i] == UINT32_MAX) {
        number[i] = static_cast<uint32_t>(nodes.size());
        nodes.push_back(skeleton->nodes[i]);
      }
      i = number[i];
    }
  }
  skeleton->nodes = std::move(nodes);
}

double AreaOf(const Skeleton& skeleton, const std::vector<uint32_t>& face) {
  Ring ring;
  ring.reserve(face.size());
  for (const uint32_t i : face) ring.push_back(skeleton.nodes[i].at);
  return SignedArea(ring);
}

/// Every edge has a face, none lies upside down, and together they are the polygon.
bool Divides(const Skeleton& skeleton, const Polygon& polygon) {
  const double whole = Area(polygon);
  double sum = 0;
  for (const auto& face : skeleton.faces) {
    if (face.size() < 3) return false;
    const double area = AreaOf(skeleton, face);
    if (area < -kAreaShare * whole) return false;
    sum += std::abs(area);
  }
  return std::abs(sum - whole) <= kAreaShare * whole;
}

std::optional<Skeleton> SkeletonOnGrid(const Polygon& polygon, double grid_m, bool shaken) {
  const Gridded gridded(polygon, grid_m, shaken);
  if (!gridded.IsSimple()) return std::nullopt;
  const auto run = Run(gridded);
  if (!run) return std::nullopt;
  auto skeleton = FromCgal(*run, gridded);
  if (!skeleton) return std::nullopt;
  for (SkeletonNode& node : skeleton->nodes) node.at += gridded.middle;
  const size_t corners = skeleton->faces.size();
  NumberByFaces(corners, &*skeleton);
  Refine(polygon, gridded.grid, &*skeleton);
  NumberByFaces(corners, &*skeleton);  // without those that were joined to others
  if (!Divides(*skeleton, polygon)) return std::nullopt;
  return skeleton;
}

}  // namespace

Result<Skeleton> StraightSkeleton(const Polygon& polygon, double extent_m) {
  const Polygon straight = Straightened(polygon, extent_m);
  const double scale = std::ceil(std::log2(extent_m));
  // Where rounding to the first grid makes the outline touch itself, finer ones may not.
  // Where much meets at once, CGAL may be wrong on any grid: shaken corners meet one by one.
  for (const bool shaken : {false, true}) {
    for (const int bits : {26, 22, 31, 18}) {
      auto skeleton = SkeletonOnGrid(straight, std::exp2(scale - bits), shaken);
      if (!skeleton) continue;
      skeleton->polygon = straight;
      return std::move(*skeleton);
    }
  }
  return Fail(ErrorCode::kDegenerateGeometry,
              fmt::format("a polygon of {} corners has no straight skeleton", polygon.outer.size()),
              "move corners apart that nearly touch");
}

Result<Skeleton> StraightSkeleton(const Polygon& polygon) {
  return StraightSkeleton(polygon, ExtentOf(polygon));
}

}  // namespace parti::grammar
