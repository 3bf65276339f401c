// The parts of the table of built-in functions, one file each, and what their rows are made of.
// What a row is stands in built_ins.h.
#pragma once

#include <array>

#include "grammar/rules/built_ins.h"
#include "grammar/rules/conversions.h"
#include "grammar/rules/situation.h"

namespace parti::grammar::built_ins {

std::span<const BuiltIn> Maths();        ///< of numbers: sqrt(x)
std::span<const BuiltIn> Chance();       ///< draws from the shape's stream: rand()
std::span<const BuiltIn> Conversions();  ///< from one type to another: str(x)
std::span<const BuiltIn> Texts();        ///< of texts: len(text)
std::span<const BuiltIn> Lists();        ///< of texts that are lists: listSize(text)
std::span<const BuiltIn> Places();       ///< where a shape stands: scope.sx
std::span<const BuiltIn> Geometries();   ///< what its geometry is like: geometry.area
std::span<const BuiltIn> Faces();        ///< what some of its faces are like: geometry.area(top)
std::span<const BuiltIn> Paints();       ///< what it wears: material.opacity, geometry.du
std::span<const BuiltIn> Colors();       ///< of colors: colorHexToR(color)
std::span<const BuiltIn> Paths();        ///< of paths: fileName(path)

using Values = std::span<const Value>;
using OperandTypes = std::span<const std::optional<ValueType>>;

inline constexpr ValueType kNumber = ValueType::kNumber, kBool = ValueType::kBool,
                           kText = ValueType::kText;
inline constexpr std::array<std::optional<ValueType>, 3> kNumbers = {kNumber, kNumber, kNumber};
inline constexpr std::array<std::optional<ValueType>, 3> kTexts = {kText, kText, kText};

/// The first `count` of an array, as operands.
template <size_t kSize>
constexpr OperandTypes First(const std::array<std::optional<ValueType>, kSize>& types,
                             size_t count) {
  return OperandTypes(types).first(count);
}

}  // namespace parti::grammar::built_ins
