#include "app/document_migration.h"

#include <fmt/format.h>

#include "app/document_record.h"
#include "app/document_values.h"

namespace parti::app {
namespace {

/// A value of the first row.
Result<std::string> FirstText(Database* database, std::string_view sql) {
  auto statement = database->Prepare(sql);
  if (!statement) return Fail(statement);
  const auto row = statement->Step();
  if (!row) return Fail(row);
  if (!*row) return Fail(ErrorCode::kDamagedFile, fmt::format("nothing comes of {}", sql));
  return statement->Text(0);
}

/// The lots of version 1, as the text that they are in version 2.
Result<std::string> LotsOfVersion1(Database* database) {
  auto statement = database->Prepare("SELECT name, item, source_origin FROM lot ORDER BY id");
  if (!statement) return Fail(statement);
  std::vector<Lot> lots;
  while (true) {
    const auto row = statement->Step();
    if (!row) return Fail(row);
    if (!*row) return LotsText(lots);
    auto item = PlanarItemFrom(statement->Text(1));
    if (!item) return Fail(item);
    Lot lot{statement->Text(0), std::move(*item), {}};
    if (std::sscanf(statement->Text(2).c_str(), "%lf %lf", &lot.origin.x, &lot.origin.y) != 2) {
      return Fail(ErrorCode::kBadText, "a lot has no origin");
    }
    lots.push_back(std::move(lot));
  }
}

/// Version 1 kept what there was, but nothing of how it had come to be: one state.
Result<StateParts> StateOfVersion1(Database* database) {
  const auto lots = LotsOfVersion1(database);
  if (!lots) return Fail(lots);
  const auto rules = FirstText(database, "SELECT text FROM rules");
  if (!rules) return Fail(rules);
  const auto view = FirstText(database, "SELECT camera FROM view WHERE name = 'last'");
  if (!view) return Fail(view);
  StateParts parts;
  parts["lots"] = std::make_shared<const std::string>(*lots);
  parts["rules"] = std::make_shared<const std::string>(*rules);
  parts["view"] = std::make_shared<const std::string>(*view);
  return parts;
}

/// Version 1 becomes version 2, whose tables are still those of today. Strokes and history are the
/// same in both, under other names here so that the new tables can be made as for a new document.
Result<void> From1To2(Database* database) {
  const auto state = StateOfVersion1(database);
  if (!state) return Fail(state);
  auto done = database->Execute(
      "ALTER TABLE stroke RENAME TO old_stroke; ALTER TABLE history RENAME TO old_history;"
      "DROP TABLE lot; DROP TABLE rules; DROP TABLE view;");
  if (done) done = MakeTables(database);
  if (done) {
    done = database->Execute(
        "INSERT INTO stroke SELECT id, camera, samples FROM old_stroke;"
        "INSERT INTO history SELECT id, command FROM old_history;"
        "DROP TABLE old_stroke; DROP TABLE old_history;");
  }
  if (done) done = WriteState(database, {0, 0, 0}, *state);
  return done;
}

/// Version 3 is version 2 with states that may have a source: one that has none is the same in
/// both.
Result<void> From2To3(Database* database) {
  return database->Execute(fmt::format("PRAGMA user_version = {}", kDocumentVersion));
}

}  // namespace

Result<void> Migrate(Database* database, const std::string& path) {
  const auto version = VersionOf(database, path);
  if (!version) return Fail(version);
  if (*version == kDocumentVersion) return {};
  auto done = database->Execute("BEGIN IMMEDIATE");
  if (!done) return done;
  done = *version == 1 ? From1To2(database) : From2To3(database);
  if (done) done = database->Execute("COMMIT");
  if (done) return done;
  static_cast<void>(database->Execute("ROLLBACK"));
  if (done.error().code == ErrorCode::kFile) return done;
  return tl::unexpected<Error>(Damaged(path, done.error().message));
}

Result<Document> ReadAnyVersion(Database* database, const std::string& path) {
  const auto version = VersionOf(database, path);
  if (!version) return Fail(version);
  if (*version == kDocumentVersion) return ReadTables(database, path);
  // The file stays as it is: a copy in memory is brought to this version.
  auto copy = database->CopyInMemory();
  if (!copy) return Fail(copy);
  if (const auto done = Migrate(&*copy, path); !done) return Fail(done);
  return ReadTables(&*copy, path);
}

}  // namespace parti::app
