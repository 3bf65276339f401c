// Documents that are damaged, foreign or newer; tests/pen/house_test.cc has the whole house there
// and back.
#include "app/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <map>

#include "app/document_lock.h"
#include "app/document_record.h"
#include "app/sqlite.h"
#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Every part of a state, as it is in the file.
std::map<std::string, std::string> PartsAsText(const SessionRecord& record) {
  std::map<std::string, std::string> parts;
  for (const auto& [name, text] : PartsOf(record)) parts[name] = *text;
  return parts;
}

/// A session with something to undo, something to redo, and a stroke.
Session Tower() {
  Session session;
  EXPECT_TRUE(session.Execute(*ParseCommand("lot poly(0,0 12.3,0 12.3,9 4,11.1)")));
  EXPECT_TRUE(session.Execute(*ParseCommand("node .Lot --> extrude(7.25) Mass")));
  EXPECT_TRUE(session.Execute(*ParseCommand("keep-view from \"the\" street")));
  static_cast<void>(session.AddStroke(StrokeFrom("1,2 3,4")));  // means nothing: it stays as ink
  EXPECT_TRUE(session.Execute(*ParseCommand("node .Mass --> comp(f) { all: Face }")));
  EXPECT_TRUE(session.Execute(*ParseCommand("undo")));
  return session;
}

void ExpectSame(const SessionRecord& a, const SessionRecord& b) {
  EXPECT_EQ(PartsAsText(a), PartsAsText(b));
}

class DocumentTest : public ::testing::Test {
 protected:
  DocumentTest() : path_(tests::TestFolder() + "/tower.parti") {
    EXPECT_TRUE(SaveDocument(DocumentOf(Tower()), path_));
  }
  void Change(const std::string& sql) {
    auto database = Database::Open(path_, Database::Mode::kCreate);
    ASSERT_TRUE(database);
    ASSERT_TRUE(database->Execute(sql));
  }
  Error Refused() {
    const auto opened = OpenDocument(path_);
    EXPECT_FALSE(opened);
    return opened ? Error{ErrorCode::kNothingMade, ""} : opened.error();
  }

  std::string path_;
};

TEST_F(DocumentTest, ReopensAsItWas) {
  const auto opened = OpenDocument(path_);
  ASSERT_TRUE(opened) << FormatError(opened.error());
  const Document saved = DocumentOf(Tower());
  EXPECT_EQ(opened->history, saved.history);
  EXPECT_EQ(opened->span, saved.span);
  ASSERT_THAT(opened->strokes, SizeIs(1));
  EXPECT_EQ(opened->strokes[0]->stroke, saved.strokes[0]->stroke);
  ASSERT_THAT(opened->states, SizeIs(saved.states.size()));
  for (size_t i = 0; i < saved.states.size(); ++i) ExpectSame(opened->states[i], saved.states[i]);
}

TEST_F(DocumentTest, UndoAndRedoGoOnWhereTheyWere) {
  auto session = SessionOf(*OpenDocument(path_), {});
  ASSERT_TRUE(session);
  const auto rules = [&] { return grammar::TextOf(session->state().model.trees()); };
  const std::string now = rules();
  EXPECT_TRUE(session->Execute(Redo{}));
  EXPECT_THAT(rules(), HasSubstr("comp"));
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(session->Execute(Undo{})) << i;
  EXPECT_THAT(session->state().model.lots(), SizeIs(0));
  EXPECT_FALSE(session->Execute(Undo{}));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(session->Execute(Redo{}));
  EXPECT_EQ(rules(), now);
  EXPECT_THAT(session->state().sketch.unread, SizeIs(1));
}

TEST_F(DocumentTest, ADocumentThatSomeoneHasOpenIsNotReplaced) {
  const auto lock = DocumentLock::Take(path_);
  ASSERT_TRUE(lock);
  const auto saved = SaveDocument(DocumentOf(Tower()), path_);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("is open in this Parti"));
}

TEST_F(DocumentTest, ALinkStaysALink) {
  const std::string link = path_ + ".link";
  ASSERT_EQ(::symlink(path_.c_str(), link.c_str()), 0);
  std::remove((path_ + ".other").c_str());
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), link));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_THAT(OpenDocument(path_)->history, SizeIs(0));
}

TEST_F(DocumentTest, ALogLeftByAKillDoesNotGetIntoTheDocumentThatTakesItsPlace) {
  {
    auto killed = Database::Open(path_, Database::Mode::kWrite);
    ASSERT_TRUE(killed);
    ASSERT_TRUE(
        killed->Execute("PRAGMA journal_mode=WAL; INSERT INTO history(command) VALUES('x')"));
    std::filesystem::copy_file(path_ + "-wal", path_ + ".wal");
    std::filesystem::copy_file(path_, path_ + ".db");
  }
  std::filesystem::rename(path_ + ".db", path_);
  std::filesystem::rename(path_ + ".wal", path_ + "-wal");
  ASSERT_THAT(OpenDocument(path_)->history.back(), "x") << "the log is part of the old document";
  ASSERT_TRUE(SaveDocument(DocumentOf(Tower()), path_));
  EXPECT_EQ(OpenDocument(path_)->history, DocumentOf(Tower()).history);
}

TEST_F(DocumentTest, AJournalLeftByAKillDoesNotGetIntoTheDocumentThatTakesItsPlace) {
  {
    auto killed = Database::Open(path_, Database::Mode::kWrite);
    ASSERT_TRUE(killed);
    // A cache of one page: the change is written before it is committed, and the journal is hot.
    ASSERT_TRUE(
        killed->Execute("PRAGMA cache_size=1; BEGIN; UPDATE text SET body = body || 'x';"
                        "INSERT INTO history(command) VALUES(zeroblob(100000))"));
    std::filesystem::copy_file(path_ + "-journal", path_ + ".journal");
    std::filesystem::copy_file(path_, path_ + ".db");
    ASSERT_TRUE(killed->Execute("ROLLBACK"));
  }
  std::filesystem::rename(path_ + ".db", path_);
  std::filesystem::rename(path_ + ".journal", path_ + "-journal");
  const auto saved = DocumentOf(Tower());
  const auto rolled_back = OpenDocument(path_);
  ASSERT_TRUE(rolled_back) << FormatError(rolled_back.error());
  EXPECT_EQ(rolled_back->history, saved.history);
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_));
  EXPECT_FALSE(std::filesystem::exists(path_ + "-journal"));
  EXPECT_EQ(OpenDocument(path_)->history.size(), 0u);
}

TEST_F(DocumentTest, OneThatWasClosedProperlyCanBeReadWhereNothingCanBeWritten) {
  const auto alone = Database::Open(path_, Database::Mode::kReadAlone);
  ASSERT_TRUE(alone);
}

TEST_F(DocumentTest, SavingTheSameGivesTheSameBytesAndReplacesTheOldFile) {
  const auto before = ReadFile(path_);
  ASSERT_TRUE(SaveDocument(DocumentOf(Tower()), path_));
  EXPECT_EQ(*ReadFile(path_), *before);
}

TEST_F(DocumentTest, AnotherProgramsDatabaseIsRefused) {
  Change("PRAGMA application_id = 7");
  EXPECT_THAT(Refused().message, HasSubstr("not Parti's"));
}

TEST_F(DocumentTest, AnEmptyFileIsCalledSo) {
  ASSERT_TRUE(WriteFile(path_, ""));
  EXPECT_THAT(Refused().message, HasSubstr("tower.parti is empty"));
}

TEST_F(DocumentTest, ANewerFormatIsRefusedAndSaysWhatToDo) {
  Change("PRAGMA user_version = 99");
  const Error error = Refused();
  EXPECT_EQ(error.code, ErrorCode::kDamagedFile);
  EXPECT_THAT(error.message, HasSubstr("newer"));
  EXPECT_THAT(error.hint, HasSubstr("update"));
}

TEST_F(DocumentTest, DamagedContentsAreRefusedAndNamed) {
  for (const char* sql :
       {"DROP TABLE stroke", "UPDATE text SET body = 'tree t { .Lot --> exrtude(3) }'",
        "UPDATE text SET body = '{'", "UPDATE text SET body = '[]'", "UPDATE text SET body = '[1]'",
        "DELETE FROM text", "DELETE FROM part WHERE place = 1", "DELETE FROM present",
        "UPDATE present SET place = 77", "DELETE FROM part WHERE name = 'view'",
        "DELETE FROM stroke", "UPDATE stroke SET samples = x'00'",
        "INSERT INTO posted(number, command, samples) VALUES(1, '', x'00')"}) {
    ASSERT_TRUE(SaveDocument(DocumentOf(Tower()), path_));
    Change(sql);
    const Error error = Refused();
    EXPECT_EQ(error.code, ErrorCode::kDamagedFile) << sql;
    EXPECT_THAT(error.message, HasSubstr("tower.parti")) << sql;
  }
}

TEST_F(DocumentTest, WhatIsNoDatabaseIsRefused) {
  ASSERT_TRUE(WriteFile(path_, "SQLite format 3, or so it says"));
  EXPECT_EQ(Refused().code, ErrorCode::kDamagedFile);
  ASSERT_TRUE(WriteFile(path_, "tree t { }"));
  EXPECT_EQ(Refused().code, ErrorCode::kDamagedFile);
  EXPECT_FALSE(LooksLikeDocument(path_));
}

TEST_F(DocumentTest, RulesAndDrawingsAreNoDocumentsAndNotCalledDamaged) {
  for (const auto& [ending, remedy] :
       {std::pair(".cga", "parti derive '"), std::pair(".pen", "parti replay '"),
        std::pair(".parti", "a copy of it from before it was damaged")}) {
    const std::string path = path_ + ending;
    ASSERT_TRUE(WriteFile(path, "Lot --> extrude(3) Mass\n"));
    const auto opened = OpenDocument(path);
    ASSERT_FALSE(opened);
    EXPECT_TRUE(opened.error().message.ends_with(ending + std::string(" is no Parti document")))
        << opened.error().message;
    EXPECT_THAT(opened.error().hint, HasSubstr(remedy));
  }
}

TEST_F(DocumentTest, AFileThatIsNotThereIsNoDamage) {
  path_ += ".missing";
  EXPECT_EQ(Refused().code, ErrorCode::kFile);
  EXPECT_FALSE(LooksLikeDocument(path_));
}

TEST_F(DocumentTest, AFailedSaveLeavesTheOldDocument) {
  const std::string folder = path_ + ".folder";
  ASSERT_EQ(::mkdir(folder.c_str(), 0700), 0);
  ASSERT_TRUE(WriteFile(folder + "/x", "in the way"));
  const auto saved = SaveDocument(DocumentOf(Tower()), folder);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::kFile);
  EXPECT_TRUE(ReadFile(folder + "/x"));
}

TEST_F(DocumentTest, AFolderAndAPipeAreCalledSoAndNotWaitedFor) {
  const auto folder = OpenDocument(tests::TestFolder());
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().message, HasSubstr("is a folder"));
  const std::string pipe = path_ + ".pipe.parti";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(OpenDocument(pipe));
}

TEST_F(DocumentTest, WhatIsNoRegularFileIsLeftAlone) {
  const std::string pipe = path_ + ".pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {pipe, std::string("/dev/null")}) {
    const auto saved = SaveDocument(DocumentOf(Tower()), path);
    ASSERT_FALSE(saved) << path;
    EXPECT_THAT(saved.error().message, HasSubstr("not a regular file"));
  }
}

TEST_F(DocumentTest, AnOldFilesPermissionsStayAndALinkStaysOne) {
  ASSERT_EQ(::chmod(path_.c_str(), 0600), 0);
  ASSERT_TRUE(SaveDocument(DocumentOf(Tower()), path_));
  struct stat now {};
  ASSERT_EQ(::stat(path_.c_str(), &now), 0);
  EXPECT_EQ(now.st_mode & 07777, 0600u);
  const std::string link = path_ + ".link.parti", target = path_ + ".target.parti";
  ASSERT_EQ(::symlink("tower.parti.target.parti", link.c_str()), 0);
  ASSERT_TRUE(SaveDocument(DocumentOf(Tower()), link)) << "to where nothing is yet";
  EXPECT_TRUE(OpenDocument(target));
  ASSERT_EQ(::lstat(link.c_str(), &now), 0);
  EXPECT_TRUE(S_ISLNK(now.st_mode));
}

TEST_F(DocumentTest, WhatCannotBeWrittenHasTheNameThatWasAskedFor) {
  const std::string path = path_ + ".folder/that/is/not/there.parti";
  const auto saved = SaveDocument(DocumentOf(Tower()), path);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("there.parti: "));
}

}  // namespace
}  // namespace parti::app
