// The session thread by what it promises: order, durability, a clean stop.
#include "app/session_thread.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "app/document.h"
#include "app/document_drafts.h"
#include "app/document_lock.h"
#include "base/text_file.h"
#include "input/drawing.h"
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

  /// A document that takes its time to be opened, at a path.
  static void WriteLarge(const std::string& path) {
    Session session;
    for (const char* line : {"lot rect(120,120)", "node .Lot --> split(x) { ~1: Row }*",
                             "node .Row --> split(y) { ~1: Tile }*"}) {
      ASSERT_TRUE(session.Execute(Line(line))) << line;
    }
    ASSERT_TRUE(SaveDocument(DocumentOf(session), path));
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

TEST_F(SessionThreadTest, AFailureIsMendedByWhatIsDoneAfterItAndNotByLooking) {
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  thread.Post(Line("pick 3"));
  const auto looked =
      Settled(&thread, thread.Post(Line("view eye 30 14 40 target 10 5 7 fov 40 size 1600 1000")));
  ASSERT_TRUE(looked->last_error);
  EXPECT_FALSE(looked->last_error->mended);
  EXPECT_TRUE(Settled(&thread, thread.Post(Line("undo")))->last_error->mended);
  EXPECT_FALSE(Settled(&thread, thread.Post(Line("pick 3")))->last_error->mended) << "another one";
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
  EXPECT_THAT(PresentOf(*kept).ground->lots, SizeIs(1));
}

TEST_F(SessionThreadTest, ANewDocumentThatNobodyDrawsInLeavesNoDraft) {
  SessionThread thread(options_);
  for (int i = 0; i < 3; ++i) Settled(&thread, thread.Post(DocumentRequest{Kind::kNew}));
  EXPECT_EQ(thread.Newest()->document.path, "");
  EXPECT_THAT(DraftsIn(options_.folders.data), SizeIs(0));
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

TEST_F(SessionThreadTest, WhatIsNotExecutedInTimeIsDoneAtTheNextOpening) {
  const std::string path = folder_ + "/house.parti";
  constexpr int kMany = 2000;
  {
    SessionThread thread(options_);
    thread.Post(Line("lot rect(20,14)"));
    thread.Post(DocumentRequest{Kind::kSaveAs, path});
    thread.Post(Line("node .Lot --> extrude(12) Mass"));
    for (int i = 1; i <= kMany; ++i) thread.Post(Line(fmt::format("set distance {}", i)));
    static_cast<void>(thread.StopWithin(std::chrono::milliseconds(0)));
    const auto kept = OpenDocument(path);  // as the next process would find it
    ASSERT_TRUE(kept) << FormatError(kept.error());
    EXPECT_GE(kept->history.size() + kept->posted.size(), size_t{kMany + 2});
  }
  const auto left = OpenDocument(path);
  ASSERT_TRUE(left) << FormatError(left.error());
  EXPECT_GT(left->posted.size(), 0u) << "all of them were waited for";
  options_.path = path;
  SessionThread again(options_);
  const auto now = Settled(&again, again.Post(Line("select none")));
  EXPECT_THAT(grammar::TextOf(now->state->model.trees()), HasSubstr("extrude(2000)"));
}

TEST_F(SessionThreadTest, OpeningADocumentAtTheStartIsSaidUntilItIsThere) {
  options_.path = folder_ + "/large.parti";
  WriteLarge(options_.path);
  SessionThread thread(options_);
  auto now = thread.Newest();
  while (now->state->model.lots().empty()) {
    EXPECT_EQ(now->doing, "opening " + options_.path);
    std::this_thread::yield();
    now = thread.Newest();
  }
  EXPECT_EQ(now->doing, "");
}

TEST_F(SessionThreadTest, WhatIsPostedWhileTheDocumentIsOpenedIsKeptInItHoweverShortTheTime) {
  options_.path = folder_ + "/large.parti";
  WriteLarge(options_.path);
  SessionThread thread(options_);
  thread.Post(Line("node .Tile --> extrude(3) Mass"));
  static_cast<void>(thread.StopWithin(std::chrono::milliseconds(0)));
  const auto kept = OpenDocument(options_.path);  // as the next process would find it
  ASSERT_TRUE(kept) << FormatError(kept.error());
  EXPECT_EQ(kept->history.size() + kept->posted.size(), 4u);
}

TEST_F(SessionThreadTest, AnExportIsDoneHoweverShortTheTime) {
  const std::string path = folder_ + "/house.obj";
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  thread.Post(Line("node .Lot --> extrude(12) Mass"));
  thread.Post(DocumentRequest{Kind::kExport, path});
  for (int i = 1; i <= 100; ++i) thread.Post(Line(fmt::format("set distance {}", i)));
  static_cast<void>(thread.StopWithin(std::chrono::milliseconds(0)));
  const auto written = ReadFile(path);
  ASSERT_TRUE(written) << FormatError(written.error());
  EXPECT_THAT(*written, HasSubstr("12"));
}

/// A document that another process seems to have open.
class ReadOnlyTest : public SessionThreadTest {
 protected:
  void SetUp() override {
    options_.path = folder_ + "/house.parti";
    Session session;
    ASSERT_TRUE(session.Execute(Line("lot rect(300,300)")));
    ASSERT_TRUE(session.Execute(Line("node .Lot --> split(x) { ~1: Row }*")));
    ASSERT_TRUE(SaveDocument(DocumentOf(session), options_.path));
    auto lock = DocumentLock::Take(options_.path);
    ASSERT_TRUE(lock) << FormatError(lock.error());
    lock_ = std::move(*lock);
  }
  /// What was drawn and could not be written, as the next start finds it.
  Document Rescued() const {
    const auto drafts = DraftsIn(options_.folders.data);
    EXPECT_THAT(drafts, SizeIs(1));
    if (drafts.empty()) return {};
    auto document = OpenDocument(drafts[0]);
    EXPECT_TRUE(document) << FormatError(document.error());
    return document ? *document : Document();
  }

  std::optional<DocumentLock> lock_;
};

TEST_F(ReadOnlyTest, WhatCannotBeWrittenIsADraftWhenTheProgramEnds) {
  SessionThread thread(options_);
  EXPECT_TRUE(
      Settled(&thread, thread.Post(Line("node .Row --> color(\"blue\")")))->document.read_only);
  thread.Stop();
  EXPECT_THAT(Rescued().history, SizeIs(3));
  EXPECT_EQ(thread.Newest()->document.rescued_from, options_.path);
  EXPECT_THAT(OpenDocument(options_.path)->history, SizeIs(2));
}

TEST_F(ReadOnlyTest, WhatIsNotExecutedInTimeIsInTheDraftToo) {
  SessionThread thread(options_);
  thread.Post(Line("node .Row --> split(y) { ~1: Tile }*"));
  thread.Post(Line("node .Tile --> color(\"blue\")"));
  thread.Post(Line("select none"));
  static_cast<void>(thread.StopWithin(std::chrono::milliseconds(0)));
  const Document rescued = Rescued();
  EXPECT_EQ(rescued.history.size() + rescued.posted.size(), 5u);
}

TEST_F(ReadOnlyTest, HavingLookedItIsLeftWithoutAWord) {
  SessionThread thread(options_);
  thread.Post(DocumentRequest{Kind::kExport, folder_ + "/house.obj"});
  thread.Post(Line("view eye 9 14 40 target 10 5 7 fov 40 size 1600 1000"));
  const auto now = Settled(&thread, thread.Post(DocumentRequest{Kind::kNew}));
  EXPECT_FALSE(now->last_error) << now->last_error->error.message;
  EXPECT_FALSE(now->document.read_only);
}

TEST_F(ReadOnlyTest, WhatAKillLeftOverInItStaysThere) {
  lock_.reset();
  Document document = *OpenDocument(options_.path);
  document.posted = {{"node .Row --> color(\"blue\")"}};
  ASSERT_TRUE(SaveDocument(document, options_.path));
  lock_ = std::move(*DocumentLock::Take(options_.path));
  SessionThread thread(options_);
  const auto now = Settled(&thread, thread.Post(Line("take none")));
  EXPECT_THAT(grammar::TextOf(now->state->model.trees()), HasSubstr("blue"));
  thread.Stop();
  EXPECT_THAT(DraftsIn(options_.folders.data), SizeIs(0));
  EXPECT_THAT(OpenDocument(options_.path)->posted, SizeIs(1));
}

TEST_F(ReadOnlyTest, WhatWasDrawnIsLeftOnlyWhenItMayGo) {
  SessionThread thread(options_);
  thread.Post(DocumentRequest{Kind::kOpen, options_.path});
  thread.Post(Line("node .Row --> color(\"blue\")"));
  auto now = Settled(&thread, thread.Post(DocumentRequest{Kind::kNew}));
  EXPECT_EQ(now->document.unwritten, 1u);
  ASSERT_TRUE(now->last_error && now->last_error->giving_up);
  EXPECT_EQ(*now->last_error->giving_up, (DocumentRequest{Kind::kNew, "", true}));
  now = Settled(&thread, thread.Post(*now->last_error->giving_up));
  EXPECT_TRUE(now->state->model.lots().empty());
  EXPECT_TRUE(now->last_error->mended);
}

TEST_F(ReadOnlyTest, HavingLookedLeavesNothing) {
  SessionThread thread(options_);
  Settled(&thread, thread.Post(Line("view eye 9 14 40 target 10 5 7 fov 40 size 1600 1000")));
  thread.Stop();
  EXPECT_THAT(DraftsIn(options_.folders.data), SizeIs(0));
}

TEST_F(SessionThreadTest, AnUnknownFileIsSaidAndLeavesAnEmptyDocument) {
  options_.path = folder_ + "/missing.parti";
  SessionThread thread(options_);
  const auto now = Settled(&thread, thread.Post(Line("lot rect(20,14)")));
  ASSERT_TRUE(now->last_error);
  EXPECT_THAT(now->last_error->error.message, HasSubstr("missing.parti"));
  EXPECT_FALSE(now->document.named);
}

TEST_F(SessionThreadTest, ReopenedItIsAsItWasWithItsUndo) {
  const std::string path = folder_ + "/house.parti";
  std::string rules;
  {
    SessionThread thread(options_);
    thread.Post(Line("lot rect(20,14)"));
    thread.Post(Line("node .Lot --> extrude(12) Mass"));
    thread.Post(DocumentRequest{Kind::kSaveAs, path});
    thread.Post(Line("set distance 7"));
    const auto now = Settled(&thread, thread.Post(Line("undo")));
    rules = grammar::TextOf(now->state->model.trees());
    EXPECT_TRUE(now->can_redo);
  }
  options_.path = path;
  SessionThread thread(options_);
  auto now = Settled(&thread, thread.Post(Line("take none")));
  EXPECT_EQ(grammar::TextOf(now->state->model.trees()), rules);
  EXPECT_EQ(now->document, (DocumentStatus{path, true}));
  EXPECT_TRUE(now->can_redo);
  now = Settled(&thread, thread.Post(Line("redo")));
  EXPECT_THAT(grammar::TextOf(now->state->model.trees()), HasSubstr("extrude(7)"));
  EXPECT_FALSE(now->can_redo);
}

TEST_F(SessionThreadTest, WhatWasPostedButNotExecutedWhenTheProgramWasKilledIsDoneNow) {
  options_.path = folder_ + "/house.parti";
  Document document = DocumentOf(Session());
  document.posted = {{"lot rect(20,14)"}, {"pick 9"}, {"node .Lot --> extrude(12) Mass"}};
  ASSERT_TRUE(SaveDocument(document, options_.path));
  {
    SessionThread thread(options_);
    const auto now = Settled(&thread, thread.Post(Line("set distance 7")));
    EXPECT_THAT(grammar::TextOf(now->state->model.trees()), HasSubstr("extrude(7)"));
    ASSERT_TRUE(now->last_error) << "pick 9 can't be done, and says so";
  }
  const auto kept = OpenDocument(options_.path);
  EXPECT_THAT(kept->posted, SizeIs(0));
  EXPECT_THAT(kept->history, SizeIs(3));
}

TEST_F(SessionThreadTest, WhatFailsOfThemIsSaidOfTheOpening) {
  const std::string path = folder_ + "/house.parti";
  Document document = DocumentOf(Session());
  document.posted = {{"pick 9"}, {"lot rect(20,14)"}};
  ASSERT_TRUE(SaveDocument(document, path));
  SessionThread thread(options_);
  const uint64_t opening = thread.Post(DocumentRequest{Kind::kOpen, path});
  const auto now = Settled(&thread, opening);
  ASSERT_TRUE(now->last_error);
  EXPECT_EQ(now->last_error->number, opening);
  EXPECT_FALSE(now->last_error->mended) << "that the file was opened mends nothing";
}

TEST_F(SessionThreadTest, WhatEndedTheProgramTwiceIsSaidAndKeptWithAllAfterItAndTheRestIsDone) {
  options_.path = folder_ + "/house.parti";
  Document document = DocumentOf(Session());
  document.posted = {{"lot rect(20,14)"},
                     {"node .Lot --> split(x) { ~1: Row }*", {}, 2},
                     {"node .Lot --> extrude(12) Mass"}};
  ASSERT_TRUE(SaveDocument(document, options_.path));
  {
    SessionThread thread(options_);
    const auto now = Settled(&thread, thread.Post(Line("select none")));
    ASSERT_TRUE(now->last_error);
    EXPECT_EQ(now->last_error->number, 0u);
    EXPECT_THAT(now->last_error->error.message, HasSubstr("2 of what was drawn last"));
    EXPECT_THAT(now->last_error->error.hint, HasSubstr(options_.path));
    EXPECT_THAT(now->state->model.lots(), SizeIs(1));
    EXPECT_THAT(now->state->model.trees(), SizeIs(0));
  }
  const auto kept = OpenDocument(options_.path);
  ASSERT_TRUE(kept) << FormatError(kept.error());
  EXPECT_THAT(kept->posted, SizeIs(0));
  ASSERT_THAT(kept->laid_aside, SizeIs(2));
  EXPECT_THAT(kept->laid_aside[0].command, HasSubstr("split"));
}

TEST_F(SessionThreadTest, RequestsAfterOneAboutDocumentsBelongToTheNextDocument) {
  const std::string first = folder_ + "/first.parti";
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  thread.Post(DocumentRequest{Kind::kSaveAs, first});
  thread.Post(DocumentRequest{Kind::kNew});
  for (int i = 0; i < 9; ++i) thread.Post(Line("lot rect(10,10)"));
  Settled(&thread, thread.Post(DocumentRequest{Kind::kSaveAs, folder_ + "/second.parti"}));
  EXPECT_THAT(OpenDocument(first)->history, SizeIs(1));
  EXPECT_THAT(OpenDocument(first)->posted, SizeIs(0));
  EXPECT_THAT(OpenDocument(folder_ + "/second.parti")->history, SizeIs(9));
}

TEST_F(SessionThreadTest, WhatIsNotANumberDoesNotGetIntoTheDocument) {
  const double nan = std::nan("");
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  Stroke stroke = StrokeFrom("1,2 3,4 5,6");
  stroke[1].position.x = nan;
  stroke[2].pressure = nan;
  stroke[2].t_s = -1;
  thread.Post(stroke);
  thread.Post(Stroke{{Vec2(nan, nan), nan}});
  SetView wrong;
  wrong.camera.eye.x = nan;
  thread.Post(Command(wrong));
  const auto now = Settled(&thread, thread.Post(Command(SetNumber{"distance", nan})));
  const auto kept = OpenDocument(now->document.path);
  ASSERT_TRUE(kept) << FormatError(kept.error());
  ASSERT_THAT(kept->strokes, SizeIs(2));
  EXPECT_THAT(kept->strokes[0]->stroke, SizeIs(2));
}

TEST_F(SessionThreadTest, ViewsThatOthersFollowAtOnceAreSkipped) {
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  for (int i = 0; i < 500; ++i) {
    thread.Post(Line(fmt::format("view eye {} 14 40 target 10 5 7 fov 40 size 1600 1000", i)));
  }
  const auto now = Settled(&thread, thread.Post(Line("take none")));
  EXPECT_EQ(now->state->camera.eye.x, 499);
  EXPECT_THAT(OpenDocument(now->document.path)->history.size(), ::testing::Lt(450u));
}

TEST_F(SessionThreadTest, WhileALongDerivationRunsItIsSaidAndWhatWaitsIsAlreadyOnTheDisk) {
  using Clock = std::chrono::steady_clock;
  options_.path = folder_ + "/house.parti";
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), options_.path));
  SessionThread thread(options_);
  Settled(&thread, thread.Post(Line("lot rect(800,800)")));
  size_t most_kept = 0;
  // On a machine that is at its limit one may be over before it can be watched.
  for (int size_dm = 10; size_dm < 20 && most_kept == 0; ++size_dm) {
    const auto began = Clock::now();
    const uint64_t heavy = thread.Post(Line(fmt::format(
        "rewrite tree t {{ .Lot --> split(x) {{ ~1: Row }}* .Row --> split(y) {{ ~{}: Tile }}* }}",
        size_dm / 10.0)));
    const uint64_t last = thread.Post(StrokeFrom("1,2 3,4"));
    bool busy = false;
    while (thread.Newest()->executed < heavy) {
      busy = busy || thread.Newest()->busy;
      most_kept = std::max(most_kept, OpenDocument(options_.path)->posted.size());
    }
    if (Clock::now() - began > std::chrono::seconds(2)) {
      EXPECT_TRUE(busy);
    }
    EXPECT_FALSE(Settled(&thread, last)->busy);
  }
  EXPECT_GE(most_kept, 1u);
}

TEST_F(SessionThreadTest, WhatIsThereIsReplacedOnlyWhereItMayBe) {
  const std::string file = folder_ + "/there.glb";
  ASSERT_TRUE(WriteFile(file, "somebody's work"));
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  thread.Post(Line("node .Lot --> extrude(12) Mass"));
  for (const Kind kind : {Kind::kSaveAs, Kind::kExport, Kind::kRecordForReport}) {
    const uint64_t refused = thread.Post(DocumentRequest{kind, file});
    const auto now = Settled(&thread, refused);
    ASSERT_TRUE(now->last_error);
    EXPECT_EQ(now->last_error->number, refused);
    EXPECT_THAT(now->last_error->error.message, HasSubstr("is there already"));
    EXPECT_EQ(*ReadFile(file), "somebody's work");
  }
  const DocumentRequest told{.kind = Kind::kExport, .path = file, .replace = true};
  EXPECT_TRUE(Settled(&thread, thread.Post(told))->last_error->mended);
  EXPECT_TRUE(ReadFile(file)->starts_with("glTF"));
}

TEST_F(SessionThreadTest, ASessionIsRecordedForAReport) {
  const std::string pen = folder_ + "/report.pen";
  SessionThread thread(options_);
  thread.Post(Line("lot rect(20,14)"));
  thread.Post(StrokeFrom("1,2 3,4 500,300"));
  Settled(&thread, thread.Post(DocumentRequest{Kind::kRecordForReport, pen}));
  const auto reading = input::ReadDrawing(*ReadFile(pen));
  EXPECT_FALSE(reading.damage);
  EXPECT_THAT(reading.drawing.commands, SizeIs(1));
}

}  // namespace
}  // namespace parti::app
