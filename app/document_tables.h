// The tables of a document and how single rows are written; docs/document.md describes them.
// Which rows a change needs is document_file.h's, reading them document_reading.h's.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/sqlite.h"
#include "app/timeline.h"

namespace parti::app {

/// What was drawn or asked for when the program was ended, and not yet executed.
struct PostedRequest {
  std::string command;  ///< as ParseCommand reads it; "" for a stroke
  Stroke stroke = {};
  int begun = 0;  ///< how often a program has set about it
};

/// A text that several states may share.
using SharedText = std::shared_ptr<const std::string>;

/// A state of a session as named texts, "rules", "lots", "view" …: what is equal in two states is
/// in the file once. What the parts are is document_record.h's.
using StateParts = std::map<std::string, SharedText>;

/// Makes the tables of the newest version in an empty database.
Result<void> MakeTables(Database* database);

/// Under its number.
Result<void> WriteStroke(Database* database, const DrawnStroke& drawn);

/// Appends to what was done.
Result<void> WriteHistory(Database* database, std::string_view command);

/// A request that waits, under its number.
Result<void> WritePosted(Database* database, int64_t number, const PostedRequest& request);
/// Numbers them so that the last one's is 0.
Result<void> WritePosted(Database* database, const std::vector<PostedRequest>& requests);

/// Which rows of `posted` are not to be executed: one that was begun twice and never done ends the
/// program, and what was posted after it is about what it would have made.
inline constexpr std::string_view kLeftAlone =
    "number >= ifnull((SELECT min(number) FROM posted WHERE begun >= 2), 9e18)";

/// A request that is not to be executed again.
Result<void> WriteLaidAside(Database* database, const PostedRequest& request);

/// Which states there are, and which one is the present, by their numbers.
using StateSpan = Timeline::Span;

/// Writes the present state, and drops the states outside the span and the texts that only they
/// had.
Result<void> WriteState(Database* database, const StateSpan& span, const StateParts& parts);

}  // namespace parti::app
