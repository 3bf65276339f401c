// Properties of reading and writing rules, on random files.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "grammar/rules/rule_text.h"
#include "tests/grammar/rules/random_rules.h"

namespace parti::grammar::tests {
namespace {

RuleSet Read(const std::string& text) {
  auto rules = ParseRules(text, "random.cga");
  if (!rules) RC_FAIL(FormatError(rules.error()[0]));
  return std::move(*rules);
}

RC_GTEST_PROP(RuleTextProperty, WhatIsWrittenReadsBackAsTheSameValue, ()) {
  const std::string text = *AnyRules();
  const RuleSet rules = Read(text);
  const std::string written = TextOf(rules);
  RC_LOG() << text << "\n----\n" << written;
  RC_ASSERT(Read(written) == rules);
  RC_ASSERT(TextOf(Read(written)) == written);
}

RC_GTEST_PROP(RuleTextProperty, BlanksAndCommentsMeanNothing, ()) {
  const std::string text = *AnyRules();
  std::string spaced;
  for (const char c : text)
    spaced += c == ' ' ? " /* { */\t" : c == '\n' ? "// }\n\n# |\n" : std::string(1, c);
  RC_ASSERT(Read(spaced) == Read(text));
}

RC_GTEST_PROP(RuleTextProperty, AnyPieceOfATextEndsInAValueOrInErrorsWithPlaces, ()) {
  const std::string text = *AnyRules();
  const auto from = *rc::gen::inRange<size_t>(0, text.size());
  const auto to = *rc::gen::inRange(from, text.size());
  const auto rules = ParseRules(std::string_view(text).substr(from, to - from), "piece.cga");
  if (rules) return;
  RC_ASSERT(!rules.error().empty());
  for (const Error& error : rules.error()) RC_ASSERT(error.place.has_value());
}

}  // namespace
}  // namespace parti::grammar::tests
