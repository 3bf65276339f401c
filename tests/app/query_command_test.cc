// `parti query` as a person runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using tests::ProgramRun;
using tests::RunParti;

constexpr std::string_view kHouse = R"(tree house {
  .Lot --> extrude(9) Mass
  .Mass --> comp(f) { side: Facade | top: Roof }
  .Facade --> split(y) { ~3: tag("storey") Floor }*
}
)";

/// A file with this text, in a folder of the test's own.
std::string File(std::string_view text) {
  std::string path = tests::TestFolder() + "/house.cga";
  EXPECT_TRUE(WriteFile(path, text));
  return path;
}

TEST(QueryCommand, PrintsIds) {
  const ProgramRun run = RunParti({"query", File(kHouse), ".Facade:first / .Floor"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.output, "0/1/0\n0/1/1\n0/1/2\n");
  EXPECT_EQ(run.errors, "");
}

TEST(QueryCommand, PrintsJson) {
  const ProgramRun run =
      RunParti({"query", File(kHouse), ".Facade:first > .Floor:first", "--json"});
  EXPECT_EQ(run.status, 0);
  const auto json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json.size(), 2u);
  EXPECT_TRUE(json.at("ms").is_number());
  EXPECT_EQ(json.at("shapes"),
            nlohmann::json::parse(R"([{"id":"0/1/0","symbol":"Floor","tags":["storey"],
                                       "operation":"Repeat","leaf":true}])"));
}

TEST(QueryCommand, TheLotIsAShapeThatNoOperationMade) {
  const ProgramRun run = RunParti({"query", File("tree t { }"), ".Lot", "--json"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(
      nlohmann::json::parse(run.output).at("shapes"),
      nlohmann::json::parse(R"([{"id":".","symbol":"Lot","tags":[],"operation":"","leaf":true}])"));
}

TEST(QueryCommand, WhatIsNamedAsDocumentsAreIsNotReadAsText) {
  const std::string path = tests::TestFolder() + "/house.parti";
  ASSERT_TRUE(WriteFile(path, ""));
  EXPECT_THAT(RunParti({"query", path, ".Lot"}).errors, HasSubstr("house.parti is empty"));
  ASSERT_TRUE(WriteFile(path, kHouse));
  EXPECT_THAT(RunParti({"query", path, ".Lot"}).errors, HasSubstr("no Parti document"));
}

TEST(QueryCommand, RunsOnTheGivenLots) {
  const std::string house = File(kHouse);
  EXPECT_EQ(RunParti({"query", house, ".Floor", "--lot", "poly(0,0 9,0 9,9)"}).output,
            "0/1/0\n0/1/1\n0/1/2\n0/2/0\n0/2/1\n0/2/2\n0/3/0\n0/3/1\n0/3/2\n");
  const std::string lots = tests::TestFolder() + "/lots.jsonl";
  ASSERT_TRUE(WriteFile(lots,
                        "{\"id\":\"a\",\"rings\":[[[0,0],[9,0],[9,9],[0,9]]]}\n"
                        "{\"id\":\"b\",\"rings\":[[[20,0],[29,0],[29,9],[20,9]]]}\n"));
  EXPECT_EQ(RunParti({"query", house, ".Roof", "--lot", lots}).output, "lot-0:0/0\nlot-1:0/0\n");
}

TEST(QueryCommand, AnUnknownFilterIsShownInItsPlace) {
  const ProgramRun run = RunParti({"query", File(kHouse), ".Floor:evn"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_EQ(run.errors,
            "QUERY:1:8: error: there is no filter 'evn'\n"
            "    1 | .Floor:evn\n"
            "      |        ^~~  hint: did you mean 'even'?\n");
}

TEST(QueryCommand, AnEmptySelectionFailsButIsValidJson) {
  const ProgramRun run = RunParti({"query", File(kHouse), ".Window", "--json"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(nlohmann::json::parse(run.output).at("shapes").size(), 0u);
  EXPECT_THAT(run.errors, HasSubstr("parti: error: '.Window' selects no shape"));
}

TEST(QueryCommand, ShowsAllErrorsOfTheFile) {
  const std::string path = File("tree t {\n  .Lot --> extrud(9)\n  .A --> splt(y) { 1: B }\n}\n");
  const ProgramRun run = RunParti({"query", path, "*"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr(path + ":2:12: error: there is no operation 'extrud'"));
  EXPECT_THAT(run.errors, HasSubstr(path + ":3:10: error: there is no operation 'splt'"));
}

TEST(QueryCommand, SaysWhatIsWrongWithFilesLotsAndUse) {
  EXPECT_THAT(RunParti({"query", "no/such.cga", "*"}).errors, HasSubstr("no/such.cga"));
  const std::string house = File(kHouse);
  const ProgramRun zero = RunParti({"query", house, "*", "--lot", "rect(0,5)"});
  EXPECT_EQ(zero.status, 1);
  EXPECT_THAT(zero.errors, HasSubstr("a lot without area"));
  const ProgramRun crossing = RunParti({"query", house, "*", "--lot", "poly(0,0 9,9 9,0 0,9)"});
  EXPECT_EQ(crossing.status, 1);
  EXPECT_THAT(crossing.errors, HasSubstr("cross"));
  EXPECT_EQ(RunParti({"query", house}).status, 2);
  EXPECT_THAT(RunParti({"query", "--help"}).output, HasSubstr("Example:"));
}

}  // namespace
}  // namespace parti::app
