// What a person sees when something is wrong: exit status, the place and the remedy, for every way
// in. The parts' own tests go deeper; this is the program as it is called.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class ErrorsTest : public ::testing::Test {
 protected:
  ErrorsTest() : folder_(TestFolder()) {}

  std::string Written(const std::string& name, const std::string& text) {
    const std::string path = folder_ + "/" + name;
    EXPECT_TRUE(WriteFile(path, text));
    return path;
  }

  std::string folder_;
};

TEST_F(ErrorsTest, WrongUsageExitsWith2) {
  EXPECT_EQ(RunParti({"--display"}).status, 2);
  EXPECT_EQ(RunParti({"repaly"}).status, 2);
  EXPECT_EQ(RunParti({"replay"}).status, 2);
  EXPECT_EQ(RunParti({"export", "a.parti"}).status, 2);
}

TEST_F(ErrorsTest, WrongUsageSaysWhatIsWrongAndWhereHelpIs) {
  EXPECT_EQ(RunParti({"export", "a.parti"}).errors,
            "parti: error: OUT is required\n  hint: parti export --help shows what it takes\n");
  EXPECT_THAT(RunParti({"derive", "a.cga", "--sed", "3"}).errors,
              AllOf(StartsWith("parti: error: "), HasSubstr("--sed"),
                    HasSubstr("hint: parti derive --help")));
  const ProgramRun misspelt = RunParti({"deriv", "a.cga", "--start", "Lot"});
  EXPECT_EQ(misspelt.status, 2);
  EXPECT_EQ(misspelt.errors,
            "parti: error: there is no command and no file 'deriv'\n"
            "  hint: did you mean 'derive'?\n");
  const ProgramRun surplus = RunParti({"new.parti", "other.parti"});
  EXPECT_EQ(surplus.status, 2);
  EXPECT_THAT(surplus.errors, StartsWith("parti: error: 'other.parti' is not expected here"));
  EXPECT_THAT(RunParti({"--display", "none", "--", "new.parti"}).errors,
              HasSubstr("no display called"))
      << "what follows -- is a file";
}

TEST_F(ErrorsTest, ANameThatIsTooLongForAFileIsOneThatIsNotThere) {
  const ProgramRun run = RunParti({std::string(10000, 'x')});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.errors, StartsWith("parti: error: there is no command and no file 'xxx"));
}

TEST_F(ErrorsTest, AnswersThatCannotBeWrittenAreAFailure) {
  const std::string rules = Written("a.cga", "Lot --> split(x) { { ~0.001: A }* }");
  const std::vector<std::vector<std::string>> commands = {
      {"query", rules, "*"},  // more than fits into a buffer
      {"query", rules, "*", "--json"},
      {"check", rules},
      {"derive", rules, "--stats"}};
  for (const auto& command : commands) {
    const ProgramRun run = RunParti(command, "", "/dev/full");
    EXPECT_EQ(run.status, 1) << command.front();
    EXPECT_THAT(run.errors, StartsWith("parti: error: can't write to standard output: No space"))
        << command.front();
  }
}

TEST_F(ErrorsTest, EveryCommandHasHelpWithAnExample) {
  for (const char* command :
       {"replay", "devices", "record", "segment", "suggest", "query", "render", "export"}) {
    const ProgramRun run = RunParti({command, "--help"});
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_THAT(run.output, HasSubstr("Example")) << command;
  }
}

TEST_F(ErrorsTest, AFileThatIsNotThereIsNamed) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"replay", "missing.pen"},
        {"segment", "missing.jsonl"},
        {"suggest", "--batch", "missing.jsonl"},
        {"query", "missing.parti", ".Floor"},
        {"render", "missing.parti", "--png", folder_ + "/x.png"},
        {"export", "missing.parti", folder_ + "/x.glb"}}) {
    const ProgramRun run = RunParti(arguments);
    EXPECT_EQ(run.status, 1) << arguments[0];
    EXPECT_THAT(run.errors, AllOf(StartsWith("parti: error:"), HasSubstr("missing")))
        << arguments[0];
  }
}

TEST_F(ErrorsTest, AFolderIsNotAFile) {
  const ProgramRun run = RunParti({"replay", folder_});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("is a folder"));
}

TEST_F(ErrorsTest, ATruncatedDrawingIsPlayedUpToItsEndAndThenRefused) {
  const std::string whole = *ReadFile(SourceFile("assets/drawings/house.pen"));
  const std::string half = Written("half.pen", whole.substr(0, whole.size() / 2));
  const std::string png = folder_ + "/half.png";
  const ProgramRun run = RunParti({"replay", half, "--png", png, "--json"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("half.pen:"));
  EXPECT_THAT(run.output, HasSubstr("\"chosen\":\"extrude("));
  EXPECT_TRUE(ReadFile(png)) << "what was drawn before the damage is still a picture";
}

TEST_F(ErrorsTest, ADamagedDrawingSaysWhere) {
  std::string text = *ReadFile(SourceFile("assets/drawings/house.pen"));
  const size_t line = text.find("\npen 0 down", text.size() / 2) + 1;
  text.replace(line, 10, "pen 0 dwon");
  const ProgramRun run = RunParti({"replay", Written("damaged.pen", text)});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("damaged.pen:"), HasSubstr("error:"), HasSubstr("^")));
}

TEST_F(ErrorsTest, AnUnknownCommandInADrawingSaysWhereAndWhatWasMeant) {
  const ProgramRun run =
      RunParti({"replay", Written("a.pen", "parti-drawing 1\nafter 0: lto rect(3,3)\nend\n")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("a.pen:2:"), HasSubstr("did you mean 'lot'")));
}

TEST_F(ErrorsTest, ADrawingWithoutALotBuildsNothing) {
  const ProgramRun run = RunParti({"replay", Written("a.pen", "parti-drawing 1\nend\n")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("builds nothing"));
}

TEST_F(ErrorsTest, LotsThatAreNoneAreRefused) {
  const std::string rules = Written("r.cga", "tree t { .Lot --> extrude(3) Mass }\n");
  const auto run = [&](const std::string& lot) {
    return RunParti({"query", rules, ".Mass", "--lot", lot});
  };
  EXPECT_EQ(run("rect(20,14)").status, 0);
  for (const char* lot : {"rect(0,14)", "rect(20,-1)", "poly(0,0 1,0)", "poly(0,0 5,0 10,0)"}) {
    EXPECT_EQ(run(lot).status, 1) << lot;
    EXPECT_THAT(run(lot).errors, HasSubstr("error:")) << lot;
  }
  const ProgramRun bow_tie = run("poly(0,0 10,10 10,0 0,10)");
  EXPECT_EQ(bow_tie.status, 1);
  EXPECT_THAT(bow_tie.errors, HasSubstr("cross"));
}

TEST_F(ErrorsTest, AnUnknownQueryPointsAtTheWordAndNamesTheOneMeant) {
  const std::string rules = Written("r.cga", "tree t { .Lot --> extrude(3) Mass }\n");
  const ProgramRun run = RunParti({"query", rules, ".Mass:nroth", "--lot", "rect(20,14)"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("^"), HasSubstr("north")));
}

TEST_F(ErrorsTest, NumbersThatAreNotFiniteCostOneLineOfABatch) {
  const std::string good = R"({"id":"a","points":[[0,0,0],[50,0,100],[100,0,200]]})";
  const std::string bad = R"({"id":"b","points":[[0,0,0],[1e999,0,100]]})";
  const ProgramRun run = RunParti({"segment", "-"}, good + "\n" + bad + "\n" + good + "\n");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, AllOf(HasSubstr(R"("id":"a")"), HasSubstr(R"("error":)")));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 3);
}

TEST_F(ErrorsTest, AStrokeOfOnePointIsAnErrorOnItsLine) {
  const ProgramRun run = RunParti({"segment", "-"}, R"({"id":"dot","points":[[3,4,0]]})"
                                                    "\n");
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.output, AllOf(HasSubstr("dot"), HasSubstr("error")));
}

TEST_F(ErrorsTest, ADeviceThatIsNotThereSaysWhatToDo) {
  const ProgramRun run = RunParti(
      {"record", folder_ + "/x.pen", "--device", "/dev/input/event9999", "--seconds", "1"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, AllOf(HasSubstr("event9999"), HasSubstr("hint:")));
}

TEST_F(ErrorsTest, FormatsThatAreNotThereAreNamedWithThoseThatAre) {
  const std::string rules = Written("r.cga", "tree t { .Lot --> extrude(3) Mass }\n");
  const ProgramRun run = RunParti({"export", rules, folder_ + "/x.fbx", "--lot", "rect(9,9)"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, AllOf(HasSubstr(".fbx"), HasSubstr(".glb")));
}

TEST_F(ErrorsTest, OutputsThatCannotBeWrittenAreSaid) {
  const std::string house = SourceFile("assets/drawings/house.pen");
  for (const char* option : {"--png", "--export", "--save"}) {
    const std::string path = folder_ + "/nowhere/x" +
                             (option == std::string("--png")      ? ".png"
                              : option == std::string("--export") ? ".glb"
                                                                  : ".parti");
    const ProgramRun run = RunParti({"replay", house, option, path});
    EXPECT_EQ(run.status, 1) << option;
    EXPECT_THAT(run.errors, HasSubstr("nowhere")) << option;
  }
}

/// The application itself, whose drafts are the test's own.
class ApplicationErrorsTest : public ErrorsTest {
 protected:
  void SetUp() override {
    ::setenv("HOME", folder_.c_str(), 1);
    for (const char* name : {"XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME"}) {
      ::unsetenv(name);
    }
  }
};

TEST_F(ApplicationErrorsTest, WithoutItsDocumentNothingIsPlayedAndNoPictureTaken) {
  const std::string house = SourceFile("assets/drawings/house.pen");
  const std::string png = folder_ + "/x.png";
  for (const std::string& file : {Written("damaged.parti", "no database"),
                                  Written("empty.parti", ""), folder_ + "/nowhere/new.parti"}) {
    const ProgramRun run =
        RunParti({"--display", "offscreen", "--play", house, "--screenshot", png, file});
    EXPECT_EQ(run.status, 1) << file;
    EXPECT_THAT(run.errors, HasSubstr(file));
    EXPECT_FALSE(ReadFile(png)) << file;
  }
}

TEST_F(ErrorsTest, ADamagedDocumentIsRefusedAndNamed) {
  const std::string house = SourceFile("assets/drawings/house.pen");
  const std::string saved = folder_ + "/house.parti";
  ASSERT_EQ(RunParti({"replay", house, "--save", saved}).status, 0);
  const std::string bytes = *ReadFile(saved);
  for (const size_t keep : {size_t{20}, size_t{100}, size_t{5000}, bytes.size() / 2}) {
    const std::string cut = Written("cut.parti", bytes.substr(0, keep));
    const ProgramRun run = RunParti({"query", cut, ".Floor"});
    EXPECT_EQ(run.status, 1) << keep;
    EXPECT_THAT(run.errors, HasSubstr("cut.parti")) << keep;
  }
}

}  // namespace
}  // namespace parti::tests
