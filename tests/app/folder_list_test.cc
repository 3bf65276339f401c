#include "app/folder_list.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "app/recent_files.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

TEST(FolderListTest, FoldersFirstThenWhatPartiOpensByName) {
  const std::string folder = testing::TempDir() + "folder_list";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder + "/zoo");
  for (const char* name : {"b.parti", "A.pen", "c.cga", "d.txt", ".e.parti"}) {
    ASSERT_TRUE(WriteFile(folder + "/" + name, ""));
  }
  const PanelFiles files = ListOf(folder + "/zoo/..", folder);
  std::vector<std::string> names;
  for (const PanelFile& file : files.here) names.emplace_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"zoo", "A.pen", "b.parti", "c.cga"}));
  EXPECT_TRUE(files.here[0].is_folder);
  EXPECT_TRUE(std::filesystem::equivalent(files.folder, folder));
  std::filesystem::remove_all(folder);
}

TEST(FolderListTest, RecentFilesComeFirst) {
  const std::string folder = testing::TempDir() + "folder_list_recent";
  std::filesystem::remove_all(folder);
  NoteRecentFile(folder, "/a/old.parti");
  NoteRecentFile(folder, "/a/new.parti");
  EXPECT_EQ(ListOf(folder, folder).recent,
            (std::vector<std::string>{"/a/new.parti", "/a/old.parti"}));
  std::filesystem::remove_all(folder);
}

TEST(FolderListTest, AFolderThatIsNotThereIsEmpty) {
  EXPECT_TRUE(ListOf("/no/such/folder", "").here.empty());
}

}  // namespace
}  // namespace parti::app
