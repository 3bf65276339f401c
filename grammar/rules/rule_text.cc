#include "grammar/rules/rule_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grammar/rules/rule_check.h"
#include "grammar/rules/rule_modules.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kDefault = "Default";

std::string Trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const size_t from = text.find_first_not_of(kBlanks);
  if (from == std::string_view::npos) return "";
  return std::string(text.substr(from, text.find_last_not_of(kBlanks) + 1 - from));
}

bool HasStyle(const WrittenRules& rules, std::string_view name) {
  return name.empty() || name == kDefault ||
         std::any_of(rules.styles.begin(), rules.styles.end(),
                     [&](const WrittenStyle& style) { return style.name == name; });
}

Error NoSuchStyle(const WrittenRules& rules, std::string_view name) {
  std::vector<std::string> names;
  for (const WrittenStyle& style : rules.styles) names.push_back(style.name);
  const auto meant = DidYouMean(name, names);
  return {ErrorCode::kUnknownName, fmt::format("there is no style '{}'", name),
          meant           ? fmt::format("did you mean '{}'?", *meant)
          : names.empty() ? "the rules have no styles"
                          : fmt::format("styles are {}", fmt::join(names, ", "))};
}

Error NoSuchStart(const RuleSet& rules, const std::string& start) {
  std::vector<std::string> names;
  for (const Rule& rule : rules.rules) {
    if (rule.symbol == start) {
      return {ErrorCode::kBadArguments,
              fmt::format("the rule '{}' has parameters, and can't be started with", start),
              "start with a rule without them"};
    }
    if (rule.parameters.empty()) names.push_back(rule.symbol);
  }
  const auto meant = DidYouMean(start, names);
  return {ErrorCode::kUnknownName, fmt::format("there is no rule '{}' to start with", start),
          meant           ? fmt::format("did you mean '{}'?", *meant)
          : names.empty() ? "the text has no rules"
                          : fmt::format("rules are {}", fmt::join(names, ", "))};
}

std::vector<RuleStyle> StylesOf(const WrittenRules& rules, std::string_view text) {
  std::vector<RuleStyle> styles;
  for (const WrittenStyle& style : rules.styles) {
    const std::string_view own = text.substr(style.text.from, style.text.to - style.text.from);
    styles.push_back({style.name, style.base, Trimmed(own)});
  }
  return styles;
}

/// What the first file imports, with the values that were given resolved in it.
std::vector<RuleImport> ImportsOf(const RuleModule& root, const RuleSet& set) {
  std::vector<RuleImport> imports;
  for (const WrittenImport& written : root.rules.imports) {
    RuleImport& import = imports.emplace_back();
    import.prefix = written.prefix;
    import.path = written.path;
    import.style = written.style;
    import.protects = written.protects;
    for (const WrittenImport::Attribute& attribute : written.attributes) {
      auto& [name, value] = import.attributes.emplace_back(attribute.name, std::nullopt);
      const auto found = std::find_if(
          set.attributes.begin(), set.attributes.end(),
          [&](const Attribute& a) { return a.name == written.prefix + "." + attribute.name; });
      if (!attribute.value.empty() && found != set.attributes.end()) value = found->value;
    }
  }
  return imports;
}

}  // namespace

tl::expected<RuleSet, std::vector<Error>> ParseRules(std::string_view text, std::string_view file,
                                                     const RuleOptions& options) {
  RuleErrors errors;
  auto modules = ReadModules(text, file, options.importer, &errors);
  WrittenRules& root = modules[0].rules;
  if (!HasStyle(root, options.style)) {
    return tl::unexpected<std::vector<Error>>({NoSuchStyle(root, options.style)});
  }
  // A style that nobody asks for may be wrong as well.
  for (const WrittenStyle& style : root.styles) {
    if (!errors.Full() && style.name != options.style) CheckRules(modules, style.name, &errors);
  }
  if (!options.style.empty() && !errors.Full()) CheckRules(modules, kDefault, &errors);
  RuleSet set = CheckRules(modules, options.style, &errors);
  if (options.skip_unknown) set.skipped = errors.SkipUnknown();
  if (!errors.empty()) return tl::unexpected<std::vector<Error>>(errors.Take());
  if (!options.start.empty() && RuleFor(set, options.start) == kNoRule) {
    return tl::unexpected<std::vector<Error>>({NoSuchStart(set, options.start)});
  }
  set.version = root.version;
  set.trees = std::move(root.trees);
  set.styles = StylesOf(root, errors.files()[0].text);
  set.imports = ImportsOf(modules[0], set);
  set.style = options.style == kDefault ? "" : options.style;
  set.files = errors.TakeFiles();
  return set;
}

}  // namespace parti::grammar
