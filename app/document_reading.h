// Reading the tables of a document, of this version; what is odd there is damage, and named.
// Opening the file is document.h's, older versions are document_migration.h's.
#pragma once

#include <string>

#include "app/document.h"
#include "app/sqlite.h"

namespace parti::app {

/// Damage of the document at a path.
Error Damaged(const std::string& path, std::string_view what);

/// The version of the document's format.
/// errors  kDamagedFile  another program's database, one without a version, or a newer one.
Result<int> VersionOf(Database* database, const std::string& path);

/// Everything, as it is at one moment, even while another process writes.
/// errors  kDamagedFile; kFile.
Result<Document> ReadTables(Database* database, const std::string& path);

/// Which states a document has. errors  kDamagedFile  none, or no present one.
Result<StateSpan> SpanIn(Database* database, const std::string& path);

}  // namespace parti::app
