#include "base/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <thread>

namespace parti {
namespace {
namespace fs = std::filesystem;

class TextFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "parti-XXXXXX";
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::string In(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

// Root may write everything: while one of these lives, a root becomes the user "nobody".
class Ordinary {
 public:
  explicit Ordinary(const fs::path& folder) : user_(::geteuid()) {
    constexpr uid_t kNobody = 65534;
    if (user_ != 0) return;
    EXPECT_EQ(::chown(folder.c_str(), kNobody, static_cast<gid_t>(-1)), 0);
    EXPECT_EQ(::seteuid(kNobody), 0);
  }
  Ordinary(const Ordinary&) = delete;
  Ordinary& operator=(const Ordinary&) = delete;
  ~Ordinary() { EXPECT_EQ(::seteuid(user_), 0); }

 private:
  uid_t user_;
};

TEST_F(TextFile, BytesComeBackAsTheyWere) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(WriteFile(In("a"), bytes));
  EXPECT_EQ(ReadFile(In("a")).value(), bytes);
  ASSERT_TRUE(WriteFile(In("a"), ""));
  EXPECT_EQ(ReadFile(In("a")).value(), "");
  const std::string large(1 << 20, 'x');
  ASSERT_TRUE(WriteFile(In("a"), large));
  EXPECT_EQ(ReadFile(In("a")).value(), large);
}

TEST_F(TextFile, NothingIsLeftBesideTheFile) {
  ASSERT_TRUE(WriteFile(In("a"), "1"));
  ASSERT_TRUE(WriteFile(In("a"), "2"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(TextFile, AMissingFileIsNamed) {
  const auto read = ReadFile(In("nothing"));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kFile);
  EXPECT_NE(read.error().message.find(In("nothing")), std::string::npos);
  EXPECT_NE(read.error().message.find("No such file"), std::string::npos);
  EXPECT_FALSE(read.error().hint.empty());
}

TEST_F(TextFile, AMissingFolderIsNotMade) {
  const auto written = WriteFile(In("no/such/a"), "1");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().hint.find("folder"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "no"));
}

TEST_F(TextFile, AFolderIsNotAFile) {
  EXPECT_EQ(ReadFile(folder_.string()).error().message,
            folder_.string() + " is a folder, not a file");
  EXPECT_FALSE(WriteFile(folder_.string(), "1"));
  EXPECT_TRUE(fs::is_directory(folder_));
  fs::create_directory(folder_ / "sub");
  EXPECT_FALSE(WriteFile(In("sub"), "1"));
}

TEST_F(TextFile, AFullDiskIsAnErrorAndTheDeviceStays) {
  const auto written = WriteFile("/dev/full", "1");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("No space"), std::string::npos);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(TextFile, ADeviceIsWrittenIntoNotReplaced) {
  EXPECT_TRUE(WriteFile("/dev/null", "1"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(TextFile, APipeIsWrittenInto) {
  ASSERT_EQ(::mkfifo(In("pipe").c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = ReadFile(In("pipe")).value_or("failed"); });
  EXPECT_TRUE(WriteFile(In("pipe"), "through"));
  reader.join();
  EXPECT_EQ(read, "through");
}

TEST_F(TextFile, ALinkStaysALinkAndPermissionsStay) {
  ASSERT_TRUE(WriteFile(In("a"), "old"));
  fs::permissions(In("a"), fs::perms(0640));
  fs::create_symlink(In("a"), In("link"));
  ASSERT_TRUE(WriteFile(In("link"), "new"));
  EXPECT_TRUE(fs::is_symlink(In("link")));
  EXPECT_EQ(ReadFile(In("a")).value(), "new");
  EXPECT_EQ(fs::status(In("a")).permissions(), fs::perms(0640));
}

TEST_F(TextFile, AFileThatMayNotBeWrittenIsKept) {
  const Ordinary ordinary(folder_);
  ASSERT_TRUE(WriteFile(In("a"), "old"));
  fs::permissions(In("a"), fs::perms(0400));
  EXPECT_FALSE(WriteFile(In("a"), "new"));
  EXPECT_EQ(ReadFile(In("a")).value(), "old");
  fs::permissions(folder_, fs::perms(0500));
  const auto written = WriteFile(In("b"), "new");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().message.find("Permission denied"), std::string::npos);
}

TEST_F(TextFile, AReadThatFailsMidwayIsAnError) {
  // Address 0 of a process can't be read: open succeeds, read does not.
  EXPECT_FALSE(ReadFile("/proc/self/mem"));
}

TEST_F(TextFile, AnEndlessFileIsGivenUp) {
  const auto read = ReadFile("/dev/zero");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("larger than 256 MiB"), std::string::npos);
}

TEST_F(TextFile, AnEmptyNameIsAnError) {
  EXPECT_FALSE(ReadFile(""));
  EXPECT_FALSE(WriteFile("", "1"));
}

}  // namespace
}  // namespace parti
