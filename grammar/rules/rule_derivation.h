// Derivation by rules: every shape whose symbol has a rule is derived until only terminals are left
// (Jesus 2018, 4.4). Lots, and within a lot the shapes that wait, are derived at the same
// time. What one shape's rule does is rule_runner.h's.
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_settings.h"
#include "grammar/shape_tree.h"

namespace parti::grammar {

class AssetLibrary;
struct LotNotes;

/// Lots that rules fail on.
struct LotFailures {
  /// One of them: `lot` counts from 0.
  struct One {
    size_t lot;
    Error error;
  };
  bool wants_all = false;  ///< else a derivation ends with the first
  std::vector<One> found;  ///< by lot
};

/// How much at once, and what is watched meanwhile; nothing of it changes the
/// result but that files may be read.
struct RuleThreads {
  int count = 0;                                 ///< 0: as many as the machine has
  const std::atomic<bool>* cancelled = nullptr;  ///< may be null
  double (*now_s)() = nullptr;  ///< a clock that never goes back; null: no limit of seconds
  /// Time for normalisations is added to it; may be null, and is where there is no clock.
  std::atomic<double>* normalise_s = nullptr;
  /// Reads what i() and texture() name, relative to the file that says so; null: they fail.
  AssetLibrary* assets = nullptr;
  /// What rules report and print (rule_notes.h): one for each lot, in their order, or, where one
  /// fails, up to that; null: none of it is kept.
  std::vector<LotNotes>* notes = nullptr;
  LotFailures* failures = nullptr;  ///< where lots fail, which; may be null
};

/// One shape tree per lot. `given` has for each lot the values of its own for attributes, or is
/// empty: none has any.
///
/// The lot's symbol is the start symbol. A body runs step by step on the shape in hand: an
/// operation without braces changes it, one with braces makes a child of each product, which
/// becomes what its successor says, and a symbol makes a child of what is in hand. So the
/// operations of one body make one level of the tree. A body that makes no child leaves what is in
/// hand as a child without symbol, or, where nothing but names and colors changed, the shape
/// itself; NIL, and an operation that leaves nothing, hide the shape.
///
/// What a planar shape's rules make of layers and 2D shapes is its scene, whose order is that of
/// Listing 4.9: first all that stays two-dimensional, then the normalisation, then what was
/// deferred, one after the other, each normalised, then all else (errata 1, 9, 9a). Scenes do not
/// depend on each other, so that each is derived to its end by itself.
///
/// Properties: (1) the same rules, settings and lots give the same trees and notes, to the byte, on
/// any number of threads; (2) random draws of a shape depend on its path, the seed and the lot's
/// number only.
///
/// errors  those of StartSymbol and AttributesFor;  those of operations, naming rule, operation,
///         shape and place, of the first lot that fails;  kLimitReached;  kNothingMade  nothing of
///         all lots is visible.
/// cost    linear in shapes; scenes as layers/normalise.h says.
Result<std::vector<ShapeTree>> DeriveRules(const RuleSet& rules, const RuleSettings& settings,
                                           std::span<const Item> lots,
                                           const RuleThreads& threads = {},
                                           std::span<const std::vector<GivenValue>> given = {});

}  // namespace parti::grammar
