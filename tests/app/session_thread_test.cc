// The session thread by what it promises: order, durability, a clean stop.
#include "app/session_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "app/document.h"
#include "app/document_drafts.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

using Kind = DocumentRequest::Kind;

class SessionThreadTest : public ::testing::Test {
 protected:
  SessionThreadTest() : folder_(tests::TestFolder()) {
    options_.folders = {folder_ + "/data", folder_ + "/state"};
  }

  static Command Line(const std::string& text) { return *ParseCommand(text); }

  /// Waits until everything that was posted is executed and written, or given up.
  static std::shared_ptr<const SessionSnapshot> Settled(SessionThread* thread, uint64_t number) {
    while (true) {
      const auto newest = thread->Newest();
      if (newest->executed >= number &&
          (newest->acknowledged >= number || newest->document.trouble))
        return newest;
      pollfd waiting{thread->ready().fd(), POLLIN, 0};
      EXPECT_EQ(::poll(&waiting, 1, 20000), 1) << "nothing came in 20 s";
      thread->ready().Clear();
    }
  }

  std::string folder_;
  SessionThreadOptions options_;
};

TEST_F(SessionThreadTest, WhatIsPostedIsExecutedInOrderAndAcknowledged) {
  SessionThread thread(options_);
  EXPECT_EQ(thread.Post(Line("lot rect(20,14)")), 1u);
  EXPECT_EQ(thread.Post(Line("node .Lot --> extrude(12) Mass")), 2u);
  const auto now = Settled(&thread, thread.Post(Line("set distance 7")));
  EXPECT_EQ(now->executed, 3u);
  EXPECT_EQ(now->acknowledged, 3u);
  EXPECT_FALSE(now->last_error);
  EXPECT_THAT(grammar::TextOf(now->state->model.trees()), HasSubstr("extrude(7)"));
}

TEST_F(SessionThreadTest, SnapshotsStayAsTheyAre) {
  SessionThread thread(options_);
  const auto before = Settled(&thread, thread.Post(Line("lot rect(20,14)")));
  Settled(&thread, thread.Post(Line("node .Lot --> extrude(12) Mass")));
  EXPECT_THAT(before->state->model.trees(), SizeIs(0));
}

TEST_F(SessionThreadTest, WhatFailsIsSaidWithItsNumberAndTheRestGoesOn) {
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  const uint64_t wrong = thread.Post(Line("pick 3"));
  const auto now = Settled(&thread, thread.Post(Line("node .Lot --> extrude(12) Mass")));
  ASSERT_TRUE(now->last_error);
  EXPECT_EQ(now->last_error->number, wrong);
  EXPECT_THAT(now->last_error->error.message, HasSubstr("no suggestion"));
  EXPECT_THAT(now->state->model.trees(), SizeIs(1));
}

TEST_F(SessionThreadTest, ANewDocumentLivesAmongTheDraftsFromTheFirstCommandOn) {
  SessionThread thread(options_);
  EXPECT_THAT(DraftsIn(options_.folders.data), SizeIs(0));
  const auto now = Settled(&thread, thread.Post(Line("lot rect(20,14)")));
  EXPECT_FALSE(now->document.named);
  EXPECT_THAT(DraftsIn(options_.folders.data), ElementsAre(now->document.path));
  const auto kept = OpenDocument(now->document.path);
  ASSERT_TRUE(kept) << FormatError(kept.error());
  EXPECT_THAT(kept->lots, SizeIs(1));
}

TEST_F(SessionThreadTest, StoppingExecutesAndWritesWhatWasPosted) {
  const std::string path = folder_ + "/house.parti";
  {
    SessionThread thread(options_);
    thread.Post(Line("lot rect(20,14)"));
    thread.Post(DocumentRequest{Kind::kSaveAs, path});
    for (int i = 0; i < 20; ++i) thread.Post(Line("node .Lot --> extrude(12) Mass"));
    thread.Stop();
    EXPECT_EQ(thread.Newest()->acknowledged, 22u);
  }
  const auto kept = OpenDocument(path);
  ASSERT_TRUE(kept) << FormatError(kept.error());
  EXPECT_THAT(kept->history, SizeIs(21));
}

TEST_F(SessionThreadTest, AnUnknownFileIsSaidAndLeavesAnEmptyDocument) {
  options_.path = folder_ + "/missing.parti";
  SessionThread thread(options_);
  const auto now = Settled(&thread, thread.Post(Line("lot rect(20,14)")));
  ASSERT_TRUE(now->last_error);
  EXPECT_THAT(now->last_error->error.message, HasSubstr("missing.parti"));
  EXPECT_FALSE(now->document.named);
}

}  // namespace
}  // namespace parti::app
