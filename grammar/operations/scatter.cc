// scatter(domain, count, distribution): points in or on a shape, by chance. Rules write what stands
// there in braces.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/random.h"
#include "grammar/item_make.h"
#include "grammar/item_place.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kSurface = "surface", kScope = "scope";
constexpr std::string_view kUniform = "uniform", kGaussian = "gaussian";
/// Points that a gaussian does not want are drawn again this often.
constexpr int kMostTries = 64;

/// Draws points of a surface, every part of it as likely.
class Surface {
 public:
  explicit Surface(const Item& item) {
    TrianglesOf(item, &corners_);
    for (size_t i = 0; i + 2 < corners_.size(); i += 3) {
      const Vec3 ab = corners_[i + 1] - corners_[i], ac = corners_[i + 2] - corners_[i];
      area_m2_ += glm::length(glm::cross(ab, ac)) / 2;
      up_to_m2_.push_back(area_m2_);
    }
  }
  bool is_empty() const { return area_m2_ <= 0; }

  Vec3 Draw(Random* random) const {
    const double where = random->Uniform() * area_m2_;
    const auto found = std::upper_bound(up_to_m2_.begin(), up_to_m2_.end(), where);
    const size_t last = up_to_m2_.size() - 1;
    const size_t i = 3 * std::min(static_cast<size_t>(found - up_to_m2_.begin()), last);
    double u = random->Uniform(), v = random->Uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    return corners_[i] + (corners_[i + 1] - corners_[i]) * u + (corners_[i + 2] - corners_[i]) * v;
  }

 private:
  std::vector<Vec3> corners_;
  std::vector<double> up_to_m2_;
  double area_m2_ = 0;
};

Vec3 DrawIn(const Scope& box, Random* random) {
  const double x = random->Uniform(), y = random->Uniform(), z = random->Uniform();
  return box.ToWorld(box.size * Vec3(x, y, z));
}

/// How much a point is wanted by a bell over the middle of the box: 1 there.
double BellAt(const Vec3& point, const Scope& box, double deviation) {
  const Vec3 from_middle = box.ToLocal(point) - box.size * 0.5;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double sigma = deviation * box.size[i] / 2;
    if (sigma > 0) sum += from_middle[i] * from_middle[i] / (sigma * sigma);
  }
  return std::exp(-sum / 2);
}

Item PointAt(const Vec3& place, const Scope& axes, const Item& parent) {
  Item point;
  point.type = ItemType::kPoint;
  point.scope = axes;
  point.scope.origin = place;
  point.scope.size = Vec3(0, 0, 0);
  point.facing = parent.facing;
  Inherit(parent, &point);
  return point;
}

Result<std::vector<Product>> ApplyScatter(const Item& item, const Action& action) {
  const auto& domain = std::get<std::string>(action.arguments[0]);
  const auto count = static_cast<size_t>(std::get<double>(action.arguments[1]));
  const bool is_bell = std::get<std::string>(action.arguments[2]) == kGaussian;
  const double deviation = std::get<Size>(action.arguments[4]).value;
  Random random(static_cast<uint64_t>(std::get<double>(action.arguments[5])));
  const Scope box = NamedScope(item);
  const Surface surface(item);
  std::vector<Product> products;
  if (domain == kSurface && surface.is_empty()) return products;
  const auto draw = [&] {
    return domain == kSurface ? surface.Draw(&random) : DrawIn(box, &random);
  };
  for (size_t i = 0; i < count; ++i) {
    Vec3 place = draw();
    for (int tries = 0; is_bell && tries < kMostTries; ++tries) {
      if (random.Uniform() < BellAt(place, box, deviation)) break;
      place = draw();
    }
    products.push_back({PointAt(place, box, item), -1});
  }
  return products;
}

constexpr std::array<std::string_view, 2> kDomains = {kSurface, kScope};
constexpr std::array<std::string_view, 2> kDistributions = {kUniform, kGaussian};
constexpr std::array<std::string_view, 1> kCenters = {"center"};

const std::array<Parameter, 6> kParameters = {
    Parameter{.name = "domain",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kSurface),
              .doc = "on the surface of the shape, or in its scope",
              .words = kDomains},
    Parameter{.name = "count",
              .kind = ParameterKind::kFactor,
              .low = 0,
              .high = 1e5,
              .default_value = 10.0,
              .doc = "how many points; what is over a whole number is left out"},
    Parameter{.name = "distribution",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kUniform),
              .doc = "everywhere as many, or more in the middle",
              .words = kDistributions},
    Parameter{.name = "center",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kCenters[0]),
              .required = false,
              .doc = "of a gaussian: the middle of the scope",
              .words = kCenters},
    Parameter{.name = "deviation",
              .kind = ParameterKind::kSize,
              .low = 1e-3,
              .high = 1e3,
              .default_value = Size{Size::Kind::kRelative, 0.5},
              .required = false,
              .doc = "of a gaussian, as a part of half the scope"},
    Parameter{.name = "seed",
              .kind = ParameterKind::kFactor,
              .low = 0,
              .high = 1e9,
              .default_value = 0.0,
              .required = false,
              .doc = "rules draw it anew for each shape"}};

}  // namespace

constinit const Operation kScatter = {
    .name = "scatter",
    .word = "Scatter",
    .doc = "Puts points on a shape by chance, for what stands there: trees, people, stones.",
    .source = "CGA",
    .parameters = kParameters,
    .braces = Braces::kNone,
    .selectors = {},
    .takes = kSurfaced,
    .gives = Types(ItemType::kPoint),
    .in_place = false,
    .sampled = false,
    .apply = ApplyScatter,
};

}  // namespace parti::grammar
