// sqrt(x), sin(degrees), max(a, b) …: CGA's functions of numbers. Angles are degrees.
#include <algorithm>
#include <cmath>

#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

constexpr double kRadians = kPi / 180;

double N(Values values, size_t i = 0) { return NumberOf(values[i]); }

constexpr auto kOne = First(kNumbers, 1);
constexpr auto kTwo = First(kNumbers, 2);

/// A row for a function of one number.
template <double (*kFunction)(double)>
constexpr BuiltIn Of(std::string_view name, std::string_view doc) {
  return {name, kOne, kNumber, doc,
          [](Values values, const Situation&) -> Value { return kFunction(N(values)); }};
}

double Sine(double degrees) { return std::sin(degrees * kRadians); }
double Cosine(double degrees) { return std::cos(degrees * kRadians); }
double Tangent(double degrees) { return std::tan(degrees * kRadians); }
double ArcSine(double x) { return std::asin(x) / kRadians; }
double ArcCosine(double x) { return std::acos(x) / kRadians; }
double ArcTangent(double x) { return std::atan(x) / kRadians; }

constexpr BuiltIn kRows[] = {
    Of<std::fabs>("abs", "without its sign"),
    Of<std::ceil>("ceil", "the next whole number that is not smaller"),
    Of<std::floor>("floor", "the next whole number that is not larger"),
    Of<std::rint>("rint", "the nearest whole number; halves go to the even one"),
    Of<std::sqrt>("sqrt", "square root"),
    Of<std::exp>("exp", "e to this power"),
    Of<std::log>("ln", "natural logarithm"),
    Of<std::log10>("log10", "logarithm to base 10"),
    Of<Sine>("sin", "sine of an angle in degrees"),
    Of<Cosine>("cos", "cosine of an angle in degrees"),
    Of<Tangent>("tan", "tangent of an angle in degrees"),
    Of<ArcSine>("asin", "the angle, in degrees, of this sine"),
    Of<ArcCosine>("acos", "the angle, in degrees, of this cosine"),
    Of<ArcTangent>("atan", "the angle, in degrees, of this tangent"),
    {"atan2", kTwo, kNumber, "the angle, in degrees, of the direction (second, first)",
     [](Values v, const Situation&) -> Value { return std::atan2(N(v), N(v, 1)) / kRadians; }},
    {"pow", kTwo, kNumber, "the first to the power of the second",
     [](Values v, const Situation&) -> Value { return std::pow(N(v), N(v, 1)); }},
    {"min", kTwo, kNumber, "the smaller one",
     [](Values v, const Situation&) -> Value { return std::min(N(v), N(v, 1)); }},
    {"max", kTwo, kNumber, "the larger one",
     [](Values v, const Situation&) -> Value { return std::max(N(v), N(v, 1)); }},
    {"clamp", kNumbers, kNumber, "the first, but not below the second or above the third",
     [](Values v, const Situation&) -> Value {
       return std::min(std::max(N(v), N(v, 1)), N(v, 2));
     }},
    {"isnan", kOne, kBool, "whether it is no number: 0/0",
     [](Values v, const Situation&) -> Value { return std::isnan(N(v)); }},
    {"isinf", kOne, kBool, "whether it is infinite: 1/0",
     [](Values v, const Situation&) -> Value { return std::isinf(N(v)); }},
};

}  // namespace

std::span<const BuiltIn> Maths() { return kRows; }

}  // namespace parti::grammar::built_ins
