#include <gmock/gmock.h>

#include "base/text_file.h"
#include "grammar/query_filter.h"
#include "tests/support/data.h"

namespace parti::grammar {
namespace {

using ::testing::HasSubstr;

TEST(LanguageDocument, DescribesEveryFilterInTheTablesWords) {
  const std::string text = ReadFile(tests::SourceFile("docs/language.md")).value();
  for (const FilterRow& row : Filters()) {
    EXPECT_THAT(text, HasSubstr("| `" + std::string(row.name) + "` | " + std::string(row.doc)));
  }
}

}  // namespace
}  // namespace parti::grammar
