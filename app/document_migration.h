// Documents of older versions of the program become ones of this version, in place or in memory.
// What this version's tables are is document_tables.h's; a newer version is refused before.
#pragma once

#include <string>

#include "app/document_reading.h"

namespace parti::app {

/// Brings a document that is open for writing to the newest version, in one transaction: it is of
/// the old version or of the new one, whenever the process ends. Does nothing to a new one.
/// errors  kDamagedFile; kFile.
Result<void> Migrate(Database* database, const std::string& path);

/// As ReadTables, for a document of any version.
Result<Document> ReadAnyVersion(Database* database, const std::string& path);

}  // namespace parti::app
