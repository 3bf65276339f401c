#include "grammar/rules/rule_modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace parti::grammar {
namespace {

constexpr std::string_view kDefault = "Default";

const WrittenStyle* StyleNamed(const WrittenRules& rules, std::string_view name) {
  for (const WrittenStyle& style : rules.styles) {
    if (style.name == name) return &style;
  }
  return nullptr;
}

int DepthOf(const RuleModule& module) {
  int depth = 0;
  for (const RuleModule* up = module.importer; up != nullptr; up = up->importer) ++depth;
  return depth;
}

/// Whether the file, or one that imports it, has this name.
bool IsWithin(const RuleModule* module, std::string_view name, const RuleErrors& errors) {
  for (; module != nullptr; module = module->importer) {
    if (errors.files()[module->file].name == name) return true;
  }
  return false;
}

/// Adds the modules that a module imports.
class Importing {
 public:
  Importing(const RuleImporter& importer, std::deque<RuleModule>* modules, RuleErrors* errors)
      : importer_(importer), modules_(modules), errors_(errors) {}

  void ImportsOf(RuleModule* module) {
    std::set<std::string_view> prefixes;
    for (const WrittenImport& import : module->rules.imports) {
      if (!prefixes.insert(import.prefix).second) {
        errors_->Report(import.range, ErrorCode::kBadText,
                        fmt::format("two imports have the prefix '{}'", import.prefix));
      } else if (!Import(*module, import)) {
        module->lost.push_back(import.prefix + ".");
      }
    }
  }

 private:
  bool Refuse(const WrittenImport& import, Error error) {
    errors_->Report(import.range, std::move(error));
    return false;
  }

  bool Import(const RuleModule& module, const WrittenImport& import) {
    if (modules_->size() > kMostImports || DepthOf(module) >= kDeepestImport) {
      return Refuse(import, {ErrorCode::kLimitReached, "too many files are imported",
                             fmt::format("at most {}, and {} deep", kMostImports, kDeepestImport)});
    }
    if (!importer_) return Refuse(import, {ErrorCode::kFile, "files can't be imported here"});
    auto file = importer_(import.path, errors_->files()[module.file].name);
    if (!file) return Refuse(import, std::move(file.error()));
    if (IsWithin(&module, file->name, *errors_)) {
      return Refuse(import, {ErrorCode::kFile, fmt::format("'{}' imports itself", import.path)});
    }
    RuleModule& added = modules_->emplace_back();
    added.file = errors_->AddFile(std::move(file->name), std::move(file->text));
    added.prefix = module.prefix + import.prefix + ".";
    added.importer = &module;
    added.import = &import;
    added.rules = ReadRules(errors_->files()[added.file].text, added.file, errors_);
    CheckStyles(added.rules, errors_);
    if (!import.style.empty() && import.style != kDefault &&
        StyleNamed(added.rules, import.style) == nullptr) {
      errors_->Report(import.range, ErrorCode::kUnknownName,
                      fmt::format("'{}' has no style '{}'", import.path, import.style));
    }
    return true;
  }

  const RuleImporter& importer_;
  std::deque<RuleModule>* modules_;
  RuleErrors* errors_;
};

/// From the style down to the one that all are based on; what goes round is cut.
std::vector<const WrittenStyle*> ChainOf(const WrittenRules& rules, std::string_view name) {
  std::vector<const WrittenStyle*> chain;
  for (const WrittenStyle* style = StyleNamed(rules, name); style != nullptr;
       style = StyleNamed(rules, style->base)) {
    if (std::find(chain.begin(), chain.end(), style) != chain.end()) break;
    chain.push_back(style);
  }
  return chain;
}

}  // namespace

std::deque<RuleModule> ReadModules(std::string_view text, std::string_view file,
                                   const RuleImporter& importer, RuleErrors* errors) {
  std::deque<RuleModule> modules(1);
  modules[0].file = errors->AddFile(std::string(file), std::string(text));
  modules[0].rules = ReadRules(errors->files()[0].text, 0, errors);
  CheckStyles(modules[0].rules, errors);
  Importing importing(importer, &modules, errors);
  for (size_t i = 0; i < modules.size() && !errors->Full(); ++i) importing.ImportsOf(&modules[i]);
  return modules;
}

std::vector<const WrittenDeclaration*> DeclarationsIn(const WrittenRules& rules,
                                                      std::string_view style) {
  using Key = std::pair<std::string_view, size_t>;
  std::vector<const WrittenDeclaration*> declarations;
  std::map<Key, size_t> places;
  for (const WrittenDeclaration& own : rules.declarations) {
    places.try_emplace({own.name, own.parameters.size()}, declarations.size());
    declarations.push_back(&own);
  }
  const auto chain = ChainOf(rules, style);
  for (auto layer = chain.rbegin(); layer != chain.rend(); ++layer) {
    for (const WrittenDeclaration& other : (*layer)->declarations) {
      const auto [place, added] =
          places.try_emplace({other.name, other.parameters.size()}, declarations.size());
      if (added) {
        declarations.push_back(&other);
      } else {
        declarations[place->second] = &other;
      }
    }
  }
  return declarations;
}

void CheckStyles(const WrittenRules& rules, RuleErrors* errors) {
  std::set<std::string_view> names = {kDefault};
  for (const WrittenStyle& style : rules.styles) {
    if (!names.insert(style.name).second) {
      errors->Report(style.range, ErrorCode::kBadText,
                     fmt::format("there is a style '{}' already", style.name));
    }
    const auto chain = ChainOf(rules, style.name);
    const std::string& last = chain.empty() ? style.base : chain.back()->base;
    if (last == kDefault) continue;
    const bool round = StyleNamed(rules, last) != nullptr;
    errors->Report(style.base_range, ErrorCode::kUnknownName,
                   round ? fmt::format("the style '{}' is based on itself", style.name)
                         : fmt::format("there is no style '{}'", last));
  }
}

}  // namespace parti::grammar
