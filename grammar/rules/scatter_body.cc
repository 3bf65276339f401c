#include "grammar/rules/scatter_body.h"

#include <algorithm>
#include <utility>

namespace parti::grammar {
namespace {

using Steps = std::vector<WrittenStatement>;
using Kind = WrittenExpression::Kind;

constexpr size_t kOfGaussian = 5;  ///< arguments before the seed
constexpr double kUsualDeviation = 0.16;

bool HasBody(const WrittenStatement& step) {
  return step.kind == WrittenStatement::Kind::kNamed && step.name == "scatter" && step.braces &&
         step.arguments.size() >= 3 && step.arguments.size() <= kOfGaussian &&
         step.alternatives.size() == 1 && !step.alternatives[0].group &&
         step.alternatives[0].key.empty() &&
         step.alternatives[0].body.kind == Body::Kind::kSequence;
}

WrittenArgument Argument(WrittenExpression value, Size::Kind size, TextRange range) {
  value.range = range;
  return {size, std::move(value), range};
}

WrittenExpression Number(double number) {
  WrittenExpression expression;
  expression.constant = number;
  return expression;
}

WrittenExpression Named(Kind kind, std::string name) {
  WrittenExpression expression;
  expression.kind = kind;
  expression.name = std::move(name);
  return expression;
}

/// What was left out, and the seed.
void AddArguments(WrittenStatement* scatter) {
  auto& arguments = scatter->arguments;
  const TextRange range = scatter->range;
  if (arguments.size() < 4) {
    arguments.push_back(Argument(Named(Kind::kName, "center"), Size::Kind::kAbsolute, range));
  }
  if (arguments.size() < kOfGaussian) {
    arguments.push_back(Argument(Number(kUsualDeviation), Size::Kind::kRelative, range));
  }
  WrittenExpression seed = Named(Kind::kCall, "rand");
  seed.operands.push_back(Number(kScatterSeeds));
  seed.operands[0].range = range;
  arguments.push_back(Argument(std::move(seed), Size::Kind::kAbsolute, range));
}

WrittenStatement Bracket(WrittenStatement::Kind kind, TextRange range) {
  WrittenStatement bracket;
  bracket.kind = kind;
  bracket.range = range;
  return bracket;
}

}  // namespace

std::optional<Steps> WithScatterInBrackets(const Steps& steps) {
  if (std::none_of(steps.begin(), steps.end(), HasBody)) return std::nullopt;
  Steps turned;
  for (const WrittenStatement& step : steps) {
    if (!HasBody(step)) {
      turned.push_back(step);
      continue;
    }
    WrittenStatement scatter = step;
    Steps body = std::move(scatter.alternatives[0].body.statements);
    if (auto inner = WithScatterInBrackets(body)) body = std::move(*inner);
    scatter.alternatives.clear();
    scatter.braces = false;
    AddArguments(&scatter);
    turned.push_back(Bracket(WrittenStatement::Kind::kPush, step.range));
    turned.push_back(std::move(scatter));
    turned.insert(turned.end(), body.begin(), body.end());
    turned.push_back(Bracket(WrittenStatement::Kind::kPop, step.range));
  }
  return turned;
}

}  // namespace parti::grammar
