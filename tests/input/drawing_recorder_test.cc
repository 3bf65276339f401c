#include "input/drawing_recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.h"
#include "tests/support/events.h"

namespace parti::input {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string TemporaryFile(const char* name) {
  return (std::filesystem::path(::testing::TempDir()) / name).string();
}

/// A clock that has been running for days, as CLOCK_MONOTONIC does.
std::vector<InputEvent> EventsLater() {
  auto events = tests::StrokeEvents("0,0 10,0 10,8", 86400.123456);
  events.insert(events.begin(), tests::PenAdded(0, 86400));
  return events;
}

TEST(DrawingRecorder, FileIsReadableAfterEveryEventAndWholeAfterTheEnd) {
  const std::string path = TemporaryFile("recorder.pen");
  auto recorder = DrawingRecorder::Create(path);
  ASSERT_TRUE(recorder) << FormatError(recorder.error());
  size_t added = 0;
  for (const InputEvent& event : EventsLater()) {
    ASSERT_TRUE(recorder->Add({event}));
    ++added;
    const DrawingReading reading = ReadDrawing(*ReadFile(path), path);  // what a kill would leave
    EXPECT_THAT(reading.drawing.events, SizeIs(added));
    ASSERT_TRUE(reading.damage);
    EXPECT_THAT(reading.damage->message, HasSubstr("its last line is not `end`"));
  }
  ASSERT_TRUE(recorder->AddCommand("pick 1"));
  EXPECT_EQ(recorder->strokes(), 1);
  EXPECT_EQ(recorder->reports(), added - 1);
  ASSERT_TRUE(recorder->Finish());
  const DrawingReading reading = ReadDrawing(*ReadFile(path), path);
  EXPECT_FALSE(reading.damage);
  ASSERT_THAT(reading.drawing.commands, SizeIs(1));
  EXPECT_EQ(reading.drawing.commands[0].after_stroke, 1);
  std::filesystem::remove(path);
}

TEST(DrawingRecorder, TimesAreWholeMicrosecondsSinceTheStart) {
  const std::string path = TemporaryFile("times.pen");
  auto recorder = DrawingRecorder::Create(path);
  ASSERT_TRUE(recorder);
  ASSERT_TRUE(recorder->Add(EventsLater()));
  ASSERT_TRUE(recorder->Finish());
  EXPECT_THAT(*ReadFile(path), HasSubstr("pen 0 in 0.123456 0,0\n"));
  std::filesystem::remove(path);
}

TEST(DrawingRecorder, FolderThatIsNotThereIsNamed) {
  const auto recorder = DrawingRecorder::Create("/nowhere/x.pen");
  ASSERT_FALSE(recorder);
  EXPECT_EQ(recorder.error().code, ErrorCode::kFile);
  EXPECT_THAT(recorder.error().message, HasSubstr("/nowhere/x.pen"));
}

TEST(DrawingRecorder, FullDiskIsSaidAtOnce) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto recorder = DrawingRecorder::Create("/dev/full");
  ASSERT_FALSE(recorder);
  EXPECT_THAT(recorder.error().message, HasSubstr("No space left"));
}

}  // namespace
}  // namespace parti::input
