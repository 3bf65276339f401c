// What becomes of a document when the disk, the folder or another instance is in the way: it is
// said, nothing is lost, and another place takes everything.
#include "app/document_keeper.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "app/document_drafts.h"
#include "app/recent_files.h"
#include "app/sqlite.h"
#include "base/text_file.h"
#include "tests/app/faulty_disk.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::FaultyDisk;

std::string NameOf(const std::string& path) { return fs::path(path).filename().string(); }

/// A session whose every command goes to a keeper, as the session thread does it.
class DocumentKeeperTest : public ::testing::Test {
 protected:
  DocumentKeeperTest()
      : folder_(tests::TestFolder()),
        folders_{folder_ + "/data", folder_ + "/state"},
        path_(folder_ + "/house.parti"),
        keeper_(folders_) {
    EXPECT_TRUE(keeper_.New(DocumentOf(session_), false));
  }

  void Do(const std::string& line) {
    const auto done = session_.Execute(*ParseCommand(line));
    ASSERT_TRUE(done) << line << ": " << done.error().message;
    const Timeline::Span span = session_.timeline().span();
    keeper_.Apply({{++number_, nullptr, line, session_.timeline().step(span.now).record, span}});
    session_.ForgetHistory();
  }
  void SaveAs(const std::string& path) {
    const auto saved = keeper_.SaveAs(path, DocumentOf(session_), true);
    ASSERT_TRUE(saved) << FormatError(saved.error());
  }
  /// A document with a lot in it, at path_.
  void Begin() {
    Do("lot rect(20,14)");
    SaveAs(path_);
  }
  /// The file at a path has all that the session has.
  void ExpectWhole(const std::string& path, size_t commands) {
    const auto document = OpenDocument(path);
    ASSERT_TRUE(document) << FormatError(document.error());
    EXPECT_THAT(document->history, SizeIs(commands));
    EXPECT_EQ(document->span, session_.timeline().span());
    EXPECT_EQ(*PresentOf(*document).rules, session_.state().model.trees());
  }

  static constexpr const char* kNode = "node .Lot --> extrude(12) Mass";

  std::string folder_;
  UserFolders folders_;
  std::string path_;
  Session session_;
  int64_t number_ = 0;
  DocumentKeeper keeper_;
};

TEST_F(DocumentKeeperTest, WhatIsDoneIsInTheFileAtOnce) {
  Begin();
  Do(kNode);
  Do("undo");
  EXPECT_EQ(keeper_.acknowledged(), 3);
  ExpectWhole(path_, 3);
}

TEST_F(DocumentKeeperTest, SavingADraftUnderANameMovesIt) {
  Do("lot rect(20,14)");
  EXPECT_THAT(DraftsIn(folders_.data), ElementsAre(keeper_.status().path));
  SaveAs(path_);
  EXPECT_THAT(DraftsIn(folders_.data), IsEmpty());
  EXPECT_TRUE(keeper_.status().named);
  EXPECT_THAT(RecentFiles(folders_.state), ElementsAre(path_));
}

TEST_F(DocumentKeeperTest, ADraftThatWasOnlyBegunGoesWhenItIsLeft) {
  Do("lot rect(24,16)");
  Do("view eye 9 14 40 target 10 5 7 fov 40 size 1600 1000");
  EXPECT_THAT(DraftsIn(folders_.data), SizeIs(1)) << "a kill now costs nothing";
  ASSERT_TRUE(keeper_.New(DocumentOf(Session()), false));
  EXPECT_THAT(DraftsIn(folders_.data), IsEmpty());
  {
    DocumentKeeper other(folders_);
    ASSERT_TRUE(other.New(DocumentOf(Session()), false));
    other.Keep({{1, {"lot rect(24,16)"}}});
    EXPECT_THAT(DraftsIn(folders_.data), SizeIs(1));
  }
  EXPECT_THAT(DraftsIn(folders_.data), IsEmpty()) << "the program ended";
}

TEST_F(DocumentKeeperTest, ADraftInWhichAnythingWasDoneStaysWhenItIsLeft) {
  Do("lot rect(24,16)");
  Do("node .Lot --> extrude(9) Mass");
  Do("undo");
  ASSERT_TRUE(keeper_.New(DocumentOf(session_), false));
  EXPECT_THAT(DraftsIn(folders_.data), SizeIs(1));
  keeper_.Keep({{1, {"", Stroke{{{1, 2}, 0}}}}});
  ASSERT_TRUE(keeper_.New(DocumentOf(session_), false));
  EXPECT_THAT(DraftsIn(folders_.data), SizeIs(2)) << "a stroke that waits to be executed";
}

TEST_F(DocumentKeeperTest, ADraftThatIsOpenedAgainIsStillOneAndMoves) {
  Do("lot rect(20,14)");
  Do(kNode);
  const std::string draft = keeper_.status().path;
  fs::create_directory_symlink(folders_.data, folder_ + "/link");
  for (const std::string& path : {draft, folder_ + "/link/drafts/" + NameOf(draft)}) {
    ASSERT_TRUE(keeper_.New(DocumentOf(Session()), false));
    ASSERT_TRUE(keeper_.Open(path, false));
    EXPECT_FALSE(keeper_.status().named) << path;
  }
  SaveAs(path_);
  EXPECT_TRUE(keeper_.status().named);
  EXPECT_THAT(DraftsIn(folders_.data), IsEmpty()) << "no stale twin";
  ExpectWhole(path_, 2);
}

TEST_F(DocumentKeeperTest, ADraftThatAnotherInstanceHasOpenIsLeftToIt) {
  Do("lot rect(20,14)");
  const std::string draft = keeper_.status().path;
  DocumentKeeper second(folders_);
  ASSERT_TRUE(second.Open(draft, false));
  ASSERT_TRUE(second.status().read_only);
  ASSERT_TRUE(second.SaveAs(path_, DocumentOf(session_)));
  EXPECT_TRUE(second.status().named);
  Do(kNode);
  EXPECT_FALSE(keeper_.status().trouble);
  ExpectWhole(draft, 2);
}

TEST_F(DocumentKeeperTest, AnotherFileIsNotSavedOverUnlessItMayGo) {
  Begin();
  const std::string other = folder_ + "/other.parti";
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), other));
  const auto refused = keeper_.SaveAs(other, DocumentOf(session_));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("other.parti is there already"));
  ExpectWhole(path_, 1);
  EXPECT_THAT(OpenDocument(other)->history, IsEmpty());
  EXPECT_EQ(keeper_.status().path, path_);
  EXPECT_TRUE(keeper_.SaveAs(path_, DocumentOf(session_))) << "its own file";
  EXPECT_TRUE(keeper_.SaveAs(other, DocumentOf(session_), true));
  ExpectWhole(other, 1);
}

TEST_F(DocumentKeeperTest, AFileThatTookTheDocumentsPlaceIsAnother) {
  Begin();
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_ + ".new"));
  fs::rename(path_ + ".new", path_);
  EXPECT_FALSE(keeper_.SaveAs(path_, DocumentOf(session_)));
  EXPECT_THAT(OpenDocument(path_)->history, IsEmpty());
}

TEST_F(DocumentKeeperTest, TheUndoLimitHoldsInTheFileToo) {
  session_ = Session(SessionOptions{.undo = {.steps = 5}});
  ASSERT_TRUE(keeper_.New(DocumentOf(session_), false));
  Begin();
  for (int i = 0; i < 30; ++i) Do(kNode);
  ExpectWhole(path_, 31);
  EXPECT_THAT(OpenDocument(path_)->states, SizeIs(6));
  auto database = Database::Open(path_, Database::Mode::kRead);
  // Six states with rules and a node in hand of their own, one view, one lot.
  EXPECT_EQ(database->Prepare("SELECT count(*) FROM text")
                .and_then([](Statement s) -> Result<int64_t> {
                  const auto row = s.Step();
                  return row ? Result<int64_t>(s.Integer(0)) : Fail(row);
                })
                .value_or(-1),
            14);
}

TEST_F(DocumentKeeperTest, ALogThatWasTidiedIsSmallAgain) {
  constexpr uintmax_t kLarge = uintmax_t{4} << 20;  // as in document_file.cc
  const auto log = [&] { return fs::file_size(path_ + "-wal"); };
  Begin();
  for (int64_t number = 2; number < 8; ++number) {
    keeper_.Keep({{number, {std::string(1 << 20, 'x')}}});
  }
  EXPECT_GT(log(), kLarge);
  keeper_.Tidy();
  keeper_.Keep({{8, {"take none"}}});
  EXPECT_LT(log(), kLarge);
  EXPECT_FALSE(keeper_.status().trouble);
}

TEST_F(DocumentKeeperTest, AFullDiskIsSaidAtOnceAndWritingResumes) {
  FaultyDisk disk;
  Begin();
  disk.Break(FaultyDisk::Fault::kFull);
  Do(kNode);
  Do("set distance 7");
  ASSERT_TRUE(keeper_.status().trouble);
  EXPECT_THAT(keeper_.status().trouble->message, HasSubstr("full"));
  EXPECT_THAT(keeper_.status().trouble->hint, HasSubstr("make room"));
  EXPECT_EQ(keeper_.status().unwritten, 2u);
  EXPECT_EQ(keeper_.acknowledged(), 1);
  disk.Repair();
  keeper_.TryAgain();
  EXPECT_FALSE(keeper_.status().trouble);
  EXPECT_EQ(keeper_.status().unwritten, 0u);
  EXPECT_EQ(keeper_.acknowledged(), 3);
  ExpectWhole(path_, 3);
}

TEST_F(DocumentKeeperTest, WhateverWriteFailsFirstTheFileIsWholeAndAnotherPlaceTakesEverything) {
  using Fault = FaultyDisk::Fault;
  for (const Fault fault : {Fault::kFull, Fault::kWriteFails, Fault::kFlushFails}) {
    for (int more = 0; more < 6; ++more) {
      SCOPED_TRACE(more);
      FaultyDisk disk;
      session_ = Session();
      ASSERT_TRUE(keeper_.New(DocumentOf(session_), true));
      Begin();
      disk.Break(fault, more);
      for (int i = 0; i < 5; ++i) Do(kNode);
      EXPECT_EQ(keeper_.status().trouble.has_value(), keeper_.status().unwritten > 0);
      const auto readable = OpenDocument(path_);
      ASSERT_TRUE(readable) << FormatError(readable.error());
      EXPECT_EQ(readable->history.size() + keeper_.status().unwritten, 6u);
      disk.Repair();
      const std::string other = folder_ + "/other.parti";
      SaveAs(other);
      ExpectWhole(other, 6);
      EXPECT_EQ(keeper_.status(), (DocumentStatus{other, true}));
    }
  }
}

TEST_F(DocumentKeeperTest, WhereNoDraftCanBeMadeItIsSaidAndTriedAgain) {
  const std::string in_the_way = folders_.data;
  std::fclose(std::fopen(in_the_way.c_str(), "w"));
  Do("lot rect(20,14)");
  ASSERT_TRUE(keeper_.status().trouble);
  EXPECT_EQ(keeper_.acknowledged(), 0);
  fs::remove(in_the_way);
  Do(kNode);
  EXPECT_FALSE(keeper_.status().trouble) << keeper_.status().trouble->message;
  EXPECT_EQ(keeper_.acknowledged(), 2);
  ExpectWhole(keeper_.status().path, 2);
}

TEST_F(DocumentKeeperTest, ADeletedFileIsSaidAndAnotherPlaceTakesEverything) {
  Begin();
  fs::remove(path_);
  Do(kNode);
  ASSERT_TRUE(keeper_.status().trouble);
  EXPECT_THAT(keeper_.status().trouble->message, HasSubstr("is gone"));
  EXPECT_EQ(keeper_.acknowledged(), 1);
  SaveAs(path_);
  ExpectWhole(path_, 2);
  Do("undo");
  ExpectWhole(path_, 3);
}

TEST_F(DocumentKeeperTest, AFileThatGoesWhileNothingIsDoneIsSaidToo) {
  Begin();
  keeper_.TryAgain();
  EXPECT_FALSE(keeper_.status().trouble);
  fs::rename(path_, path_ + ".moved");
  keeper_.TryAgain();
  ASSERT_TRUE(keeper_.status().trouble);
  EXPECT_THAT(keeper_.status().trouble->message, HasSubstr("is gone"));
  EXPECT_FALSE(keeper_.MayLeave(false));
  fs::rename(path_ + ".moved", path_);
  keeper_.TryAgain();
  EXPECT_FALSE(keeper_.status().trouble) << "it was put back";
  EXPECT_TRUE(keeper_.MayLeave(false));
}

TEST_F(DocumentKeeperTest, WhatWasWrittenIntoAFileThatIsGoneIsRescuedWhole) {
  Begin();
  Do(kNode);
  fs::remove(path_);
  ASSERT_TRUE(keeper_.Rescue(DocumentOf(session_), {}));
  EXPECT_EQ(keeper_.status().rescued_from, path_);
  ASSERT_THAT(DraftsIn(folders_.data), SizeIs(1));
  ExpectWhole(DraftsIn(folders_.data)[0], 2);
}

TEST_F(DocumentKeeperTest, ADocumentThatTookThePlaceIsNotReadWithTheOldOnesLog) {
  Begin();
  Do(kNode);
  Session other;
  ASSERT_TRUE(SaveDocument(DocumentOf(other), path_ + ".new"));
  const auto bytes = ReadFile(path_ + ".new");
  fs::rename(path_ + ".new", path_);
  ASSERT_TRUE(keeper_.Rescue(DocumentOf(session_), {}));
  EXPECT_FALSE(fs::exists(path_ + "-wal"));
  const auto now = OpenDocument(path_);
  ASSERT_TRUE(now) << FormatError(now.error());
  EXPECT_THAT(now->history, IsEmpty());
  EXPECT_EQ(*ReadFile(path_), *bytes);
  ExpectWhole(keeper_.status().path, 2);
}

TEST_F(DocumentKeeperTest, AFileThatWasReplacedIsNotWrittenOver) {
  Begin();
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_ + ".new"));
  fs::rename(path_ + ".new", path_);
  Do(kNode);
  ASSERT_TRUE(keeper_.status().trouble);
  EXPECT_THAT(OpenDocument(path_)->history, IsEmpty());
}

TEST_F(DocumentKeeperTest, ASecondInstanceReadsAndIsToldWhoWrites) {
  Begin();
  DocumentKeeper second(folders_);
  const auto seen = second.Open(path_, false);
  ASSERT_TRUE(seen) << FormatError(seen.error());
  EXPECT_TRUE(second.status().read_only);
  ASSERT_TRUE(second.status().trouble);
  EXPECT_THAT(second.status().trouble->message, HasSubstr("is open in another Parti"));
  Do(kNode);  // the first goes on
  EXPECT_FALSE(keeper_.status().trouble);
  // What the second does stays with it, on what it saw, until it has a file of its own.
  auto session = *SessionOf(*seen, {});
  ASSERT_TRUE(session.Execute(*ParseCommand("node .Lot --> extrude(3) Shed")));
  const Timeline::Span span = session.timeline().span();
  second.Apply({{1, nullptr, "node .Lot --> extrude(3) Shed",
                 session.timeline().step(span.now).record, span}});
  EXPECT_EQ(second.status().unwritten, 1u);
  ExpectWhole(path_, 2);
  const std::string other = folder_ + "/shed.parti";
  ASSERT_TRUE(second.SaveAs(other, {}));
  EXPECT_FALSE(second.status().read_only);
  EXPECT_THAT(grammar::TextOf(*PresentOf(*OpenDocument(other)).rules), HasSubstr("Shed"));
}

TEST_F(DocumentKeeperTest, WhenTheFirstInstanceHasGoneTheSecondMayWrite) {
  Begin();
  DocumentKeeper second(folders_);
  ASSERT_TRUE(keeper_.New(DocumentOf(Session()), false));
  ASSERT_TRUE(second.Open(path_, false));
  EXPECT_FALSE(second.status().read_only);
}

TEST_F(DocumentKeeperTest, WhatIsNoDocumentIsRefusedAndStaysAsItIs) {
  {
    auto other = Database::Open(path_, Database::Mode::kCreate);
    ASSERT_TRUE(other);
    ASSERT_TRUE(other->Execute("PRAGMA journal_mode=WAL; CREATE TABLE place(name TEXT)"));
  }
  const auto before = ReadFile(path_);
  EXPECT_FALSE(keeper_.Open(path_, false));
  EXPECT_EQ(*ReadFile(path_), *before);
  const std::string empty = folder_ + "/empty.parti";
  std::fclose(std::fopen(empty.c_str(), "w"));
  EXPECT_FALSE(keeper_.Open(empty, false));
  EXPECT_EQ(fs::file_size(empty), 0u);
}

TEST_F(DocumentKeeperTest, AnotherInstancesDocumentIsNotSavedOver) {
  Begin();
  DocumentKeeper second(folders_);
  ASSERT_TRUE(second.New(DocumentOf(Session()), false));
  EXPECT_FALSE(second.SaveAs(path_, DocumentOf(Session())));
  const auto saved = second.SaveAs(path_, DocumentOf(Session()), true);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("is open in"));
  ExpectWhole(path_, 1);
}

/// While one exists, the process has the rights of nobody, if it had those of root.
class AsNobody {
 public:
  AsNobody() { static_cast<void>(::seteuid(::geteuid() == 0 ? 65534 : ::geteuid())); }
  ~AsNobody() { static_cast<void>(::seteuid(::getuid())); }
};

TEST_F(DocumentKeeperTest, AFolderThatMayNotBeWrittenGivesAReadOnlyDocument) {
  Begin();
  const std::string killed = folder_ + "/shelf/killed.parti";
  fs::create_directory(folder_ + "/shelf");
  Do(kNode);
  fs::copy_file(path_, killed);
  fs::copy_file(path_ + "-wal", killed + "-wal");
  ASSERT_TRUE(keeper_.New(DocumentOf(Session()), false));
  fs::copy_file(path_, folder_ + "/shelf/house.parti");
  for (const char* file : {"house.parti", "killed.parti", "killed.parti-wal", ""}) {
    fs::permissions(folder_ + "/shelf/" + file, fs::perms(*file ? 0444 : 0555));
  }
  fs::permissions(folder_, fs::perms(0755));
  const AsNobody nobody;
  for (const std::string& path : {folder_ + "/shelf/house.parti", killed}) {
    const auto document = keeper_.Open(path, true);
    ASSERT_TRUE(document) << FormatError(document.error());
    EXPECT_THAT(document->history, SizeIs(2)) << path;
    EXPECT_TRUE(keeper_.status().read_only);
    EXPECT_THAT(keeper_.status().trouble->hint, HasSubstr("save it as another file"));
  }
}

TEST_F(DocumentKeeperTest, ClosingADocumentThatWasReplacedLeavesTheNewOneAlone) {
  Begin();
  ASSERT_TRUE(SaveDocument(DocumentOf(session_), path_ + ".new"));
  fs::rename(path_ + ".new", path_);
  DocumentKeeper other(folders_);
  const auto document = other.Open(path_, false);
  ASSERT_TRUE(document);
  EXPECT_FALSE(other.status().read_only);
  auto session = *SessionOf(*document, {});
  ASSERT_TRUE(session.Execute(*ParseCommand(kNode)));
  const Timeline::Span span = session.timeline().span();
  other.Apply({{1, nullptr, kNode, session.timeline().step(span.now).record, span}});
  ASSERT_TRUE(keeper_.New(DocumentOf(session_), true));
  EXPECT_THAT(OpenDocument(path_)->history, SizeIs(1));
}

TEST_F(DocumentKeeperTest, WhatIsNotOnTheDiskIsNotLeftBehindWithoutAWord) {
  FaultyDisk disk;
  Begin();
  disk.Break(FaultyDisk::Fault::kFull);
  Do(kNode);
  EXPECT_FALSE(keeper_.New(DocumentOf(Session()), false));
  EXPECT_FALSE(keeper_.Open(path_ + "x", false));
  EXPECT_EQ(keeper_.status().unwritten, 1u);
  EXPECT_TRUE(keeper_.New(DocumentOf(Session()), true));
}

TEST_F(DocumentKeeperTest, WhatCannotBeWrittenIsRescuedAsADraft) {
  Begin();
  fs::remove(path_);
  Do(kNode);
  ASSERT_TRUE(keeper_.Rescue(DocumentOf(session_), {{2, {kNode}}, {3, {"set distance 7"}}}));
  EXPECT_EQ(keeper_.status().rescued_from, path_);
  EXPECT_FALSE(keeper_.status().named);
  EXPECT_EQ(keeper_.status().unwritten, 0u);
  EXPECT_THAT(DraftsIn(folders_.data), ElementsAre(keeper_.status().path));
  ExpectWhole(keeper_.status().path, 2);
  const auto kept = OpenDocument(keeper_.status().path);
  ASSERT_THAT(kept->posted, SizeIs(1)) << "the second is done";
  EXPECT_EQ(kept->posted[0].command, "set distance 7");
  number_ = 2;
  Do("set distance 7");  // after all: the process has not ended yet
  EXPECT_THAT(OpenDocument(keeper_.status().path)->posted, IsEmpty());
}

TEST_F(DocumentKeeperTest, WhatIsWrittenNeedsNoRescue) {
  FaultyDisk disk;
  Begin();
  disk.Break(FaultyDisk::Fault::kFull);
  Do(kNode);
  disk.Repair();
  ASSERT_TRUE(keeper_.Rescue(DocumentOf(session_), {}));
  EXPECT_EQ(keeper_.status(), (DocumentStatus{path_, true}));
  ExpectWhole(path_, 2);
  EXPECT_THAT(DraftsIn(folders_.data), IsEmpty());
}

TEST_F(DocumentKeeperTest, AFailedSaveAsChangesNothing) {
  Begin();
  const DocumentStatus before = keeper_.status();
  EXPECT_FALSE(keeper_.SaveAs(folder_ + "/no/such/folder/x.parti", DocumentOf(session_)));
  EXPECT_FALSE(keeper_.Open(folder_ + "/missing.parti", false));
  EXPECT_EQ(keeper_.status(), before);
  Do(kNode);
  ExpectWhole(path_, 2);
}

TEST_F(DocumentKeeperTest, MemoryDoesNotGrowPastTheUndoLimitWhileTheDiskIsFull) {
  session_ = Session(SessionOptions{.undo = {.steps = 5}});
  FaultyDisk disk;
  ASSERT_TRUE(keeper_.New(DocumentOf(session_), false));
  Begin();
  disk.Break(FaultyDisk::Fault::kFull);
  for (int i = 0; i < 40; ++i) Do(i % 2 == 0 ? kNode : "undo");
  for (int i = 0; i < 20; ++i) Do(kNode);
  disk.Repair();
  keeper_.TryAgain();
  ExpectWhole(path_, 61);
}

TEST_F(DocumentKeeperTest, OfWhatAKillLeftOverOnlyWhatEndsTheProgramIsLaidAsideTheThirdTime) {
  Begin();
  keeper_.Keep({{7, {kNode}}, {9, {"", StrokeFrom("1,2 3,4")}}});
  const std::string killed = folder_ + "/killed.parti";
  fs::copy_file(path_, killed);
  fs::copy_file(path_ + "-wal", killed + "-wal");
  for (int time = 0; time < 2; ++time) {
    DocumentKeeper next(folders_);
    const auto document = next.Open(killed, false);
    ASSERT_TRUE(document);
    ASSERT_THAT(document->posted, SizeIs(2)) << time;
    EXPECT_EQ(document->posted[0].command, kNode);
    EXPECT_EQ(document->posted[1].stroke, StrokeFrom("1,2 3,4"));
    EXPECT_THAT(document->laid_aside, IsEmpty());
    EXPECT_EQ(document->posted[0].begun, time);
    if (time > 0) next.BeginLeftOver(0);  // and it is killed
  }
  DocumentKeeper third(folders_);
  const auto document = third.Open(killed, false);
  ASSERT_TRUE(document);
  ASSERT_THAT(document->posted, SizeIs(1));
  EXPECT_EQ(document->posted[0].command, kNode);
  ASSERT_THAT(document->laid_aside, SizeIs(1));
  EXPECT_EQ(document->laid_aside[0].stroke, StrokeFrom("1,2 3,4"));
  third.BeginLeftOver(0);
  third.Apply({{0}});
  third.Keep({{1, {"take none"}}});
  third.Apply({{1}});
  ASSERT_TRUE(third.SaveAs(folder_ + "/other.parti", {}));
  for (const std::string& path : {killed, folder_ + "/other.parti"}) {
    const auto after = OpenDocument(path);
    ASSERT_TRUE(after) << FormatError(after.error());
    EXPECT_THAT(after->posted, IsEmpty()) << path;
    ASSERT_THAT(after->laid_aside, SizeIs(1)) << path;
    EXPECT_EQ(after->laid_aside[0].stroke, StrokeFrom("1,2 3,4"));
    EXPECT_EQ(after->laid_aside[0].begun, 0) << "it was said once";
  }
}

}  // namespace
}  // namespace parti::app
