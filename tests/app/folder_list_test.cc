#include "app/folder_list.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "app/document_drafts.h"
#include "app/document_lock.h"
#include "app/recent_files.h"
#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

TEST(FolderListTest, FoldersFirstThenDocumentsByNameAndAllElseApart) {
  const std::string folder = tests::TestFolder();
  std::filesystem::create_directories(folder + "/zoo");
  for (const char* name : {"b.parti", "A.parti", "c.cga", "c.pen", ".e.parti"}) {
    ASSERT_TRUE(WriteFile(folder + "/" + name, ""));
  }
  const PanelFiles files = ListOf({folder + "/zoo/.."}, {folder, folder});
  std::vector<std::string> names;
  for (const PanelFile& file : files.here) names.emplace_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"zoo", "A.parti", "b.parti"}));
  EXPECT_EQ(*files.others, (std::set<std::string>{".e.parti", "c.cga", "c.pen"}));
  EXPECT_TRUE(files.here[0].is_folder);
  EXPECT_TRUE(std::filesystem::equivalent(files.folder, folder));
  std::filesystem::remove_all(folder);
}

TEST(FolderListTest, RecentFilesComeFirst) {
  const std::string folder = tests::TestFolder();
  NoteRecentFile(folder, "/a/old.parti");
  NoteRecentFile(folder, "/a/new.parti");
  EXPECT_EQ(ListOf({folder}, {folder, folder}).recent,
            (std::vector<std::string>{"/a/new.parti", "/a/old.parti"}));
  std::filesystem::remove_all(folder);
}

class LeftDrafts : public ::testing::Test {
 protected:
  void SetUp() override {
    for (std::string* path : {&older_, &newer_}) {
      *path = NewDraftPath(folder_).value_or("");
      ASSERT_TRUE(WriteFile(*path, "a drawing"));
    }
    const auto now = std::filesystem::file_time_type::clock::now();
    std::filesystem::last_write_time(older_, now - std::chrono::hours(1));
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  PanelFiles List(std::vector<std::string> throw_away = {}) {
    return ListOf({folder_, std::move(throw_away)}, {folder_, folder_});
  }
  const std::string folder_ = tests::TestFolder();
  std::string older_, newer_;
};

TEST_F(LeftDrafts, AreListedNewestFirstAndNotAmongTheRecentFiles) {
  NoteRecentFile(folder_, older_);
  NoteRecentFile(folder_, "/a/House.parti");
  const PanelFiles files = List();
  EXPECT_EQ(files.drafts, (std::vector<std::string>{newer_, older_}));
  EXPECT_EQ(files.recent, (std::vector<std::string>{"/a/House.parti"}));
}

TEST_F(LeftDrafts, OneThatIsOpenIsNotLeft) {
  const auto lock = DocumentLock::Take(newer_);
  ASSERT_TRUE(lock);
  EXPECT_EQ(List().drafts, (std::vector<std::string>{older_}));
}

TEST_F(LeftDrafts, ThrownAwayOnesAreGoneWithTheirLogs) {
  ASSERT_TRUE(WriteFile(older_ + "-wal", "log"));
  const PanelFiles files = List({older_});
  EXPECT_EQ(files.drafts, (std::vector<std::string>{newer_}));
  EXPECT_EQ(files.trouble, "");
  EXPECT_FALSE(std::filesystem::exists(older_));
  EXPECT_FALSE(std::filesystem::exists(older_ + "-wal"));
  EXPECT_EQ(List({older_}).trouble, "") << "asked once more";
}

TEST_F(LeftDrafts, WhatIsNoDraftOrIsOpenIsNotThrownAway) {
  const std::string house = folder_ + "/House.parti";
  ASSERT_TRUE(WriteFile(house, "a house"));
  EXPECT_NE(List({house}).trouble, "");
  EXPECT_TRUE(std::filesystem::exists(house));
  const auto lock = DocumentLock::Take(newer_);
  ASSERT_TRUE(lock);
  EXPECT_NE(List({newer_}).trouble, "");
  EXPECT_TRUE(std::filesystem::exists(newer_));
}

TEST(FolderListTest, AFolderThatIsNotThereIsEmpty) {
  EXPECT_TRUE(ListOf({"/no/such/folder"}, {}).here.empty());
}

}  // namespace
}  // namespace parti::app
