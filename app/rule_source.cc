#include "app/rule_source.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/json.h"
#include "base/text_file.h"
#include "grammar/asset_library.h"
#include "grammar/rules/rule_text.h"

namespace parti::app {
namespace {

using grammar::RuleFile;

/// What a file may be called that another one imports: "towers/roof.cga" for "roof.cga" in
/// "towers/lot.cga", then "roof.cga", "../roof.cga" …
std::vector<std::string> NamesOf(const std::string& path, const std::string& importing) {
  std::vector<std::string> names = grammar::PathsFor(grammar::FolderOf(importing), path);
  for (std::string& name : names) name = std::filesystem::path(name).lexically_normal().string();
  return names;
}

const RuleFile* FileNamed(const std::vector<RuleFile>& files, const std::string& name) {
  for (const RuleFile& file : files) {
    if (file.name == name) return &file;
  }
  return nullptr;
}

ParsedRules Parsed(const std::string& text, const std::string& name, const RuleSource& source,
                   grammar::RuleImporter importer) {
  grammar::RuleOptions options;
  options.importer = std::move(importer);
  options.style = source.style;
  options.skip_unknown = source.skip_unknown;
  options.start = source.settings.start;
  auto rules = grammar::ParseRules(text, name, options);
  if (!rules) return rules;
  auto edited = grammar::WithLayers(std::move(*rules), source.layers);
  if (!edited) return tl::unexpected<std::vector<Error>>({edited.error()});
  return std::move(*edited);
}

Json PairsJson(const std::vector<std::pair<std::string, std::string>>& pairs) {
  Json list = Json::array();
  for (const auto& [name, value] : pairs) list.push_back(Json::array({name, value}));
  return list;
}

Json LimitsJson(const grammar::RuleLimits& limits) {
  return {{"depth", limits.depth},
          {"shapes", limits.shapes},
          {"steps", limits.steps},
          {"seconds", limits.seconds}};
}

Json LayersJson(const grammar::LayerEdits& layers) {
  Json json = Json::object();
  if (!layers.off.empty()) json["off"] = layers.off;
  if (!layers.rules.empty()) json["rules"] = PairsJson(layers.rules);
  for (const auto& [rule, order] : layers.order) json["order"].push_back({rule, order});
  return json;
}

grammar::LayerEdits LayersFrom(const Json& json) {
  grammar::LayerEdits layers;
  layers.off = json.value("off", std::vector<std::string>());
  layers.rules = json.value("rules", std::vector<std::pair<std::string, std::string>>());
  layers.order =
      json.value("order", std::vector<std::pair<std::string, std::vector<std::string>>>());
  return layers;
}

std::string Dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Takes a document's text apart; what is of another type than it should be throws, and is caught
/// in RuleSourceFrom.
RuleSource SourceFrom(const Json& json) {
  using Pairs = std::vector<std::pair<std::string, std::string>>;
  RuleSource source;
  for (const Json& file : json.at("files")) {
    source.files.push_back(
        {file.at("name").get<std::string>(), file.at("text").get<std::string>()});
  }
  source.style = json.value("style", "");
  source.skip_unknown = json.value("skip_unknown", false);
  source.layers = LayersFrom(json.value("layers", Json::object()));
  source.settings.start = json.value("start", "");
  source.settings.seed = json.value("seed", uint64_t{0});
  source.settings.attributes = json.value("attributes", Pairs());
  if (const auto limits = json.find("limits"); limits != json.end()) {
    limits->at("depth").get_to(source.settings.limits.depth);
    limits->at("shapes").get_to(source.settings.limits.shapes);
    limits->at("steps").get_to(source.settings.limits.steps);
    limits->at("seconds").get_to(source.settings.limits.seconds);
  }
  return source;
}

}  // namespace

ParsedRules ReadRules(const std::string& path, RuleSource* source) {
  const auto text = ReadFile(path);
  if (!text) return tl::unexpected<std::vector<Error>>({text.error()});
  const auto importer = [](const std::string& imported,
                           const std::string& importing) -> Result<RuleFile> {
    const std::vector<std::string> names = NamesOf(imported, importing);
    for (const std::string& name : names) {
      if (auto content = ReadFile(name)) return RuleFile{name, std::move(*content)};
    }
    return Fail(ReadFile(names.front()));
  };
  auto rules = Parsed(*text, path, *source, importer);
  if (rules) source->files = rules->files;
  return rules;
}

ParsedRules RulesOf(const RuleSource& source) {
  if (source.files.empty()) {
    return tl::unexpected<std::vector<Error>>(
        {Error{ErrorCode::kDamagedFile, "rules without a text", "", std::nullopt}});
  }
  const auto importer = [&](const std::string& imported,
                            const std::string& importing) -> Result<RuleFile> {
    const std::vector<std::string> names = NamesOf(imported, importing);
    for (const std::string& name : names) {
      if (const RuleFile* file = FileNamed(source.files, name)) return *file;
    }
    return Fail(ErrorCode::kFile, fmt::format("the document has no '{}'", names.front()));
  };
  return Parsed(source.files[0].text, source.files[0].name, source, importer);
}

ParsedRules RulesToWrite(const RuleSource& source) {
  auto rules = RulesOf(source);
  if (!rules) return rules;
  for (const auto& [name, text] : source.settings.attributes) {
    auto given = grammar::AttributeValue(*rules, name, text);
    if (!given) return tl::unexpected<std::vector<Error>>({given.error()});
    grammar::Expression value;
    value.type = grammar::TypeOf(given->value);
    value.constant = std::move(given->value);
    rules->attributes[given->index].value = std::move(value);
  }
  if (source.settings.start.empty()) return rules;
  for (grammar::Rule& rule : rules->rules) {
    rule.start = rule.parameters.empty() && rule.symbol == source.settings.start;
  }
  return rules;
}

std::string TextOf(const grammar::LayerEdits& layers) { return Dumped(LayersJson(layers)); }

Result<grammar::LayerEdits> LayerEditsFrom(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  if (!json->is_object()) return Fail(ErrorCode::kBadText, "layers are an object: {}");
  for (const auto& [key, value] : json->items()) {
    if (key == "off" || key == "rules" || key == "order") continue;
    return Fail(ErrorCode::kBadText, fmt::format("layers have no '{}'", key),
                "they have off, rules and order");
  }
  try {
    return LayersFrom(*json);
  } catch (const Json::exception& error) {
    return Fail(ErrorCode::kBadText, fmt::format("the layers can't be read: {}", error.what()));
  }
}

std::string TextOf(const RuleSource& source) {
  Json json = Json::object();
  for (const RuleFile& file : source.files) {
    json["files"].push_back({{"name", file.name}, {"text", file.text}});
  }
  if (!source.style.empty()) json["style"] = source.style;
  if (source.skip_unknown) json["skip_unknown"] = true;
  if (source.layers != grammar::LayerEdits()) json["layers"] = LayersJson(source.layers);
  const grammar::RuleSettings& settings = source.settings;
  if (!settings.start.empty()) json["start"] = settings.start;
  if (settings.seed != 0) json["seed"] = settings.seed;
  if (!settings.attributes.empty()) json["attributes"] = PairsJson(settings.attributes);
  if (settings.limits != grammar::RuleLimits()) json["limits"] = LimitsJson(settings.limits);
  return Dumped(json);
}

Result<RuleSource> RuleSourceFrom(std::string_view text) {
  const auto json = ParseJson(text);
  if (!json) return Fail(json);
  try {
    return SourceFrom(*json);
  } catch (const Json::exception& error) {
    return Fail(ErrorCode::kBadText, fmt::format("the rules can't be read: {}", error.what()));
  }
}

}  // namespace parti::app
