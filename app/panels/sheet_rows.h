// What each sheet has in it, as rows of a form; called twice a frame, to measure and to draw.
// Opening and placing sheets is sheets.h's.
#pragma once

#include "app/panels/form.h"

namespace parti::app::panels {

/// Drafts that were left, the newest first, at most so many: opened or, asked twice, thrown away.
void DraftRows(Ui* ui, Memory* memory, Form* form, size_t most);
/// New, open, save as, drafts, recent, a recording for a report.
void DocumentRows(Ui* ui, Memory* memory, Form* form);
/// A folder's documents to open, or a name to save as.
void OpenRows(Ui* ui, Memory* memory, Form* form);
void SaveAsRows(Ui* ui, Memory* memory, Form* form);
void ExportRows(Ui* ui, Memory* memory, Form* form);
/// Ways to look, and views with names.
void ViewsRows(Ui* ui, Memory* memory, Form* form);
/// Theme, size, hand, finger.
void SettingsRows(Ui* ui, Memory* memory, Form* form);

/// "folder/name", whichever of them ends or begins with a slash.
std::string Joined(const std::string& folder, const std::string& name);
/// The part after the last slash, and the part before.
std::string NameIn(const std::string& path);
std::string FolderOf(const std::string& path);

}  // namespace parti::app::panels
