// Documents that are damaged, foreign or newer; tests/pen/house_test.cc has the whole house there
// and back.
#include "app/document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/sqlite.h"
#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

Document Tower() {
  Document document;
  document.lots = *ParseLots("poly(0,0 12.3,0 12.3,9 4,11.1)");
  document.trees = *grammar::ParseTrees("tree t { .Lot --> extrude(7.25) Mass }");
  document.strokes = {{StrokeFrom("1,2 3,4"), Camera{}}};
  document.history = {"lot poly(0,0 12.3,0 12.3,9 4,11.1)", "stroke 0", "pick 1 extrude"};
  return document;
}

class DocumentTest : public ::testing::Test {
 protected:
  DocumentTest() : path_(tests::TestFolder() + "/tower.parti") {
    EXPECT_TRUE(SaveDocument(Tower(), path_));
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
  const Document saved = Tower();
  ASSERT_THAT(opened->lots, SizeIs(1));
  EXPECT_EQ(opened->lots[0].name, saved.lots[0].name);
  EXPECT_EQ(opened->lots[0].origin, saved.lots[0].origin);
  EXPECT_EQ(opened->lots[0].item.scope.origin, saved.lots[0].item.scope.origin);
  EXPECT_EQ(opened->lots[0].item.scope.x, saved.lots[0].item.scope.x);
  EXPECT_EQ(opened->lots[0].item.scope.size, saved.lots[0].item.scope.size);
  EXPECT_EQ(*opened->lots[0].item.polygon, *saved.lots[0].item.polygon);
  EXPECT_EQ(opened->trees, saved.trees);
  EXPECT_EQ(opened->view, saved.view);
  EXPECT_EQ(opened->history, saved.history);
  ASSERT_THAT(opened->strokes, SizeIs(1));
  EXPECT_EQ(opened->strokes[0].stroke, saved.strokes[0].stroke);
}

TEST_F(DocumentTest, SavingTheSameGivesTheSameBytesAndReplacesTheOldFile) {
  const auto before = ReadFile(path_);
  ASSERT_TRUE(SaveDocument(Tower(), path_));
  EXPECT_EQ(*ReadFile(path_), *before);
}

TEST_F(DocumentTest, AnotherProgramsDatabaseIsRefused) {
  Change("PRAGMA application_id = 7");
  EXPECT_THAT(Refused().message, HasSubstr("not Parti's"));
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
       {"DROP TABLE stroke", "UPDATE rules SET text = 'tree t { .Lot --> exrtude(3) }'",
        "UPDATE lot SET item = '{'", "UPDATE lot SET source_origin = 'here'",
        "UPDATE view SET camera = '{}'", "UPDATE stroke SET samples = x'00'"}) {
    ASSERT_TRUE(SaveDocument(Tower(), path_));
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

TEST_F(DocumentTest, AFileThatIsNotThereIsNoDamage) {
  path_ += ".missing";
  EXPECT_EQ(Refused().code, ErrorCode::kFile);
  EXPECT_FALSE(LooksLikeDocument(path_));
}

TEST_F(DocumentTest, AFailedSaveLeavesTheOldDocument) {
  const std::string folder = path_ + ".folder";
  ASSERT_EQ(::mkdir(folder.c_str(), 0700), 0);
  ASSERT_TRUE(WriteFile(folder + "/x", "in the way"));
  const auto saved = SaveDocument(Tower(), folder);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().code, ErrorCode::kFile);
  EXPECT_TRUE(ReadFile(folder + "/x"));
}

}  // namespace
}  // namespace parti::app
