// States of a session as the named texts of a document, and back.
// How texts are stored is document_tables.h's.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/document_tables.h"
#include "app/lot.h"
#include "app/session_record.h"

namespace parti::app {

/// [{"name","item","origin","properties" (absent: none)}, …]: every double exact.
std::string LotsText(const std::vector<Lot>& lots);
/// errors  kBadText and those of PlanarItemFrom.
Result<std::vector<Lot>> LotsFrom(std::string_view text);

/// "lots", "rules" and "view" as they are read by people; "source" the text and settings of rules;
/// "views" the named ones; "sketch" the numbers of its strokes and what else undo brings back. The
/// last three only where there is any.
StateParts PartsOf(const SessionRecord& record);

/// Reads the states of one document; what they share is read once and shared again.
class RecordReader {
 public:
  using Strokes = std::map<uint32_t, std::shared_ptr<const DrawnStroke>>;
  explicit RecordReader(Strokes strokes) : strokes_(std::move(strokes)) {}

  /// errors  kDamagedFile, kBadText …: a part that is missing, or that can't be read.
  /// Property  (1) Read(PartsOf(record)) is the record, as far as its strokes are known.
  Result<SessionRecord> Read(const StateParts& parts);

 private:
  Result<std::shared_ptr<const Ground>> Lots(const StateParts& parts);
  Result<std::shared_ptr<const grammar::Trees>> Rules(const StateParts& parts);

  Strokes strokes_;
  /// By lots and source.
  std::map<std::pair<SharedText, SharedText>, std::shared_ptr<const Ground>> grounds_;
  std::map<SharedText, std::shared_ptr<const grammar::Trees>> rules_;
};

}  // namespace parti::app
