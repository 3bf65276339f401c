// `parti segment` as a person runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/json.h"
#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using parti::tests::ProgramRun;
using parti::tests::RunParti;
using testing::HasSubstr;

constexpr const char* kCorner = R"({"id":"L","class":"ignored","points":[[0,0,0],[50,1,60],)"
                                R"([99,0,120],[99,40,190],[100,80,250]]})";

std::vector<Json> Answers(const ProgramRun& run) {
  std::vector<Json> answers;
  std::istringstream lines(run.output);
  for (std::string line; std::getline(lines, line);) {
    const auto json = ParseJson(line);
    EXPECT_TRUE(json.has_value()) << line;
    if (json) answers.push_back(*json);
  }
  return answers;
}

TEST(SegmentCommand, AnswersCornersAndSegments) {
  const ProgramRun run = RunParti({"segment", "-"}, kCorner);
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output,
            "{\"id\":\"L\",\"corners\":[0,2,4],\"segments\":[{\"from\":0,\"to\":2,\"kind\":"
            "\"line\"},{\"from\":2,\"to\":4,\"kind\":\"line\"}]}\n");
  EXPECT_EQ(run.errors, "");
}

TEST(SegmentCommand, ReadsAFileAndPressure) {
  const std::string path = parti::tests::TestFolder() + "/strokes.jsonl";
  ASSERT_TRUE(WriteFile(path, R"({"id":1,"points":[[0,0,0,0.2],[9,0,10,0.9],[20,0,20,0.1]]})"));
  const ProgramRun run = RunParti({"segment", path});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("\"corners\":[0,2]"));
}

TEST(SegmentCommand, BadLinesAreAnsweredInPlaceAndTheExitStatusTells) {
  const ProgramRun run =
      RunParti({"segment", "-"}, std::string(kCorner) +
                                     "\n{\"id\":2,\"points\":[[3,3,0]]}\n"
                                     "{\"id\":3}\n"
                                     "{\"id\":4,\"points\":[[0,0,0],[1,null]]}\n"
                                     "{\"id\":5,\"points\":[[0,0,0],[1,1e9999,2]]}\n"
                                     "{\"id\":6,\"points\":[[0,0,0],[1,1e300,2]]}\n"
                                     "{\"id\":7,\"points\":[]}\n"
                                     "oops\n" +
                                     kCorner);
  EXPECT_EQ(run.status, 1);
  const auto answers = Answers(run);
  ASSERT_EQ(answers.size(), 9u);
  EXPECT_THAT(answers[1].value("error", ""), HasSubstr("fewer than 2 distinct positions"));
  EXPECT_THAT(answers[2].value("error", ""), HasSubstr("\"points\" is missing"));
  EXPECT_THAT(answers[3].value("error", ""), HasSubstr("points[1]"));
  EXPECT_THAT(answers[4].value("error", ""), HasSubstr("out of range"));
  EXPECT_THAT(answers[5].value("error", ""), HasSubstr("not a finite number"));
  EXPECT_THAT(answers[6].value("error", ""), HasSubstr("no points"));
  EXPECT_THAT(answers[7].value("error", ""), HasSubstr("line 8, column 1"));
  EXPECT_EQ(answers[8], answers[0]);
  EXPECT_THAT(run.errors, HasSubstr("7 of 9 lines"));
}

TEST(SegmentCommand, WrongUsageAndMissingFilesAreTold) {
  EXPECT_EQ(RunParti({"segment"}).status, 2);
  EXPECT_EQ(RunParti({"segment", "--nonsense", "-"}).status, 2);
  const ProgramRun missing = RunParti({"segment", "/nowhere/strokes.jsonl"});
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.errors, HasSubstr("can't read /nowhere/strokes.jsonl"));
  EXPECT_EQ(RunParti({"segment", "-"}, "\n").status, 1) << "nothing asked, nothing made";
}

TEST(SegmentCommand, HelpHasAnExample) {
  const ProgramRun run = RunParti({"segment", "--help"});
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.output, HasSubstr("Example:"));
}

}  // namespace
}  // namespace parti::app
