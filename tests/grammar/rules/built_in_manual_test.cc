// docs/functions.md is what the table says. PARTI_UPDATE_GOLDEN=1 writes it anew.
#include "grammar/rules/built_in_manual.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/text_file.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

TEST(FunctionsManual, IsUpToDate) {
  const std::string path = parti::tests::SourceFile("docs/functions.md");
  const std::string manual = FunctionsManual();
  if (std::getenv("PARTI_UPDATE_GOLDEN") != nullptr) {
    ASSERT_TRUE(WriteFile(path, manual).has_value());
  }
  EXPECT_EQ(ReadFile(path).value_or(""), manual)
      << "run this test with PARTI_UPDATE_GOLDEN=1 to write docs/functions.md anew";
}

TEST(FunctionsManual, WritesOperandsAndNames) {
  const std::string manual = FunctionsManual();
  EXPECT_NE(manual.find("| `atan2(number, number)` | number |"), std::string::npos);
  EXPECT_NE(manual.find("| `scope.sx` | number |"), std::string::npos);
  EXPECT_NE(manual.find("| `rand()` | number |"), std::string::npos);
}

}  // namespace
}  // namespace parti::grammar::tests
