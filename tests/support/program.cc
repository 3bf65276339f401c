#include "tests/support/program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "base/text_file.h"

namespace parti::tests {
namespace fs = std::filesystem;

std::string TestFolder() {
  std::string name = ::testing::TempDir() + "parti.XXXXXX";
  const char* made = ::mkdtemp(name.data());
  EXPECT_NE(made, nullptr) << "can't make a folder in " << ::testing::TempDir();
  return name;
}

ProgramRun RunParti(const std::vector<std::string>& arguments, const std::string& input,
                    const std::string& output_to) {
  const std::string folder = TestFolder();
  const auto quoted = [](const std::string& word) {
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
  };
  std::string command = quoted(PARTI_PROGRAM);
  for (const std::string& argument : arguments) command += " " + quoted(argument);
  EXPECT_TRUE(WriteFile(folder + "/in", input));
  command += " <" + quoted(folder + "/in") + " >" +
             quoted(output_to.empty() ? folder + "/out" : output_to) + " 2>" +
             quoted(folder + "/err");
  const int code = std::system(command.c_str());
  ProgramRun run;
  run.status = WIFEXITED(code) ? WEXITSTATUS(code) : 128 + WTERMSIG(code);
  run.output = ReadFile(folder + "/out").value_or("");
  run.errors = ReadFile(folder + "/err").value_or("");
  fs::remove_all(folder);
  return run;
}

}  // namespace parti::tests
