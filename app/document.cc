#include "app/document.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <map>

#include "app/document_values.h"
#include "app/sqlite.h"

namespace parti::app {
namespace {

constexpr const char* kSchema = R"(
  CREATE TABLE lot(id INTEGER PRIMARY KEY, name TEXT NOT NULL, item TEXT NOT NULL,
                   source_origin TEXT NOT NULL);
  CREATE TABLE rules(id INTEGER PRIMARY KEY CHECK(id = 1), text TEXT NOT NULL);
  CREATE TABLE view(id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, camera TEXT NOT NULL);
  CREATE TABLE stroke(id INTEGER PRIMARY KEY, camera TEXT NOT NULL, samples BLOB NOT NULL);
  CREATE TABLE history(id INTEGER PRIMARY KEY, command TEXT NOT NULL);
)";

Error Damaged(const std::string& path, std::string_view what) {
  return {ErrorCode::kDamagedFile, fmt::format("{} is not a whole document: {}", path, what),
          "open a copy of it from before it was damaged"};
}

Result<void> WriteLots(Database* database, const std::vector<Lot>& lots) {
  auto insert = database->Prepare("INSERT INTO lot(id, name, item, source_origin) VALUES(?,?,?,?)");
  if (!insert) return Fail(insert);
  for (size_t i = 0; i < lots.size(); ++i) {
    const Lot& lot = lots[i];
    const auto done = insert->Bind(1, static_cast<int64_t>(i))
                          .Bind(2, lot.name)
                          .Bind(3, JsonOf(lot.item))
                          .Bind(4, fmt::format("{} {}", lot.origin.x, lot.origin.y))
                          .Run();
    if (!done) return done;
  }
  return {};
}

Result<void> WriteStrokes(Database* database, const std::vector<DrawnStroke>& strokes) {
  auto insert = database->Prepare("INSERT INTO stroke(id, camera, samples) VALUES(?,?,?)");
  if (!insert) return Fail(insert);
  for (size_t i = 0; i < strokes.size(); ++i) {
    const auto done = insert->Bind(1, static_cast<int64_t>(i))
                          .Bind(2, JsonOf(strokes[i].camera))
                          .BindBlob(3, BytesOf(strokes[i].stroke))
                          .Run();
    if (!done) return done;
  }
  return {};
}

Result<void> WriteText(Database* database, std::string_view sql,
                       const std::vector<std::string>& texts) {
  auto insert = database->Prepare(sql);
  if (!insert) return Fail(insert);
  for (const std::string& text : texts) {
    if (const auto done = insert->Bind(1, text).Run(); !done) return done;
  }
  return {};
}

Result<void> WriteAll(Database* database, const Document& document) {
  // DELETE journalling in a temporary file that is renamed afterwards: one file, always whole.
  auto done =
      database->Execute(fmt::format("PRAGMA application_id={}; PRAGMA user_version={}; BEGIN; {}",
                                    kDocumentApplicationId, kDocumentVersion, kSchema));
  if (done) done = WriteLots(database, document.lots);
  if (done) {
    done =
        WriteText(database, "INSERT INTO rules(text) VALUES(?)", {grammar::TextOf(document.trees)});
  }
  if (done) {
    done = WriteText(database, "INSERT INTO view(name, camera) VALUES('last', ?)",
                     {JsonOf(document.view)});
  }
  if (done) done = WriteStrokes(database, document.strokes);
  if (done) done = WriteText(database, "INSERT INTO history(command) VALUES(?)", document.history);
  if (done) done = database->Execute("COMMIT");
  return done;
}

Result<int64_t> Pragma(Database* database, const std::string& name) {
  auto statement = database->Prepare("PRAGMA " + name);
  if (!statement) return Fail(statement);
  const auto row = statement->Step();
  if (!row) return Fail(row);
  return statement->Integer(0);
}

Result<void> CheckKind(Database* database, const std::string& path) {
  const auto id = Pragma(database, "application_id");
  if (!id) return Fail(id);
  if (*id != kDocumentApplicationId) {
    return Fail(ErrorCode::kDamagedFile, fmt::format("{} is a database, but not Parti's", path),
                "open a .parti document");
  }
  const auto version = Pragma(database, "user_version");
  if (!version) return Fail(version);
  if (*version > kDocumentVersion) {
    return Fail(ErrorCode::kDamagedFile,
                fmt::format("{} was saved by a newer Parti (format {})", path, *version),
                fmt::format("this one reads formats up to {}: update it", kDocumentVersion));
  }
  if (*version < 1) return tl::unexpected<Error>(Damaged(path, "it has no format number"));
  return {};
}

/// Calls `row` for each row of a query; its failures are reported as damage of the document.
template <typename Row>
Result<void> ForEach(Database* database, const std::string& path, std::string_view sql, Row row) {
  auto statement = database->Prepare(sql);
  if (!statement) return Fail(statement);
  while (true) {
    const auto stepped = statement->Step();
    if (!stepped) return Fail(stepped);
    if (!*stepped) return {};
    const Result<void> read = row(*statement);
    if (!read) return tl::unexpected<Error>(Damaged(path, read.error().message));
  }
}

Result<void> ReadLot(const Statement& row, std::vector<Lot>* lots) {
  auto item = PlanarItemFrom(row.Text(1));
  if (!item) return Fail(item);
  Lot lot;
  lot.name = row.Text(0);
  lot.item = std::move(*item);
  if (std::sscanf(row.Text(2).c_str(), "%lf %lf", &lot.origin.x, &lot.origin.y) != 2) {
    return Fail(ErrorCode::kBadText, "a lot has no origin");
  }
  lots->push_back(std::move(lot));
  return {};
}

Result<void> ReadStroke(const Statement& row, std::vector<DrawnStroke>* strokes) {
  const auto camera = CameraFrom(row.Text(0));
  if (!camera) return Fail(camera);
  auto stroke = StrokeFromBytes(row.Text(1));
  if (!stroke) return Fail(stroke);
  strokes->push_back({std::move(*stroke), *camera});
  return {};
}

Result<void> ReadRules(const Statement& row, grammar::Trees* trees) {
  auto parsed = grammar::ParseTrees(row.Text(0));
  if (!parsed) return tl::unexpected<Error>(parsed.error().front());
  *trees = std::move(*parsed);
  return {};
}

Result<void> ReadView(const Statement& row, Camera* view) {
  const auto camera = CameraFrom(row.Text(0));
  if (!camera) return Fail(camera);
  *view = *camera;
  return {};
}

}  // namespace

Document DocumentOf(const Session& session) {
  const SessionState& state = session.state();
  Document document;
  document.lots = state.model.lots();
  document.trees = state.model.trees();
  document.view = state.camera;
  for (const HistoryEntry& entry : session.history()) {
    if (entry.command) {
      document.history.push_back(TextOf(*entry.command));
    } else {
      document.history.push_back(fmt::format("stroke {}", document.strokes.size()));
      document.strokes.push_back(*entry.stroke);
    }
  }
  return document;
}

Result<void> SaveDocument(const Document& document, const std::string& path) {
  const std::string temporary = fmt::format("{}.{}.tmp", path, ::getpid());
  std::remove(temporary.c_str());
  auto done = [&]() -> Result<void> {
    auto database = Database::Open(temporary, Database::Mode::kCreate);
    if (!database) return Fail(database);
    return WriteAll(&*database, document);
  }();
  if (done && std::rename(temporary.c_str(), path.c_str()) != 0) {
    done = Fail(ErrorCode::kFile, fmt::format("can't write {}: {}", path, std::strerror(errno)),
                "check that the name is not a folder's");
  }
  if (!done) std::remove(temporary.c_str());
  return done;
}

Result<Document> OpenDocument(const std::string& path) {
  auto database = Database::Open(path, Database::Mode::kRead);
  if (!database) return Fail(database);
  auto done = CheckKind(&*database, path);
  Document document;
  const auto read = [&](std::string_view sql, auto row) {
    if (done) done = ForEach(&*database, path, sql, row);
  };
  read("SELECT name, item, source_origin FROM lot ORDER BY id",
       [&](const Statement& row) { return ReadLot(row, &document.lots); });
  read("SELECT text FROM rules",
       [&](const Statement& row) { return ReadRules(row, &document.trees); });
  read("SELECT camera FROM view WHERE name = 'last'",
       [&](const Statement& row) { return ReadView(row, &document.view); });
  read("SELECT camera, samples FROM stroke ORDER BY id",
       [&](const Statement& row) { return ReadStroke(row, &document.strokes); });
  read("SELECT command FROM history ORDER BY id", [&](const Statement& row) -> Result<void> {
    document.history.push_back(row.Text(0));
    return {};
  });
  if (!done) return Fail(done);
  return document;
}

bool LooksLikeDocument(const std::string& path) {
  char head[16] = {};
  std::ifstream in(path, std::ios::binary);
  return in.read(head, sizeof head) && std::memcmp(head, "SQLite format 3", sizeof head) == 0;
}

}  // namespace parti::app
