// Properties of a file's lots as values of the rules' attributes that are called the same
// (docs/lots.md), as CityEngine takes them from objects. Reading files is footprint.h's.
#pragma once

#include <vector>

#include "app/lot.h"
#include "base/error.h"
#include "base/json.h"
#include "grammar/rules/rule_settings.h"

namespace parti::app {

/// The members of an object, by name: numbers, truths and texts, and what else there is as nothing.
/// What is null is left out. Of no object: none.
LotProperties PropertiesIn(const Json& object);

/// An object whose PropertiesIn are these.
Json JsonOf(const LotProperties& properties);

/// What a lot gives the rules' attributes; texts are numbers and truths where they read as such.
/// Properties without an attribute, constants, and attributes that the settings give a value of
/// their own are passed over.
/// errors  kBadArguments  a value of another type, or none of @Enum;  kBadNumber  outside @Range;
///         both name the lot and the property.
Result<std::vector<grammar::GivenValue>> ValuesOf(const Lot& lot, const grammar::RuleSet& rules,
                                                  const grammar::RuleSettings& settings);

}  // namespace parti::app
