#include "app/acknowledgement_log.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

class AcknowledgementLogTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::string folder_ = tests::TestFolder();
  const std::string path_ = folder_ + "/acknowledged";
};

SessionSnapshot Acknowledged(uint64_t number) {
  SessionSnapshot snapshot;
  snapshot.acknowledged = number;
  return snapshot;
}

TEST_F(AcknowledgementLogTest, EachNumberIsSaidOnceAsSoonAsItIsKnown) {
  auto log = AcknowledgementLog::Open(path_);
  ASSERT_TRUE(log);
  for (const uint64_t number : {0, 1, 1, 4, 4}) ASSERT_TRUE(log->Note(Acknowledged(number)));
  EXPECT_EQ(*ReadFile(path_), "acknowledged 1\nacknowledged 4\n");
}

TEST_F(AcknowledgementLogTest, FailuresAreSaidOnceWithTheirReason) {
  auto log = AcknowledgementLog::Open(path_);
  ASSERT_TRUE(log);
  SessionSnapshot snapshot = Acknowledged(3);
  snapshot.last_error = FailedRequest{2, Error{ErrorCode::kNoFit, "nothing fits"}};
  ASSERT_TRUE(log->Note(snapshot));
  ASSERT_TRUE(log->Note(snapshot));
  EXPECT_EQ(*ReadFile(path_), "failed 2: nothing fits\nacknowledged 3\n");
}

TEST_F(AcknowledgementLogTest, AFailureAtTheStartIsSaid) {
  auto log = AcknowledgementLog::Open(path_);
  ASSERT_TRUE(log);
  SessionSnapshot snapshot;
  snapshot.last_error = FailedRequest{0, Error{ErrorCode::kFile, "no document"}};
  ASSERT_TRUE(log->Note(snapshot));
  ASSERT_TRUE(log->Note(snapshot));
  EXPECT_EQ(*ReadFile(path_), "failed 0: no document\n");
}

TEST_F(AcknowledgementLogTest, AppendsToWhatIsThereAndSaysWhereItCannot) {
  for (const uint64_t number : {1, 2}) {
    auto log = AcknowledgementLog::Open(path_);
    ASSERT_TRUE(log);
    ASSERT_TRUE(log->Note(Acknowledged(number)));
  }
  EXPECT_EQ(*ReadFile(path_), "acknowledged 1\nacknowledged 2\n");
  const auto nowhere = AcknowledgementLog::Open(path_ + "/no/folder");
  ASSERT_FALSE(nowhere);
  EXPECT_EQ(nowhere.error().code, ErrorCode::kFile);
}

}  // namespace
}  // namespace parti::app
