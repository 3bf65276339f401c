// Rule files from any bytes: read, written, read back as the same value, in every style.
#include <cstdint>

#include "base/check.h"
#include "grammar/rules/rule_text.h"

namespace parti::grammar {
namespace {

RuleOptions Options(bool skip_unknown) {
  RuleOptions options;
  options.skip_unknown = skip_unknown;
  options.importer = [](const std::string& path, const std::string&) -> Result<RuleFile> {
    if (path == "a.cga") return RuleFile{path, "attr h = 3\nf(x) = x * h\nA(x) --> extrude(f(x))"};
    if (path == "b.cga") return RuleFile{path, "import a : \"a.cga\"\nB --> a.A(1)\nstyle S\n"};
    return Fail(ErrorCode::kFile, "there is no such file");
  };
  return options;
}

void ReadBack(const RuleSet& rules, const RuleOptions& options) {
  const auto again = ParseRules(TextOf(rules), "again.cga", options);
  CHECK(again.has_value() && *again == rules, "rules read back");
}

void Try(std::string_view text) {
  const auto strict = ParseRules(text, "fuzz.cga", Options(false));
  if (!strict) {
    CHECK(!strict.error().empty(), "a failure has an error");
    for (const Error& error : strict.error()) {
      CHECK(error.place.has_value(), "an error in a text has a place");
      (void)FormatError(error);
    }
  } else {
    ReadBack(*strict, Options(false));
    for (const RuleStyle& style : strict->styles) {
      RuleOptions options = Options(false);
      options.style = style.name;
      const auto styled = ParseRules(text, "fuzz.cga", options);
      CHECK(styled.has_value(), "styles were checked");
    }
  }
  const auto lenient = ParseRules(text, "fuzz.cga", Options(true));
  if (lenient) ReadBack(*lenient, Options(true));
}

}  // namespace
}  // namespace parti::grammar

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  parti::grammar::Try({reinterpret_cast<const char*>(data), size});
  return 0;
}
