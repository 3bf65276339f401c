#include "app/command_pipe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::SizeIs;

class CommandPipeTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0); }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void Write(const std::string& text) const { std::ofstream(path_) << text; }

  static bool Readable(const CommandPipe& pipe) {
    pollfd waited{.fd = pipe.fd(), .events = POLLIN, .revents = 0};
    return ::poll(&waited, 1, 0) == 1;
  }

  const std::string folder_ = tests::TestFolder();
  const std::string path_ = folder_ + "/pipe";
};

TEST_F(CommandPipeTest, AFloodComesInPartsAndALineWithoutAnEndIsNoCommand) {
  auto pipe = CommandPipe::Open(path_);
  ASSERT_TRUE(pipe);
  const std::string part(1 << 15, 'x');
  std::vector<Result<Command>> commands;
  for (int i = 0; i < 260; ++i) {
    Write(part);
    commands = pipe->Read();
    ASSERT_THAT(commands, SizeIs(0));
  }
  Write("x\nundo\n");
  commands = pipe->Read();
  ASSERT_THAT(commands, SizeIs(2));
  ASSERT_FALSE(commands[0]);
  EXPECT_EQ(commands[0].error().code, ErrorCode::kLimitReached);
  EXPECT_EQ(TextOf(*commands[1]), "undo");
}

TEST_F(CommandPipeTest, LinesBecomeCommandsInOrderWhateverTheyCameIn) {
  auto pipe = CommandPipe::Open(path_);
  ASSERT_TRUE(pipe);
  EXPECT_THAT(pipe->Read(), SizeIs(0));
  Write("pick 2 split\nun");
  EXPECT_TRUE(Readable(*pipe));
  auto commands = pipe->Read();
  ASSERT_THAT(commands, SizeIs(1));
  EXPECT_EQ(TextOf(*commands[0]), "pick 2 split");
  Write("do\n\nredo\n");
  commands = pipe->Read();
  ASSERT_THAT(commands, SizeIs(2));
  EXPECT_EQ(TextOf(*commands[0]), "undo");
  EXPECT_EQ(TextOf(*commands[1]), "redo");
  EXPECT_FALSE(Readable(*pipe)) << "a writer's end must not wake anyone";
}

TEST_F(CommandPipeTest, WhatIsNoCommandFailsAndTheRestGoesOn) {
  auto pipe = CommandPipe::Open(path_);
  ASSERT_TRUE(pipe);
  Write("undoo\nundo\n");
  const auto commands = pipe->Read();
  ASSERT_THAT(commands, SizeIs(2));
  ASSERT_FALSE(commands[0]);
  EXPECT_EQ(commands[0].error().code, ErrorCode::kUnknownName);
  EXPECT_TRUE(commands[1]);
}

TEST_F(CommandPipeTest, OnlyFifosAreListenedTo) {
  std::filesystem::remove(path_);
  const auto missing = CommandPipe::Open(path_);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kFile);
  Write("undo\n");
  const auto file = CommandPipe::Open(path_);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kFile);
}

}  // namespace
}  // namespace parti::app
