#include "app/document_reading.h"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <unordered_map>

#include "app/document_record.h"
#include "app/document_values.h"

namespace parti::app {
namespace {

/// Reads rows from one table after the other; stops at the first failure.
struct TableReader {
  Database* database;
  const std::string& path;
  Result<void> result = {};

  using Row = std::function<Result<void>(const Statement&)>;

  /// Calls `row` for each row of a query; its failures are reported as damage of the document.
  void Read(std::string_view sql, const Row& row) {
    if (result) result = ReadAll(sql, row);
  }

 private:
  Result<void> ReadAll(std::string_view sql, const Row& row) {
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
};

Result<void> ReadStroke(const Statement& row, Document* document) {
  const auto camera = CameraFrom(row.Text(1));
  if (!camera) return Fail(camera);
  auto stroke = StrokeFromBytes(row.Text(2));
  if (!stroke) return Fail(stroke);
  document->strokes.push_back(std::make_shared<const DrawnStroke>(
      DrawnStroke{std::move(*stroke), *camera, static_cast<uint32_t>(row.Integer(0))}));
  return {};
}

Result<void> ReadPosted(const Statement& row, std::vector<PostedRequest>* requests) {
  auto stroke = StrokeFromBytes(row.Text(1));
  if (!stroke) return Fail(stroke);
  requests->push_back({row.Text(0), std::move(*stroke), static_cast<int>(row.Integer(2))});
  return {};
}

/// The parts of the states, by the states' numbers.
using AllParts = std::map<int64_t, StateParts>;

Result<void> ReadPart(const Statement& row, const std::unordered_map<int64_t, SharedText>& texts,
                      AllParts* states) {
  const auto text = texts.find(row.Integer(2));
  if (text == texts.end()) {
    return Fail(ErrorCode::kDamagedFile,
                fmt::format("a text of state {} is missing", row.Integer(0)));
  }
  (*states)[row.Integer(0)][row.Text(1)] = text->second;
  return {};
}

/// States come in order and without gaps.
Result<void> ReadStates(const AllParts& all, Document* document) {
  RecordReader::Strokes strokes;
  for (const auto& drawn : document->strokes) strokes[drawn->number] = drawn;
  RecordReader reader(std::move(strokes));
  for (uint64_t number = document->span.first; number <= document->span.last; ++number) {
    const auto parts = all.find(static_cast<int64_t>(number));
    if (parts == all.end()) {
      return Fail(ErrorCode::kDamagedFile, fmt::format("state {} is missing", number));
    }
    auto record = reader.Read(parts->second);
    if (!record) return Fail(record);
    document->states.push_back(std::move(*record));
  }
  return {};
}

Result<Document> ReadAll(Database* database, const std::string& path) {
  const auto span = SpanIn(database, path);
  if (!span) return Fail(span);
  Document document;
  document.span = *span;
  std::unordered_map<int64_t, SharedText> texts;
  AllParts states;
  TableReader reader{database, path};
  reader.Read("SELECT id, camera, samples FROM stroke ORDER BY id",
              [&](const Statement& row) { return ReadStroke(row, &document); });
  reader.Read("SELECT command FROM history ORDER BY id", [&](const Statement& row) -> Result<void> {
    document.history.push_back(row.Text(0));
    return {};
  });
  reader.Read("SELECT id, body FROM text", [&](const Statement& row) -> Result<void> {
    texts[row.Integer(0)] = std::make_shared<const std::string>(row.Text(1));
    return {};
  });
  reader.Read("SELECT place, name, text FROM part",
              [&](const Statement& row) { return ReadPart(row, texts, &states); });
  reader.Read(fmt::format("SELECT command, samples, begun FROM posted WHERE NOT {} ORDER BY number",
                          kLeftAlone),
              [&](const Statement& row) { return ReadPosted(row, &document.posted); });
  reader.Read("SELECT command, samples, 0 FROM laid_aside ORDER BY id",
              [&](const Statement& row) { return ReadPosted(row, &document.laid_aside); });
  reader.Read(
      fmt::format("SELECT command, samples, max(begun, 1) FROM posted WHERE {} ORDER BY number",
                  kLeftAlone),
      [&](const Statement& row) { return ReadPosted(row, &document.laid_aside); });
  if (!reader.result) return Fail(reader.result);
  if (const auto read = ReadStates(states, &document); !read) {
    return tl::unexpected<Error>(Damaged(path, read.error().message));
  }
  return document;
}

}  // namespace

Error Damaged(const std::string& path, std::string_view what) {
  return {ErrorCode::kDamagedFile, fmt::format("{} is not a whole document: {}", path, what),
          "open a copy of it from before it was damaged"};
}

Result<int> VersionOf(Database* database, const std::string& path) {
  const auto id = database->Pragma("application_id");
  if (!id) return Fail(id);
  if (*id != kDocumentApplicationId) {
    const auto pages = database->Pragma("page_count");
    if (pages && *pages == 0) {
      return Fail(ErrorCode::kDamagedFile, fmt::format("{} is empty: it holds no document", path),
                  "delete it to begin a new one of its name, or open another");
    }
    return Fail(ErrorCode::kDamagedFile, fmt::format("{} is a database, but not Parti's", path),
                "open a .parti document");
  }
  const auto version = database->Pragma("user_version");
  if (!version) return Fail(version);
  if (*version > kDocumentVersion) {
    return Fail(ErrorCode::kDamagedFile,
                fmt::format("{} was saved by a newer Parti (format {})", path, *version),
                fmt::format("this one reads formats up to {}: update it", kDocumentVersion));
  }
  if (*version < 1) return tl::unexpected<Error>(Damaged(path, "it has no format number"));
  return static_cast<int>(*version);
}

Result<StateSpan> SpanIn(Database* database, const std::string& path) {
  auto query = database->Prepare(
      "SELECT (SELECT min(place) FROM part), (SELECT place FROM present),"
      "       (SELECT max(place) FROM part)");
  if (!query) return Fail(query);
  const auto row = query->Step();
  if (!row) return Fail(row);
  const int64_t first = query->Integer(0), now = query->Integer(1), last = query->Integer(2);
  if (query->Text(0).empty() || query->Text(1).empty() || first < 0 || now < first || now > last) {
    return tl::unexpected<Error>(Damaged(path, "it has no present state"));
  }
  return StateSpan{static_cast<uint64_t>(first), static_cast<uint64_t>(now),
                   static_cast<uint64_t>(last)};
}

Result<Document> ReadTables(Database* database, const std::string& path) {
  if (const auto begun = database->Execute("BEGIN"); !begun) return Fail(begun);
  auto document = ReadAll(database, path);
  static_cast<void>(database->Execute("COMMIT"));  // only reading: there is nothing to lose
  return document;
}

}  // namespace parti::app
