// rand(), p(): draws from the stream of the shape, so that an edit elsewhere never changes them.
#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

Value Rand(Values values, const Situation& situation) {
  const double share = situation.random->Uniform();
  if (values.empty()) return share;
  const double low = values.size() > 1 ? NumberOf(values[0]) : 0;
  const double high = NumberOf(values.back());
  return low + (high - low) * share;
}

constexpr BuiltIn kRows[] = {
    {"rand", {}, kNumber, "a number from 0 to 1 by chance", Rand},
    {"rand", First(kNumbers, 1), kNumber, "a number from 0 to the one given", Rand},
    {"rand", First(kNumbers, 2), kNumber, "a number between the two given", Rand},
    {"p", First(kNumbers, 1), kBool, "true with this probability, 0 to 1",
     [](Values values, const Situation& situation) -> Value {
       return situation.random->Uniform() < NumberOf(values[0]);
     }},
    {"seedian",
     {},
     kNumber,
     "the seed of the derivation",
     [](Values, const Situation& situation) -> Value {
       return static_cast<double>(situation.seed);
     }},
};

}  // namespace

std::span<const BuiltIn> Chance() { return kRows; }

}  // namespace parti::grammar::built_ins
