// Drafts that were left by a kill, or by ending without a name: offered when the program starts,
// and in the document's sheet. Finding and deleting them is document_drafts.h's.
#pragma once

#include <string>

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// "22 November 2026, 09:30" of a draft's path; the file's name where it is another.
std::string WordsOfDraft(const std::string& path);

/// The card at the start: until something is drawn or opened, or the card is closed.
void DrawLeftDrafts(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
