#include "app/settings.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.h"

namespace parti::app {
namespace {

class SettingsTest : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::string folder_ = testing::TempDir() + "settings_" +
                              testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path_ = folder_ + "/parti/settings.json";
};

TEST_F(SettingsTest, ANewUserHasTheUsualOnes) {
  const auto settings = ReadSettings(path_);
  ASSERT_TRUE(settings);
  EXPECT_EQ(*settings, Settings{});
}

TEST_F(SettingsTest, APlaceThatCantBeLookedIntoHasNone) {
  const auto settings = ReadSettings(folder_ + "/" + std::string(300, 'x') + "/settings.json");
  ASSERT_TRUE(settings);
  EXPECT_EQ(*settings, Settings{});
}

TEST_F(SettingsTest, WhatIsWrittenReadsBack) {
  const Settings settings{Theme::kDark, 1.5, true, true, "lower select"};
  ASSERT_TRUE(WriteSettings(settings, path_));
  const auto read = ReadSettings(path_);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, settings);
}

TEST_F(SettingsTest, ValuesThatCantBeAreLeftAtTheirDefault) {
  ASSERT_TRUE(WriteSettings({}, path_));
  ASSERT_TRUE(WriteFile(path_, R"({"theme": 7, "scale": 900, "left_handed": "yes", "new": 1})"));
  const auto read = ReadSettings(path_);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, Settings{});
}

TEST_F(SettingsTest, WhatIsNotJsonIsAnErrorWithItsPlace) {
  ASSERT_TRUE(WriteSettings({}, path_));
  ASSERT_TRUE(WriteFile(path_, "{\"theme\": "));
  const auto read = ReadSettings(path_);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kBadText);
  ASSERT_TRUE(read.error().place);
  EXPECT_EQ(read.error().place->file, path_);
}

TEST_F(SettingsTest, AFolderThatCantBeMadeIsSaid) {
  const auto written = WriteSettings({}, "/proc/none/settings.json");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::kFile);
  EXPECT_FALSE(WriteSettings({}, ""));
}

}  // namespace
}  // namespace parti::app
