// Documents that the programs of formats 1 and 2 saved, the demo's first three strokes:
// tests/app/documents/format_1.parti and format_2.parti.
#include "app/document_migration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "app/document_file.h"
#include "base/text_file.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class DocumentMigrationTest : public ::testing::Test {
 protected:
  DocumentMigrationTest() : path_(tests::TestFolder() + "/old.parti") {
    std::filesystem::copy_file(tests::SourceFile("tests/app/documents/format_1.parti"), path_);
  }
  static void ExpectOldHouse(const Document& document) {
    EXPECT_THAT(document.history, SizeIs(7));
    EXPECT_EQ(document.history.back(), "pick 1 comp");
    EXPECT_THAT(document.strokes, SizeIs(3));
    ASSERT_THAT(document.states, SizeIs(1));
    const SessionRecord& state = document.states[0];
    EXPECT_EQ(grammar::TextOf(*state.rules),
              "tree structure {\n  .Lot --> extrude(19) Mass {\n"
              "    .Mass --> comp(f) { side: Facade | top: Roof }\n  }\n}\n");
    EXPECT_EQ(state.camera.eye, Vec3(42, 17, 47));
    ASSERT_THAT(state.ground->lots, SizeIs(1));
    EXPECT_EQ(state.ground->lots[0].item.scope.size, Vec3(20, 14, 0));
  }

  std::string path_;
};

TEST_F(DocumentMigrationTest, AnOldDocumentIsReadAndStaysAsItIs) {
  const auto bytes = ReadFile(path_);
  const auto document = OpenDocument(path_);
  ASSERT_TRUE(document) << FormatError(document.error());
  ExpectOldHouse(*document);
  EXPECT_EQ(*ReadFile(path_), *bytes);
}

TEST_F(DocumentMigrationTest, OpenedForWritingItBecomesANewOne) {
  { ASSERT_TRUE(DocumentFile::Open(path_)); }
  auto database = Database::Open(path_, Database::Mode::kRead);
  EXPECT_EQ(*VersionOf(&*database, path_), kDocumentVersion);
  const auto document = OpenDocument(path_);
  ASSERT_TRUE(document) << FormatError(document.error());
  ExpectOldHouse(*document);
  auto session = SessionOf(*document, {});
  ASSERT_TRUE(session);
  EXPECT_EQ(session->strokes_drawn(), 3u) << "new strokes get new numbers";
}

TEST_F(DocumentMigrationTest, ADamagedOldDocumentIsRefusedAndStaysAsItIs) {
  for (const char* sql : {"DELETE FROM rules", "UPDATE lot SET item = '{'",
                          "UPDATE lot SET source_origin = 'here'", "DROP TABLE history"}) {
    std::filesystem::copy_file(tests::SourceFile("tests/app/documents/format_1.parti"), path_,
                               std::filesystem::copy_options::overwrite_existing);
    ASSERT_TRUE(Database::Open(path_, Database::Mode::kWrite)->Execute(sql));
    const auto file = DocumentFile::Open(path_);
    ASSERT_FALSE(file.has_value() && OpenDocument(path_).has_value()) << sql;
    if (!file) {
      EXPECT_THAT(file.error().message, HasSubstr("old.parti")) << sql;
    }
  }
}

TEST(DocumentOfFormat2, IsReadAsItIsAndBecomesANewOneWhenWritten) {
  const std::string path = tests::TestFolder() + "/second.parti";
  std::filesystem::copy_file(tests::SourceFile("tests/app/documents/format_2.parti"), path);
  const auto bytes = ReadFile(path);
  const auto old = OpenDocument(path);
  ASSERT_TRUE(old) << FormatError(old.error());
  EXPECT_EQ(*ReadFile(path), *bytes);
  { ASSERT_TRUE(DocumentFile::Open(path)); }
  auto database = Database::Open(path, Database::Mode::kRead);
  EXPECT_EQ(*VersionOf(&*database, path), kDocumentVersion);
  const auto document = OpenDocument(path);
  ASSERT_TRUE(document) << FormatError(document.error());
  EXPECT_EQ(document->history, old->history);
  EXPECT_EQ(document->history.back(), "pick 1 comp");
  ASSERT_EQ(document->states.size(), old->states.size());
  EXPECT_EQ(grammar::TextOf(*PresentOf(*document).rules), grammar::TextOf(*PresentOf(*old).rules));
  EXPECT_EQ(PresentOf(*document).ground->source, nullptr);
}

}  // namespace
}  // namespace parti::app
