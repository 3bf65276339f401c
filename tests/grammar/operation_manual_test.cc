// docs/operations.md is what the table says. PARTI_UPDATE_GOLDEN=1 writes it anew.
#include "grammar/operation_manual.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/text_file.h"
#include "grammar/operation.h"
#include "tests/support/data.h"

namespace parti::grammar::tests {
namespace {

std::string Example(std::string_view name) {
  const std::string path =
      parti::tests::SourceFile("docs/operations/" + std::string(name) + ".cga");
  const Result<std::string> text = ReadFile(path);
  EXPECT_TRUE(text.has_value()) << name << " has no example: write " << path;
  return text.value_or("");
}

TEST(OperationsManual, IsUpToDate) {
  const std::string path = parti::tests::SourceFile("docs/operations.md");
  const std::string manual = OperationsManual(Example);
  if (std::getenv("PARTI_UPDATE_GOLDEN") != nullptr) {
    ASSERT_TRUE(WriteFile(path, manual).has_value());
  }
  EXPECT_EQ(ReadFile(path).value_or(""), manual)
      << "run this test with PARTI_UPDATE_GOLDEN=1 to write docs/operations.md anew";
}

TEST(OperationsManual, NamesEveryRowParameterAndSelector) {
  const std::string manual = OperationsManual(Example);
  for (const Operation& row : Operations()) {
    EXPECT_NE(manual.find("## " + std::string(row.name) + "\n"), std::string::npos);
    EXPECT_NE(manual.find(Example(row.name) + "```\n"), std::string::npos) << row.name;
    for (const Parameter& p : row.parameters) {
      EXPECT_NE(manual.find("| " + std::string(p.name) + " |"), std::string::npos) << p.name;
    }
  }
  EXPECT_NE(manual.find("`split(axis) { size: Symbol | … }*`"), std::string::npos);
}

}  // namespace
}  // namespace parti::grammar::tests
