// The files that rules import, looked for on disk.
// What an import means is grammar/rules/rule_modules.h's.
#pragma once

#include "grammar/rules/rule_text.h"

namespace parti::app {

/// Looks for `import p : "path"` beside the importing file, then in the folders above it, up to
/// four: CityEngine's projects name files from their own folders on. What is read from standard
/// input imports from the working folder. errors  kFile  it is in none of them, or can't be read.
grammar::RuleImporter FileImporter();

}  // namespace parti::app
