#include "grammar/rules/rule_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <optional>

#include "grammar/rules/evaluate.h"
#include "grammar/rules/random_path.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kUsualStart = "Lot";

std::vector<std::string> StartSymbols(const RuleSet& rules) {
  std::vector<std::string> symbols;
  for (const Rule& rule : rules.rules) {
    if (rule.parameters.empty()) symbols.push_back(rule.symbol);
  }
  return symbols;
}

std::string UsualStart(const RuleSet& rules) {
  for (const Rule& rule : rules.rules) {
    if (rule.start && rule.parameters.empty()) return rule.symbol;
  }
  return std::string(kUsualStart);
}

/// A text as a value of a type; nothing where it is none.
std::optional<Value> ValueFrom(const std::string& text, ValueType type) {
  if (type == ValueType::kText) return text;
  if (type == ValueType::kBool) {
    if (text != "true" && text != "false") return std::nullopt;
    return text == "true";
  }
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(number)) return std::nullopt;  // "inf" and "nan", which no rule can say
  return number;
}

Result<size_t> AttributeNamed(const RuleSet& rules, const std::string& name) {
  std::vector<std::string> names;
  for (size_t i = 0; i < rules.attributes.size(); ++i) {
    if (rules.attributes[i].name == name && !rules.attributes[i].constant) return i;
    if (!rules.attributes[i].constant) names.push_back(rules.attributes[i].name);
    if (rules.attributes[i].name == name) {
      return Fail(ErrorCode::kBadArguments, fmt::format("'{}' is a constant", name),
                  "make it an attr in the rules to set it from outside");
    }
  }
  const auto meant = DidYouMean(name, names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no attribute '{}'", name),
              meant           ? fmt::format("did you mean '{}'?", *meant)
              : names.empty() ? "the rules have none"
                              : fmt::format("attributes are {}", fmt::join(names, ", ")));
}

/// Computes each attribute when it is first needed: after those that its expression names.
class Attributes {
 public:
  Attributes(const RuleSet& rules, const RuleSettings& settings, const Item& lot, uint64_t path,
             NoteBook* notes)
      : rules_(rules),
        evaluator_(rules, settings.limits.steps, notes),
        lot_(lot),
        path_(path),
        seed_(settings.seed),
        values_(rules.attributes.size()),
        states_(rules.attributes.size(), State::kOpen) {}

  void Give(size_t i, Value value) {
    values_[i] = std::move(value);
    states_[i] = State::kDone;
  }

  Result<std::vector<Value>> All() {
    for (size_t i = 0; i < values_.size(); ++i) {
      if (const auto done = Compute(i); !done) return Fail(done);
    }
    return std::move(values_);
  }

 private:
  enum class State : uint8_t { kOpen, kBegun, kDone };

  Result<void> Compute(size_t i) {
    if (states_[i] == State::kDone) return {};
    const Attribute& attribute = rules_.attributes[i];
    if (states_[i] == State::kBegun) return Failed(i, "depends on itself", "give it a value");
    states_[i] = State::kBegun;
    std::vector<bool> functions(rules_.functions.size());
    if (const auto ready = ComputeAllIn(attribute.value, &functions); !ready) return ready;
    Random random(StreamOf(path_, NumberOfName(attribute.name)));
    Situation situation;
    situation.item = situation.lot = &lot_;
    situation.attributes = values_;
    situation.random = &random;
    situation.seed = seed_;
    values_[i] = evaluator_.Of(attribute.value, situation);
    states_[i] = State::kDone;
    if (!evaluator_.failure()) return {};
    return Failed(i, evaluator_.failure()->message, evaluator_.failure()->hint);
  }

  /// The attributes that an expression names, also in the functions that it calls.
  Result<void> ComputeAllIn(const Expression& expression, std::vector<bool>* seen) {
    if (expression.kind == Expression::Kind::kAttribute) {
      if (const auto done = Compute(expression.index); !done) return done;
    }
    if (expression.kind == Expression::Kind::kCall && !(*seen)[expression.index]) {
      (*seen)[expression.index] = true;
      const auto done = ComputeAllIn(rules_.functions[expression.index].value, seen);
      if (!done) return done;
    }
    for (const Expression& operand : expression.operands) {
      if (const auto done = ComputeAllIn(operand, seen); !done) return done;
    }
    return {};
  }

  Result<void> Failed(size_t i, const std::string& message, std::string hint) const {
    const Attribute& attribute = rules_.attributes[i];
    Error error{ErrorCode::kLimitReached, fmt::format("{}: {}", attribute.name, message),
                std::move(hint), PlaceOf(rules_, attribute.range)};
    return tl::unexpected<Error>(std::move(error));
  }

  const RuleSet& rules_;
  Evaluator evaluator_;
  const Item& lot_;
  uint64_t path_;
  uint64_t seed_;
  std::vector<Value> values_;
  std::vector<State> states_;
};

}  // namespace

Result<std::string> StartSymbol(const RuleSet& rules, const RuleSettings& settings) {
  std::string start = settings.start.empty() ? UsualStart(rules) : settings.start;
  const auto symbols = StartSymbols(rules);
  if (std::find(symbols.begin(), symbols.end(), start) != symbols.end()) return start;
  const auto meant = DidYouMean(start, symbols);
  return Fail(ErrorCode::kUnknownName, fmt::format("no rule starts with '{}'", start),
              meant             ? fmt::format("did you mean --start {}?", *meant)
              : symbols.empty() ? "every rule has parameters; a lot has none to give"
                                : fmt::format("for example --start {}", symbols.front()));
}

Result<GivenValue> AttributeValue(const RuleSet& rules, const std::string& name,
                                  const std::string& text) {
  const auto i = AttributeNamed(rules, name);
  if (!i) return Fail(i);
  const ValueType type = rules.attributes[*i].value.type;
  auto value = ValueFrom(text, type);
  if (value) return GivenValue{*i, std::move(*value)};
  return Fail(ErrorCode::kBadArguments, fmt::format("{} can't be '{}'", name, text),
              fmt::format("give a {}", NameOf(type)));
}

Result<void> CheckAllowed(const Attribute& attribute, const Value& value) {
  const auto& choices = attribute.choices;
  const bool is_chosen =
      choices.empty() || std::find(choices.begin(), choices.end(), value) != choices.end();
  if (!is_chosen) {
    std::vector<std::string> texts;
    for (const Value& choice : choices) texts.push_back(TextOf(choice));
    const auto meant = DidYouMean(TextOf(value), texts);
    return Fail(ErrorCode::kBadArguments,
                fmt::format("{} can't be '{}'", attribute.name, TextOf(value)),
                meant ? fmt::format("did you mean '{}'?", *meant)
                      : fmt::format("it is one of {}", fmt::join(texts, ", ")));
  }
  const double* number = std::get_if<double>(&value);
  if (number == nullptr || !attribute.restricted) return {};
  const bool is_low = attribute.low && *number < *attribute.low;
  const bool is_high = attribute.high && *number > *attribute.high;
  if (!is_low && !is_high) return {};
  const std::string range =
      !attribute.high  ? fmt::format("a number from {} on", *attribute.low)
      : !attribute.low ? fmt::format("a number up to {}", *attribute.high)
                       : fmt::format("a number from {} to {}", *attribute.low, *attribute.high);
  return Fail(ErrorCode::kBadNumber, fmt::format("{} is {}", attribute.name, *number),
              "give " + range);
}

Result<std::vector<Value>> AttributesFor(const RuleSet& rules, const RuleSettings& settings,
                                         const Item& lot, uint32_t lot_number, NoteBook* notes,
                                         std::span<const GivenValue> given) {
  Attributes attributes(rules, settings, lot, LotPath(settings.seed, lot_number), notes);
  for (const GivenValue& own : given) attributes.Give(own.index, own.value);
  for (const auto& [name, text] : settings.attributes) {
    auto set = AttributeValue(rules, name, text);
    if (!set) return Fail(set);
    attributes.Give(set->index, std::move(set->value));
  }
  return attributes.All();
}

}  // namespace parti::grammar
