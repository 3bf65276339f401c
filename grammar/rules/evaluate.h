// Expressions to values: operators, attributes, functions of the rules, chance.
// What the built-in functions compute is built_ins.h's; names and types were checked before.
#pragma once

#include <cstdint>
#include <optional>

#include "base/error.h"
#include "grammar/rules/conversions.h"
#include "grammar/rules/rule_notes.h"
#include "grammar/rules/rule_set.h"
#include "grammar/rules/situation.h"

namespace parti::grammar {

/// Expressions may be nested, and functions may call each other, this deep.
inline constexpr int kDeepestEvaluation = 1000;
/// Expressions that are looked at for one value, at most: a quarter of a second of one core.
/// Functions that call themselves twice end, but not while anybody waits.
inline constexpr uint64_t kMostStepsOfAValue = 20'000'000;

/// Computes expressions one after the other. A failure (functions without end, too many steps, a
/// text longer than kLongestText) is kept: the values after it mean nothing, and whoever asks for a
/// value looks at failure() once.
///
/// Numbers are doubles; what divides by zero is infinite or no number, as in CGA, and is refused
/// where an operation gets it. "+" joins texts; numbers in them are written as TextOf does. "&&"
/// and
/// "||" look at their second operand only where it matters. Operands are computed from left to
/// right, so that draws from the stream have one order. Properties: (1) the same expression in the
/// same situation has the same value; (2) never more than `most_steps` expressions are looked at.
class Evaluator {
 public:
  /// What expressions print goes to `notes`; null: nowhere.
  explicit Evaluator(const RuleSet& rules, uint64_t most_steps, NoteBook* notes = nullptr)
      : rules_(rules), most_steps_(most_steps), notes_(notes) {}

  /// The value as a number: what NumberOf makes of it.
  double Number(const Expression& expression, const Situation& situation);
  /// The value as a truth: what TruthOf makes of it.
  bool Truth(const Expression& expression, const Situation& situation);
  /// The value as it is.
  Value Of(const Expression& expression, const Situation& situation);

  /// Counts one step of the budget; false when there was none left.
  bool Step();
  uint64_t steps() const { return steps_; }  ///< looked at so far
  /// errors  kLimitReached, with no place: the caller knows where it stands.
  const std::optional<Error>& failure() const { return failure_; }

 private:
  /// The value, however long a text it is.
  Value Computed(const Expression& expression, const Situation& situation);
  Value Operated(const Expression& expression, const Situation& situation);
  double OperatedNumber(const Expression& expression, const Situation& situation);
  bool OperatedTruth(const Expression& expression, const Situation& situation);
  bool Compared(const Expression& expression, const Situation& situation);
  Value Called(const Expression& expression, const Situation& situation);
  /// The operand that a case or a chance decides for; null where the failure is known.
  const Expression* Chosen(const Expression& expression, const Situation& situation);
  void Fail(std::string message, std::string hint);

  const RuleSet& rules_;
  uint64_t most_steps_;  ///< 0: any number
  NoteBook* notes_;      ///< may be null
  uint64_t steps_ = 0;
  uint64_t value_steps_ = 0;  ///< since the outermost expression began
  int depth_ = 0;
  std::optional<Error> failure_;
};

}  // namespace parti::grammar
