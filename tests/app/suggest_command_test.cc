// `parti suggest --batch` as a person runs it, and the JSON that it reads and writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "app/sketch_task.h"
#include "base/json.h"
#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using parti::tests::ProgramRun;
using parti::tests::RunParti;
using testing::HasSubstr;

// A task of the fuzz corpus, which a person could have drawn.
std::string TaskNamed(const std::string& name) {
  const auto text = ReadFile(tests::SourceFile("tests/fuzz/corpus/tasks/" + name));
  EXPECT_TRUE(text.has_value()) << name;
  return text.value_or("");
}

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

TEST(SuggestCommand, AnswersEveryKindAsTheTasksWantIt) {
  const ProgramRun run = RunParti({"suggest", "--batch", "-"},
                                  TaskNamed("extrude") + TaskNamed("split") + TaskNamed("comp"));
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto answers = Answers(run);
  ASSERT_EQ(answers.size(), 3u);
  const Json extrude = answers[0]["suggestions"][0], split = answers[1]["suggestions"][0];
  EXPECT_EQ(answers[0]["id"], "e");
  EXPECT_GE(answers[0]["ms"].get<double>(), 0);
  EXPECT_EQ(extrude["op"], "extrude");
  EXPECT_NEAR(extrude["params"]["distance"].get<double>(), 8, 0.1);
  EXPECT_EQ(split["op"], "split");
  EXPECT_EQ(split["params"]["axis"], "y");
  EXPECT_NEAR(split["params"]["sizes"][0].get<double>(), 3, 0.1);
  EXPECT_NEAR(split["params"]["sizes"][1].get<double>(), 6, 0.1);
  EXPECT_EQ(answers[2]["suggestions"][0]["op"], "comp");
}

TEST(SuggestCommand, TruthIsNotLookedAt) {
  std::string other = TaskNamed("extrude");
  other.replace(other.find("nothing"), 7, "offset!");
  const auto with = Answers(RunParti({"suggest", "--batch", "-"}, TaskNamed("extrude")));
  const auto without = Answers(RunParti({"suggest", "--batch", "-"}, other));
  ASSERT_EQ(with.size(), 1u);
  ASSERT_EQ(without.size(), 1u);
  EXPECT_EQ(with[0]["suggestions"], without[0]["suggestions"]);
}

TEST(SuggestCommand, BadLinesAreAnsweredInPlaceAndTheExitStatusTells) {
  const ProgramRun run =
      RunParti({"suggest", "--batch", "-"},
               TaskNamed("tap") + TaskNamed("no_strokes") + TaskNamed("flat_box") +
                   TaskNamed("eye_on_target") + TaskNamed("crossing") + TaskNamed("bad_vector") +
                   TaskNamed("not_finite") + "\n{\"id\":8}\noops\n" + TaskNamed("extrude"));
  EXPECT_EQ(run.status, 1);
  const auto answers = Answers(run);
  ASSERT_EQ(answers.size(), 10u);
  const auto error = [&](size_t i) { return answers[i].value("error", std::string()); };
  EXPECT_THAT(error(0), HasSubstr("fewer than 2 distinct positions"));
  EXPECT_THAT(error(1), HasSubstr("no strokes"));
  EXPECT_FALSE(error(2).empty());
  EXPECT_THAT(error(3), HasSubstr("eye lies on its target"));
  EXPECT_FALSE(error(4).empty());
  EXPECT_THAT(error(5), HasSubstr("shape.polygon[0]"));
  EXPECT_THAT(error(6), HasSubstr("out of range"));
  EXPECT_THAT(error(7), HasSubstr("shape is missing"));
  EXPECT_THAT(error(8), HasSubstr("not JSON"));
  EXPECT_EQ(answers[9]["suggestions"][0]["op"], "extrude");
}

TEST(SuggestCommand, HelpHasAnExampleAndWrongUseExitsWith2) {
  const ProgramRun help = RunParti({"suggest", "--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_THAT(help.output, HasSubstr("parti suggest --batch"));
  EXPECT_EQ(RunParti({"suggest"}).status, 2);
  EXPECT_EQ(RunParti({"suggest", "--batch", "no/such/file"}).status, 1);
}

Result<SketchTask> TaskFrom(const std::string& text) { return SketchTaskFrom(*ParseJson(text)); }

TEST(SketchTask, TheFaceOfATaskHasTheScopeThatTasksSpeakOf) {
  const auto task = TaskFrom(TaskNamed("split"));
  ASSERT_TRUE(task);
  EXPECT_EQ(task->item.scope.size, Vec3(16, 9, 0));
  EXPECT_LT(glm::distance(task->item.scope.origin, Vec3(-8, 0, 0)), 1e-9);
  EXPECT_LT(glm::distance(task->item.scope.y, Vec3(0, 1, 0)), 1e-9);
}

TEST(SketchTask, ALeftHandedOrSkewedBoxIsRefused) {
  std::string text = TaskNamed("comp");
  const std::string z = "\"z\":[0,0,1]";
  ASSERT_NE(text.find(z), std::string::npos);
  std::string mirrored = text, skewed = text;
  mirrored.replace(text.find(z), z.size(), "\"z\":[0,0,-1]");
  skewed.replace(text.find(z), z.size(), "\"z\":[0,1,1]");
  EXPECT_EQ(TaskFrom(mirrored).error().code, ErrorCode::kBadNumber);
  EXPECT_EQ(TaskFrom(skewed).error().code, ErrorCode::kBadNumber);
}

TEST(SketchTask, MissingPartsAreNamed) {
  for (const char* part : {"shape", "camera", "strokes"}) {
    Json task = *ParseJson(TaskNamed("extrude"));
    task.erase(part);
    const auto result = SketchTaskFrom(task);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::kBadText);
    EXPECT_THAT(result.error().message, HasSubstr(part));
  }
}

}  // namespace
}  // namespace parti::app
