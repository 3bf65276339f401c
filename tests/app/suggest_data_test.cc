// What sketch recognition is worth on real pens: SketchBench's tasks from the development strokes,
// answered by the program and scored by the bench itself. The floors are docs/inference.md's
// figures with room for another seed.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

struct Solved {
  double first = 0;  ///< %
  double three = 0;  ///< %
};

std::string OutputOf(const std::string& command) {
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return output;
  char buffer[4096];
  for (size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) output.append(buffer, n);
  return pclose(pipe) == 0 ? output : "";
}

// Rows of the bench's table: kind, tasks, op@1, op@3, solved@1, solved@3.
std::map<std::string, Solved> Table(const std::string& text) {
  std::map<std::string, Solved> table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    for (char& c : line) c = c == '%' ? ' ' : c;
    std::istringstream row(line);
    std::string kind;
    double tasks = 0, op_1 = 0, op_3 = 0;
    Solved solved;
    if (row >> kind >> tasks >> op_1 >> op_3 >> solved.first >> solved.three) table[kind] = solved;
  }
  return table;
}

TEST(RealSketches, AreSolvedAsOftenAsTheDocumentsSay) {
  PARTI_NEED_DATA(strokes, "strokes/unistrokes-dev.jsonl");
  const auto tool = std::filesystem::path(strokes).parent_path() / "../../tools/sketchbench.py";
  if (!std::filesystem::exists(tool)) GTEST_SKIP() << "no sketchbench.py beside the data";
  const std::string bench = "python3 '" + tool.lexically_normal().string() + "' ";
  const std::string folder = tests::TestFolder();
  const std::string tasks = folder + "/tasks.jsonl", answers = folder + "/answers.jsonl";
  const std::string made = OutputOf(bench + "make '" + strokes + "' --seed 23 --count 150");
  ASSERT_FALSE(made.empty());
  std::ofstream(tasks) << made;
  const tests::ProgramRun run = tests::RunParti({"suggest", "--batch", tasks});
  std::ofstream(answers) << run.output;
  const auto table = Table(OutputOf(bench + "score '" + tasks + "' '" + answers + "'"));
  ASSERT_TRUE(table.count("all"));
  EXPECT_GE(table.at("all").first, 95);
  EXPECT_GE(table.at("all").three, 96);
  for (const auto& [kind, solved] : table) EXPECT_GE(solved.three, 85) << kind;
}

TEST(RealSketches, AreNeverAnError) {
  PARTI_NEED_DATA(strokes, "strokes/unistrokes-dev.jsonl");
  const auto tool = std::filesystem::path(strokes).parent_path() / "../../tools/sketchbench.py";
  if (!std::filesystem::exists(tool)) GTEST_SKIP() << "no sketchbench.py beside the data";
  const std::string tasks = tests::TestFolder() + "/tasks.jsonl";
  // One of seed 1 is a portal of which the pen drew the far side 20 px off.
  std::ofstream(tasks) << OutputOf("python3 '" + tool.lexically_normal().string() + "' make '" +
                                   strokes + "' --seed 1 --count 400");
  const tests::ProgramRun run = tests::RunParti({"suggest", "--batch", tasks});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output.find("\"error\""), std::string::npos);
}

}  // namespace
}  // namespace parti::app
