#include "app/recent_files.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <thread>

#include "app/document_drafts.h"
#include "app/user_folders.h"
#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(RecentFilesTest, TheNewestComesFirstAndNoneTwice) {
  const std::string folder = tests::TestFolder() + "/state";
  EXPECT_THAT(RecentFiles(folder), IsEmpty());
  for (const char* path : {"/a.parti", "/b.parti", "/a.parti"}) NoteRecentFile(folder, path);
  EXPECT_THAT(RecentFiles(folder), ElementsAre("/a.parti", "/b.parti"));
}

TEST(RecentFilesTest, NamesWithAnyBytesComeBack) {
  const std::string folder = tests::TestFolder();
  const std::string odd = "/a\nb\\n c\xff.parti";
  NoteRecentFile(folder, odd);
  EXPECT_THAT(RecentFiles(folder), ElementsAre(odd));
}

TEST(RecentFilesTest, TheListIsBounded) {
  const std::string folder = tests::TestFolder();
  for (int i = 0; i < 50; ++i) NoteRecentFile(folder, fmt::format("/{}.parti", i));
  const auto recent = RecentFiles(folder);
  ASSERT_THAT(recent, SizeIs(kMostRecentFiles));
  EXPECT_EQ(recent.front(), "/49.parti");
}

TEST(RecentFilesTest, SeveralInstancesAtOnceLoseNothing) {
  const std::string folder = tests::TestFolder();
  std::vector<std::thread> instances;
  for (int i = 0; i < 8; ++i) {
    instances.emplace_back([&, i] { NoteRecentFile(folder, fmt::format("/{}.parti", i)); });
  }
  for (std::thread& instance : instances) instance.join();
  EXPECT_THAT(RecentFiles(folder), SizeIs(8));
}

TEST(RecentFilesTest, ADamagedListGivesWhatCanBeRead) {
  const std::string folder = tests::TestFolder();
  ASSERT_TRUE(WriteFile(folder + "/recent", "rubbish\n\n/a.parti\n\\"));
  EXPECT_THAT(RecentFiles(folder), ElementsAre("/a.parti"));
}

TEST(DocumentDraftsTest, DraftsHaveNamesOfTheirOwnAndEmptyOnesAreNone) {
  const std::string folder = tests::TestFolder();
  const auto one = NewDraftPath(folder), two = NewDraftPath(folder);
  ASSERT_TRUE(one && two);
  EXPECT_NE(*one, *two);
  EXPECT_THAT(DraftsIn(folder), IsEmpty());
  ASSERT_TRUE(WriteFile(*two, "something"));
  EXPECT_THAT(DraftsIn(folder), ElementsAre(*two));
}

/// An environment variable, for as long as this exists.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    ::setenv(name, value, 1);
  }
  ~Variable() {
    if (before_) {
      ::setenv(name_, before_->c_str(), 1);
    } else {
      ::unsetenv(name_);
    }
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> before_;
};

TEST(UserFoldersTest, TheEnvironmentSaysWhereThingsAreKept) {
  const Variable data("XDG_DATA_HOME", "/d"), state("XDG_STATE_HOME", "relative"), h("HOME", "/h");
  const UserFolders folders = UserFoldersFromEnvironment();
  EXPECT_EQ(folders.data, "/d/parti");
  EXPECT_EQ(folders.state, "/h/.local/state/parti") << "relative paths don't count";
}

TEST(UserFoldersTest, AFolderThatCannotBeMadeIsSaid) {
  const std::string file = tests::TestFolder() + "/file";
  ASSERT_TRUE(WriteFile(file, "x"));
  EXPECT_FALSE(MakeFolder(file + "/below"));
}

}  // namespace
}  // namespace parti::app
