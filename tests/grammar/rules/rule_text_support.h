// Reading rules in tests: a value, or what is wrong with a text, line by line.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "grammar/rules/rule_text.h"

namespace parti::grammar::tests {

/// Files that may be imported, by their path.
inline RuleImporter From(std::map<std::string, std::string> files) {
  return
      [files = std::move(files)](const std::string& path, const std::string&) -> Result<RuleFile> {
        const auto found = files.find(path);
        if (found == files.end()) return Fail(ErrorCode::kFile, "there is no file '" + path + "'");
        return RuleFile{path, found->second};
      };
}

/// What a text says; a test failure, with all that is wrong, where it says nothing.
inline RuleSet RulesFrom(std::string_view text, const RuleOptions& options = {}) {
  auto rules = ParseRules(text, "test.cga", options);
  if (rules) return std::move(*rules);
  for (const Error& error : rules.error()) ADD_FAILURE() << FormatError(error);
  return {};
}

/// "2:5 message; hint" of each error, in their order.
inline std::vector<std::string> WrongWith(std::string_view text, const RuleOptions& options = {}) {
  const auto rules = ParseRules(text, "test.cga", options);
  std::vector<std::string> wrong;
  if (rules) return wrong;
  for (const Error& error : rules.error()) {
    const std::string place =
        error.place ? fmt::format("{}:{} ", error.place->line, error.place->column) : "";
    wrong.push_back(place + error.message + (error.hint.empty() ? "" : "; " + error.hint));
  }
  return wrong;
}

/// The text, read and written.
inline std::string Written(std::string_view text, const RuleOptions& options = {}) {
  const RuleSet rules = RulesFrom(text, options);
  const std::string written = TextOf(rules);
  EXPECT_TRUE(RulesFrom(written, options) == rules) << written;
  return written;
}

}  // namespace parti::grammar::tests
