#include "input/libinput_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "input/unsmoothed.h"

namespace parti::input {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(LibinputSource, MissingNodeIsNamedWithTheRemedy) {
  const auto source = LibinputSource::OpenDevices({"/dev/input/event4000"});
  ASSERT_FALSE(source);
  EXPECT_EQ(source.error().code, ErrorCode::kDevice);
  EXPECT_THAT(source.error().message, HasSubstr("/dev/input/event4000"));
  EXPECT_THAT(source.error().hint, HasSubstr("parti devices"));
}

TEST(LibinputSource, NodeThatIsNoPenIsRefused) {
  const auto source = LibinputSource::OpenDevices({"/dev/null"});
  ASSERT_FALSE(source);
  EXPECT_THAT(source.error().message, HasSubstr("/dev/null is not a pen tablet"));
}

TEST(LibinputSource, SeatWithoutDevicesSaysWhyThereIsNothing) {
  auto source = LibinputSource::OpenSeat("seat-of-nobody");
  ASSERT_TRUE(source) << FormatError(source.error());
  const auto events = source->Dispatch();
  ASSERT_TRUE(events) << FormatError(events.error());
  EXPECT_THAT(*events, IsEmpty());
  EXPECT_EQ(source->present(), 0);
  EXPECT_FALSE(source->Wait(0.001));
  EXPECT_GE(source->fd(), 0);
  EXPECT_EQ(source->WhyNothing().code, ErrorCode::kDevice);
  EXPECT_THAT(source->WhyNothing().hint, HasSubstr("plug one in"));
}

TEST(LibinputSource, NodeThatMayNotBeReadNamesTheGroup) {
  const Error error = CannotOpen("/dev/input/event5", EACCES);
  EXPECT_THAT(FormatError(error), HasSubstr("can't open /dev/input/event5: Permission denied"));
  EXPECT_THAT(error.hint, HasSubstr("usermod -aG input"));
}

TEST(Unsmoothed, AddsOneFileAfterTheSystemsAndIsGoneWithoutTrace) {
  fs::path folder;
  {
    const auto unsmoothed = Unsmoothed::Make();
    ASSERT_TRUE(unsmoothed) << FormatError(unsmoothed.error());
    folder = unsmoothed->folder();
    EXPECT_EQ(std::getenv("LIBINPUT_QUIRKS_DIR"), folder.string());
    std::string last;
    for (const auto& file : fs::directory_iterator(folder)) {
      last = std::max(last, file.path().filename().string());
    }
    EXPECT_EQ(last, "99-parti.quirks");
    for (const auto& file : fs::directory_iterator("/usr/share/libinput")) {
      if (file.path().extension() != ".quirks") continue;
      EXPECT_TRUE(fs::exists(folder / file.path().filename())) << file.path();
    }
    // libinput's own check of quirks, where its tools are installed.
    const std::string check = "libinput quirks validate --data-dir " + folder.string();
    if (std::system("command -v libinput >/dev/null") == 0) {
      EXPECT_EQ(std::system(check.c_str()), 0);
    }
  }
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_EQ(std::getenv("LIBINPUT_QUIRKS_DIR"), nullptr);
}

TEST(Unsmoothed, KeepsAFolderOfTheUsersOwn) {
  const fs::path own = fs::path(::testing::TempDir()) / "parti-own-quirks";
  fs::create_directories(own);
  std::ofstream(own / "50-own.quirks") << "[own]\nMatchUdevType=tablet\nAttrTabletSmoothing=1\n";
  ::setenv("LIBINPUT_QUIRKS_DIR", own.c_str(), 1);
  {
    const auto unsmoothed = Unsmoothed::Make();
    ASSERT_TRUE(unsmoothed);
    EXPECT_TRUE(fs::exists(unsmoothed->folder() / "50-own.quirks"));
    EXPECT_FALSE(fs::exists(unsmoothed->folder() / "30-vendor-wacom.quirks"));
  }
  EXPECT_EQ(std::getenv("LIBINPUT_QUIRKS_DIR"), own.string());
  ::unsetenv("LIBINPUT_QUIRKS_DIR");
  fs::remove_all(own);
}

}  // namespace
}  // namespace parti::input
