#include "app/lot_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "grammar/lexer.h"
#include "grammar/rules/conversions.h"

namespace parti::app {
namespace {

using grammar::Attribute;
using grammar::GivenValue;
using grammar::RuleSet;
using grammar::Value;

std::optional<Value> ValueIn(const Json& json) {
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number()) return json.get<double>();
  if (json.is_string()) return json.get<std::string>();
  return std::nullopt;
}

/// As a file writes it: texts in quotes.
std::string Written(const std::optional<Value>& value) {
  if (!value) return "a list or an object";
  const auto* text = std::get_if<std::string>(&*value);
  return text != nullptr ? grammar::QuotedText(*text) : grammar::TextOf(*value);
}

/// Null where the lot has none of that name.
const LotProperty* PropertyNamed(const LotProperties& properties, const std::string& name) {
  const auto found = std::lower_bound(properties.begin(), properties.end(), name,
                                      [](const LotProperty& property, const std::string& sought) {
                                        return property.name < sought;
                                      });
  return found != properties.end() && found->name == name ? &*found : nullptr;
}

bool IsGiven(const grammar::RuleSettings& settings, const std::string& name) {
  return std::any_of(settings.attributes.begin(), settings.attributes.end(),
                     [&](const auto& given) { return given.first == name; });
}

/// What the attribute takes of it. Texts are read as `--set` reads them: many files, such as those
/// of OpenStreetMap, write their numbers in quotes.
Result<Value> Taken(const LotProperty& property, const Attribute& attribute, const RuleSet& rules) {
  const grammar::ValueType type = attribute.value.type;
  std::optional<Value> value = property.value;
  const auto* text = value ? std::get_if<std::string>(&*value) : nullptr;
  if (text != nullptr) {
    if (auto read = grammar::AttributeValue(rules, attribute.name, *text)) value = read->value;
  }
  if (!value || grammar::TypeOf(*value) != type) {
    return Fail(ErrorCode::kBadArguments,
                fmt::format("property '{}' is {}, not a {}", property.name, Written(property.value),
                            NameOf(type)),
                fmt::format("mend the file, or give all lots one: --set {}=…", property.name));
  }
  if (auto allowed = grammar::CheckAllowed(attribute, *value); !allowed) {
    Error error = allowed.error();
    error.message = fmt::format("property '{}': {}", property.name, error.message);
    return tl::unexpected<Error>(std::move(error));
  }
  return *value;
}

}  // namespace

LotProperties PropertiesIn(const Json& object) {
  LotProperties properties;
  if (!object.is_object()) return properties;
  for (const auto& [name, json] : object.items()) {
    if (!json.is_null()) properties.push_back({name, ValueIn(json)});
  }
  return properties;
}

Json JsonOf(const LotProperties& properties) {
  Json object = Json::object();
  for (const auto& [name, value] : properties) {
    Json& json = object[name] = Json::array();
    if (value) std::visit([&json](const auto& plain) { json = plain; }, *value);
  }
  return object;
}

Result<std::vector<GivenValue>> ValuesOf(const Lot& lot, const RuleSet& rules,
                                         const grammar::RuleSettings& settings) {
  std::vector<GivenValue> values;
  if (lot.properties.empty()) return values;
  for (size_t i = 0; i < rules.attributes.size(); ++i) {
    const Attribute& attribute = rules.attributes[i];
    const LotProperty* property = PropertyNamed(lot.properties, attribute.name);
    if (property == nullptr || attribute.constant || IsGiven(settings, attribute.name)) continue;
    auto value = Taken(*property, attribute, rules);
    if (!value) {
      Error error = value.error();
      error.message = fmt::format("lot '{}': {}", lot.name, error.message);
      return tl::unexpected<Error>(std::move(error));
    }
    values.push_back({i, std::move(*value)});
  }
  return values;
}

}  // namespace parti::app
