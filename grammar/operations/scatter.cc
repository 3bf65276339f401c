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
/// Points that a gaussian does not want are drawn this often.
constexpr int kMostTries = 512;

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

/// How much points are wanted: more the nearer they are to the center of a bell, 1 there.
class Bell {
 public:
  Bell(const Scope& box, std::string_view center, const Size& deviation)
      : box_(box), center_(PlaceOf(center) * box.size) {
    const bool is_part = deviation.kind == Size::Kind::kRelative;
    sigma_ = is_part ? box.size * deviation.value : Vec3(deviation.value);
  }

  double At(const Vec3& point) const {
    const Vec3 from_center = box_.ToLocal(point) - center_;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      if (box_.size[i] <= 0 || sigma_[i] <= 0) continue;
      sum += from_center[i] * from_center[i] / (sigma_[i] * sigma_[i]);
    }
    return std::exp(-sum / 2);
  }

 private:
  /// As a part of the box: the middle of its named side.
  static Vec3 PlaceOf(std::string_view center) {
    constexpr double kMiddle = 0.5;
    if (center == "left") return {0, kMiddle, kMiddle};
    if (center == "right") return {1, kMiddle, kMiddle};
    if (center == "bottom") return {kMiddle, 0, kMiddle};
    if (center == "top") return {kMiddle, 1, kMiddle};
    if (center == "back") return {kMiddle, kMiddle, 0};
    if (center == "front") return {kMiddle, kMiddle, 1};
    return Vec3(kMiddle);
  }

  Scope box_;
  Vec3 center_, sigma_;
};

/// The first of many draws that the bell takes, or else the one nearest to its center.
template <typename Draw>
Vec3 DrawnBy(const Bell& bell, const Draw& draw, Random* random) {
  Vec3 best = draw();
  double most = bell.At(best);
  if (random->Uniform() < most) return best;
  for (int tries = 1; tries < kMostTries; ++tries) {
    const Vec3 place = draw();
    const double wanted = bell.At(place);
    if (random->Uniform() < wanted) return place;
    if (wanted <= most) continue;
    best = place;
    most = wanted;
  }
  return best;
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
  Random random(static_cast<uint64_t>(std::get<double>(action.arguments[5])));
  const Scope box = NamedScope(item);
  const Bell bell(box, std::get<std::string>(action.arguments[3]),
                  std::get<Size>(action.arguments[4]));
  const Surface surface(item);
  std::vector<Product> products;
  if (domain == kSurface && surface.is_empty()) return products;
  const auto draw = [&] {
    return domain == kSurface ? surface.Draw(&random) : DrawIn(box, &random);
  };
  for (size_t i = 0; i < count; ++i) {
    const Vec3 place = is_bell ? DrawnBy(bell, draw, &random) : draw();
    products.push_back({PointAt(place, box, item), -1});
  }
  return products;
}

constexpr std::array<std::string_view, 2> kDomains = {kSurface, kScope};
constexpr std::array<std::string_view, 2> kDistributions = {kUniform, kGaussian};
constexpr std::array<std::string_view, 7> kCenters = {"center", "front", "back",  "left",
                                                      "right",  "top",   "bottom"};

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
              .doc = "of a gaussian: the middle of the scope, or of a side of it",
              .words = kCenters},
    Parameter{.name = "deviation",
              .kind = ParameterKind::kSize,
              .low = 1e-3,
              .high = 1e3,
              .default_value = Size{Size::Kind::kRelative, 0.16},
              .required = false,
              .doc = "of a gaussian, in metres, or as a part of the scope's sizes"},
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
    .takes = kSurfaced,
    .gives = Types(ItemType::kPoint),
    .in_place = false,
    .sampled = false,
    .apply = ApplyScatter,
};

}  // namespace parti::grammar
