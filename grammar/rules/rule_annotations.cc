// Annotations of attributes: what a panel needs to edit them (CGA).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "grammar/rules/conversions.h"
#include "grammar/rules/rule_checker.h"
#include "grammar/rules/rule_parser.h"

namespace parti::grammar {
namespace {

struct Use {
  std::string_view annotation;
  Attribute::Use use;
};
constexpr std::array<Use, 6> kUses = {{{"Angle", Attribute::Use::kAngle},
                                       {"Color", Attribute::Use::kColor},
                                       {"Directory", Attribute::Use::kDirectory},
                                       {"Distance", Attribute::Use::kDistance},
                                       {"File", Attribute::Use::kFile},
                                       {"Percent", Attribute::Use::kPercent}}};

/// Whether it is @Range(Low = 0, High = 1), as CityEngine once wrote @Enum.
bool NamesChoices(const WrittenAnnotation& range) {
  constexpr std::array<std::string_view, 4> kBounds = {"min", "max", "stepsize", "restricted"};
  return std::none_of(range.arguments.begin(), range.arguments.end(), [&](const auto& argument) {
    const bool is_bound = std::find(kBounds.begin(), kBounds.end(), argument.name) != kBounds.end();
    return argument.name.empty() || is_bound;
  });
}

}  // namespace

void RuleChecker::CheckAnnotations(const WrittenDeclaration& written) {
  for (const WrittenAnnotation& annotation : written.annotations) {
    if (!IsAnnotation(annotation.name)) {
      ReportUnknown(annotation.range, fmt::format("annotation '@{}'", annotation.name),
                    "--skip-unknown leaves it out", /*can_be_skipped=*/true);
    }
  }
}

void RuleChecker::Annotate(const Declared& declared, Attribute* attribute) {
  CheckAnnotations(*declared.written);
  for (const WrittenAnnotation& annotation : declared.written->annotations) {
    AnnotateWith(annotation, attribute);
  }
  const ValueType type = attribute->value.type;
  for (const Value& choice : attribute->choices) {
    if (TypeOf(choice) == type || declared.written->broken) continue;
    Report(declared.written->range, ErrorCode::kBadArguments,
           fmt::format("'{}' is a {}, and one of its choices a {}", attribute->name, NameOf(type),
                       NameOf(TypeOf(choice))));
    return;
  }
}

void RuleChecker::AnnotateWith(const WrittenAnnotation& annotation, Attribute* attribute) {
  const std::string& name = annotation.name;
  const auto* first = annotation.arguments.empty() ? nullptr : &annotation.arguments[0].value;
  for (const Use& use : kUses) {
    if (name == use.annotation) attribute->use = use.use;
  }
  if (name == "Hidden") attribute->hidden = true;
  if (name == "Range") return AnnotateRange(annotation, attribute);
  if (name == "Enum") {
    for (const auto& argument : annotation.arguments) {
      if (argument.name.empty()) AddChoice(argument.value, attribute);
    }
  }
  if ((name != "Group" && name != "Description" && name != "Order") || first == nullptr) return;
  const auto value = Plain(*first);
  if (!value) return;
  const auto* text = std::get_if<std::string>(&*value);
  const auto* number = std::get_if<double>(&*value);
  if (name == "Order" ? number == nullptr : text == nullptr) {
    Report(first->range, ErrorCode::kBadArguments,
           fmt::format("@{} takes a {}", name, name == "Order" ? "number" : "text"));
    return;
  }
  if (name == "Group") attribute->group = *text;
  if (name == "Description") attribute->description = *text;
  if (name == "Order") attribute->order = *number;
}

void RuleChecker::AnnotateRange(const WrittenAnnotation& annotation, Attribute* attribute) {
  std::optional<double>* const by_place[] = {&attribute->low, &attribute->high, &attribute->step};
  size_t place = 0;
  const bool names_choices = NamesChoices(annotation);
  for (const auto& argument : annotation.arguments) {
    const auto value = Plain(argument.value);
    if (!value) return;
    std::optional<double>* bound = argument.name == "min"        ? &attribute->low
                                   : argument.name == "max"      ? &attribute->high
                                   : argument.name == "stepsize" ? &attribute->step
                                                                 : nullptr;
    if (argument.name == "restricted") {
      attribute->restricted = TruthOf(*value);
      continue;
    }
    const bool is_text = argument.name.empty() && !std::holds_alternative<double>(*value);
    if (is_text || (names_choices && bound == nullptr)) {
      AddChoice(argument.value, attribute);  // as @Enum is written now
      continue;
    }
    if (argument.name.empty() && place < std::size(by_place)) bound = by_place[place++];
    const double* number = std::get_if<double>(&*value);
    if (bound == nullptr || number == nullptr) {
      Report(argument.value.range, ErrorCode::kBadArguments,
             "@Range takes the least and the largest value",
             "@Range(2, 6) or @Range(min=2, max=6)");
      return;
    }
    *bound = *number;
  }
  if (!attribute->low && !attribute->high) attribute->restricted = true;
  if (attribute->low && attribute->high && *attribute->low > *attribute->high) {
    Report(annotation.range, ErrorCode::kBadNumber, "this range is empty",
           "the least value stands first");
  }
}

void RuleChecker::AddChoice(const WrittenExpression& written, Attribute* attribute) {
  if (auto value = Plain(written)) attribute->choices.push_back(std::move(*value));
}

std::optional<Value> RuleChecker::Plain(const WrittenExpression& written) {
  if (written.kind == WrittenExpression::Kind::kConstant) return written.constant;
  Report(written.range, ErrorCode::kBadText, "annotations hold plain values",
         "write a number or a text");
  return std::nullopt;
}

}  // namespace parti::grammar
