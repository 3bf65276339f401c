// A shape that waits for its rule, and what it brings along: all that its derivation depends on
// besides the rules, so that tasks of different shapes can run in any order, or at the same time.
#pragma once

#include <memory>
#include <vector>

#include "base/random.h"
#include "grammar/rules/random_path.h"
#include "grammar/rules/rule_program.h"
#include "grammar/rules/situation.h"

namespace parti::grammar {

/// Values that many shapes share; null: none, or those of the lot.
using SharedValues = std::shared_ptr<const std::vector<Value>>;

/// What a shape hands down to those that are made of it.
struct Inheritance {
  SharedValues attributes;  ///< null: the lot's; set() makes others
  Turn split, comp;
};

/// Where a shape's random numbers come from.
struct Stream {
  explicit Stream(uint64_t of_path) : path(of_path), random(of_path) {}

  uint64_t path;
  Random random;
  uint32_t born = 0;  ///< shapes that were made, or might have been, so far

  /// The stream of the next shape to be made.
  Stream Next() { return Stream(StreamOf(path, born++)); }
};

/// Cheap to copy: everything in it is shared, or a number.
struct RuleTask {
  ShapeIndex shape = 0;
  const BodyPlan* body = nullptr;
  SharedValues parameters;  ///< of the rule that the body stands in
  Inheritance inherited;
  Stream stream{0};
  uint32_t from = 0;         ///< the step of the body to go on with
  uint32_t to = UINT32_MAX;  ///< the step before which it ends
  uint32_t level = 0;        ///< rules above it
  bool becomes =
      false;  ///< the shape itself becomes what the body makes, and has no children of it
};

}  // namespace parti::grammar
