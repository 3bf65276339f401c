#include "app/document_tables.h"

#include <fmt/format.h>

#include "app/document.h"
#include "app/document_values.h"

namespace parti::app {
namespace {

// A text is found by its hash, then compared: the same text is never there twice.
// "posted" is what was drawn and asked for but not yet executed; "laid_aside" what ended the
// program whenever it was (document_file.h).
constexpr const char* kSchema = R"(
  CREATE TABLE stroke(id INTEGER PRIMARY KEY, camera TEXT NOT NULL, samples BLOB NOT NULL);
  CREATE TABLE history(id INTEGER PRIMARY KEY, command TEXT NOT NULL);
  CREATE TABLE text(id INTEGER PRIMARY KEY, hash INTEGER NOT NULL, body TEXT NOT NULL);
  CREATE INDEX text_hash ON text(hash);
  CREATE TABLE part(place INTEGER NOT NULL, name TEXT NOT NULL,
                    text INTEGER NOT NULL REFERENCES text(id),
                    PRIMARY KEY(place, name)) WITHOUT ROWID;
  CREATE INDEX part_text ON part(text);
  CREATE TABLE present(id INTEGER PRIMARY KEY CHECK(id = 1), place INTEGER NOT NULL);
  CREATE TABLE posted(number INTEGER PRIMARY KEY, command TEXT NOT NULL, samples BLOB,
                      begun INTEGER NOT NULL DEFAULT 0);
  CREATE TABLE laid_aside(id INTEGER PRIMARY KEY, command TEXT NOT NULL, samples BLOB);
  CREATE VIEW state AS
    SELECT part.place, part.name, text.body FROM part JOIN text ON text.id = part.text;
  CREATE VIEW rules AS
    SELECT body AS text FROM state JOIN present USING(place) WHERE name = 'rules';
)";

/// FNV-1a, 64 bits: the same on every machine.
int64_t HashOf(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return static_cast<int64_t>(hash);
}

int64_t Signed(uint64_t number) { return static_cast<int64_t>(number); }

/// The id of a text, which is inserted where it is not there yet.
Result<int64_t> TextId(Database* database, const std::string& body) {
  auto find = database->Prepare("SELECT id FROM text WHERE hash = ? AND body = ?");
  if (!find) return Fail(find);
  const auto found = find->Bind(1, HashOf(body)).Bind(2, body).Step();
  if (!found) return Fail(found);
  if (*found) return find->Integer(0);
  auto insert = database->Prepare("INSERT INTO text(hash, body) VALUES(?, ?)");
  if (!insert) return Fail(insert);
  if (const auto done = insert->Bind(1, HashOf(body)).Bind(2, body).Run(); !done) return Fail(done);
  return database->last_row();
}

// What the present state replaces, and what lies outside the span.
constexpr std::string_view kGone = "FROM part WHERE place < ?1 OR place = ?2 OR place > ?3";

/// Deletes the parts that go; returns the texts that they had.
Result<std::vector<int64_t>> DropParts(Database* database, const StateSpan& span) {
  std::vector<int64_t> texts;
  auto find = database->Prepare(fmt::format("SELECT DISTINCT text {}", kGone));
  if (!find) return Fail(find);
  find->Bind(1, Signed(span.first)).Bind(2, Signed(span.now)).Bind(3, Signed(span.last));
  while (true) {
    const auto row = find->Step();
    if (!row) return Fail(row);
    if (!*row) break;
    texts.push_back(find->Integer(0));
  }
  auto drop = database->Prepare(fmt::format("DELETE {}", kGone));
  if (!drop) return Fail(drop);
  drop->Bind(1, Signed(span.first)).Bind(2, Signed(span.now)).Bind(3, Signed(span.last));
  if (const auto done = drop->Run(); !done) return Fail(done);
  return texts;
}

Result<void> DropUnused(Database* database, const std::vector<int64_t>& texts) {
  auto drop = database->Prepare(
      "DELETE FROM text WHERE id = ?1 AND NOT EXISTS (SELECT 1 FROM part WHERE text = ?1)");
  if (!drop) return Fail(drop);
  for (const int64_t text : texts) {
    if (auto done = drop->Bind(1, text).Run(); !done) return done;
  }
  return {};
}

}  // namespace

Result<void> MakeTables(Database* database) {
  return database->Execute(fmt::format("PRAGMA application_id={}; PRAGMA user_version={}; {}",
                                       kDocumentApplicationId, kDocumentVersion, kSchema));
}

Result<void> WriteStroke(Database* database, const DrawnStroke& drawn) {
  auto insert = database->Prepare("INSERT INTO stroke(id, camera, samples) VALUES(?,?,?)");
  if (!insert) return Fail(insert);
  return insert->Bind(1, int64_t{drawn.number})
      .Bind(2, JsonOf(drawn.camera))
      .BindBlob(3, BytesOf(drawn.stroke))
      .Run();
}

Result<void> WriteHistory(Database* database, std::string_view command) {
  auto insert = database->Prepare("INSERT INTO history(command) VALUES(?)");
  if (!insert) return Fail(insert);
  return insert->Bind(1, command).Run();
}

Result<void> WritePosted(Database* database, int64_t number, const PostedRequest& request) {
  auto insert =
      database->Prepare("INSERT INTO posted(number, command, samples, begun) VALUES(?,?,?,?)");
  if (!insert) return Fail(insert);
  return insert->Bind(1, number)
      .Bind(2, request.command)
      .BindBlob(3, BytesOf(request.stroke))
      .Bind(4, int64_t{request.begun})
      .Run();
}

Result<void> WritePosted(Database* database, const std::vector<PostedRequest>& requests) {
  auto number = -static_cast<int64_t>(requests.size());
  for (const PostedRequest& request : requests) {
    if (auto done = WritePosted(database, ++number, request); !done) return done;
  }
  return {};
}

Result<void> WriteLaidAside(Database* database, const PostedRequest& request) {
  auto insert = database->Prepare("INSERT INTO laid_aside(command, samples) VALUES(?,?)");
  if (!insert) return Fail(insert);
  return insert->Bind(1, request.command).BindBlob(2, BytesOf(request.stroke)).Run();
}

Result<void> WriteState(Database* database, const StateSpan& span, const StateParts& parts) {
  const auto gone = DropParts(database, span);
  if (!gone) return Fail(gone);
  auto insert = database->Prepare("INSERT INTO part(place, name, text) VALUES(?,?,?)");
  if (!insert) return Fail(insert);
  for (const auto& [name, body] : parts) {
    const auto text = TextId(database, *body);
    if (!text) return Fail(text);
    insert->Bind(1, Signed(span.now)).Bind(2, name).Bind(3, *text);
    if (auto done = insert->Run(); !done) return done;
  }
  auto present = database->Prepare("INSERT OR REPLACE INTO present(id, place) VALUES(1, ?)");
  if (!present) return Fail(present);
  if (auto done = present->Bind(1, Signed(span.now)).Run(); !done) return done;
  return DropUnused(database, *gone);
}

}  // namespace parti::app
