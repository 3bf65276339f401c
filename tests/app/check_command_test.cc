// `parti check` as a person runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::ProgramRun;
using tests::RunParti;

/// A file with this text, in a folder of the test's own.
std::string File(std::string_view text) {
  std::string path = tests::TestFolder() + "/house.cga";
  EXPECT_TRUE(WriteFile(path, text));
  return path;
}

TEST(CheckCommand, SaysWhatRulesHold) {
  const ProgramRun run = RunParti({"check", File("attr h = 3\nLot --> extrude(h) Mass\n")});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "");
  EXPECT_THAT(run.output, EndsWith("house.cga: 1 rule, 1 attribute, 0 trees\n"));
}

TEST(CheckCommand, TellsAllErrorsWithTheirPlaces) {
  const ProgramRun run = RunParti({"check", File("Lot --> extrud(3)\nA --> comp(f) { sid: B }\n")});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, AllOf(HasSubstr("house.cga:1:9: error: there is no operation 'extrud'"),
                                HasSubstr("did you mean 'extrude'?"),
                                HasSubstr("house.cga:2:17: error: comp has no selector 'sid'")));
}

TEST(CheckCommand, WhatIsSurelyNotMeantIsANoteAndNoFailure) {
  const ProgramRun run = RunParti({"check", File("Lot --> [ B ] color(\"blue\")\n")});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.errors,
              AllOf(HasSubstr("house.cga:1:15: note: color acts on a shape that nothing keeps\n"),
                    HasSubstr("^~~~~  hint: put it before")));
  EXPECT_THAT(run.output, EndsWith("house.cga: 1 rule, 0 attributes, 0 trees\n"));
}

TEST(CheckCommand, OurOwnRulesGiveNoNotes) {
  for (const char* folder : {"docs/operations", "tests/listings"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(tests::SourceFile(folder))) {
      if (entry.path().extension() != ".cga") continue;
      EXPECT_THAT(RunParti({"check", entry.path().string()}).errors, Not(HasSubstr("note:")))
          << entry.path();
    }
  }
}

TEST(CheckCommand, FollowsImportsBesideTheFileAndAboveIt) {
  const std::string house = File("import r : \"roof.cga\"\nLot --> r.Roof\n");
  const std::string folder = house.substr(0, house.rfind('/'));
  ASSERT_TRUE(WriteFile(folder + "/roof.cga", "Roof --> extrude(1)\n"));
  EXPECT_EQ(RunParti({"check", house}).status, 0);
  const ProgramRun run = RunParti({"check", File("import r : \"ruf.cga\"\nLot --> r.Roof\n")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("house.cga:1:12: error: there is no file 'ruf.cga'"));
}

TEST(CheckCommand, ReadsStandardInput) {
  EXPECT_EQ(RunParti({"check", "-"}, "Lot --> extrude(3)").status, 0);
}

TEST(CheckCommand, WhatIsUnknownIsSkippedWhenAsked) {
  const std::string house = File("Lot --> envelope(3) extrude(3)\n");
  EXPECT_EQ(RunParti({"check", house}).status, 1);
  const ProgramRun run = RunParti({"check", house, "--skip-unknown"});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "parti: skipped operation 'envelope'\n");
}

TEST(CheckCommand, NothingToCheckIsAnError) {
  EXPECT_EQ(RunParti({"check", File("// nothing\n")}).status, 1);
  EXPECT_EQ(RunParti({"check", tests::TestFolder() + "/none.cga"}).status, 1);
  EXPECT_EQ(RunParti({"check"}).status, 2);
  EXPECT_EQ(RunParti({"check", File("Lot --> extrude(3)"), "--start", "Lott"}).status, 1);
}

}  // namespace
}  // namespace parti::app
