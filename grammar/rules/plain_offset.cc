#include "grammar/rules/plain_offset.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

namespace parti::grammar {
namespace {

using Steps = std::vector<WrittenStatement>;

constexpr std::string_view kInside = "inside", kBorder = "border", kAll = "all", kShape = "shape";
constexpr std::string_view kInnerRect = "innerRect";

/// The bare word that an argument is; "" for none.
std::string_view WordOf(const WrittenArgument& argument) {
  const bool is_word = argument.value.kind == WrittenExpression::Kind::kName &&
                       argument.size == Size::Kind::kAbsolute;
  return is_word ? std::string_view(argument.value.name) : std::string_view();
}

/// Which part it keeps; "" where the step is no offset without braces.
std::string_view PartOf(const WrittenStatement& step) {
  const bool is_step =
      step.kind == WrittenStatement::Kind::kNamed && !step.braces && !step.deferred;
  if (is_step && step.name == kInnerRect && step.arguments.empty()) return kShape;
  const bool is_plain = is_step && step.name == "offset" && step.called;
  if (!is_plain || step.arguments.empty() || step.arguments.size() > 2) return "";
  if (step.arguments.size() == 1) return kAll;
  const std::string_view word = WordOf(step.arguments[1]);
  return word == kInside || word == kBorder || word == kAll ? word : "";
}

WrittenAlternative AlternativeFor(std::string_view part, const WrittenStatement& offset) {
  WrittenAlternative alternative;
  alternative.range = offset.range;
  WrittenArgument& key = alternative.key.emplace_back();
  key.range = key.value.range = offset.range;
  key.value.kind = WrittenExpression::Kind::kName;
  key.value.name = part;
  alternative.body.range = offset.range;
  return alternative;
}

/// Whether the step only tells the inside from the border.
bool SortsParts(const WrittenStatement& step) {
  const bool is_comp = step.name == "comp" && step.arguments.size() == 1 &&
                       WordOf(step.arguments[0]) == "f" && !step.alternatives.empty();
  return is_comp && std::all_of(step.alternatives.begin(), step.alternatives.end(),
                                [](const WrittenAlternative& alternative) {
                                  if (alternative.key.size() != 1) return false;
                                  const std::string_view word = WordOf(alternative.key[0]);
                                  return word == kInside || word == kBorder || word == kAll;
                                });
}

/// The alternatives of such a comp, in its order: all is what no selector before it takes.
std::vector<WrittenAlternative> Sorted(const WrittenStatement& comp) {
  std::vector<WrittenAlternative> sorted;
  std::vector<std::string_view> left = {kInside, kBorder};
  for (const WrittenAlternative& alternative : comp.alternatives) {
    const std::string_view word = WordOf(alternative.key[0]);
    for (const std::string_view part : std::vector(left)) {
      if (word != part && word != kAll) continue;
      std::erase(left, part);
      sorted.push_back(alternative);
      sorted.back().key[0].value.name = part;
    }
  }
  return sorted;
}

/// The step that closes the brackets which step `from` stands in, or the end.
Steps::const_iterator EndOfBrackets(Steps::const_iterator from, Steps::const_iterator end) {
  int depth = 0;
  return std::find_if(from, end, [&](const WrittenStatement& step) {
    if (step.kind == WrittenStatement::Kind::kPush) ++depth;
    return step.kind == WrittenStatement::Kind::kPop && --depth < 0;
  });
}

/// The steps with the first of them changed.
std::optional<Steps> WithOneBraced(const Steps& steps) {
  const auto found = std::find_if(steps.begin(), steps.end(),
                                  [](const auto& step) { return !PartOf(step).empty(); });
  if (found == steps.end()) return std::nullopt;
  const std::string_view part = PartOf(*found);
  auto next = std::next(found);
  const auto end = EndOfBrackets(next, steps.end());
  WrittenStatement offset = *found;
  offset.braces = offset.called = true;
  offset.arguments.resize(1);
  if (part == kShape) {
    offset.name = "innerRectangle";
    offset.arguments[0].value.kind = WrittenExpression::Kind::kName;
    offset.arguments[0].value.name = "scope";
    offset.arguments[0].range = offset.arguments[0].value.range = offset.range;
  }
  if (part == kAll && next != end && SortsParts(*next)) {
    offset.alternatives = Sorted(*next);
    ++next;
  } else {
    for (const std::string_view kept : {kInside, kBorder, kShape}) {
      if (part != kept && (part != kAll || kept == kShape)) continue;
      offset.alternatives.push_back(AlternativeFor(kept, offset));
      offset.alternatives.back().body.statements.assign(next, end);
    }
    next = end;
  }
  Steps braced(steps.begin(), found);
  braced.push_back(std::move(offset));
  braced.insert(braced.end(), next, steps.end());
  return braced;
}

}  // namespace

std::optional<Steps> WithBracedOffsets(const Steps& steps) {
  auto braced = WithOneBraced(steps);
  while (braced) {
    auto more = WithOneBraced(*braced);
    if (!more) break;
    braced = std::move(more);
  }
  return braced;
}

}  // namespace parti::grammar
