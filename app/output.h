// Files that a model is written to, by the ending of their name.
// Each format has its own writer (export_glb.h, export_obj.h); this only chooses.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/session_state.h"
#include "base/error.h"

namespace parti::app {

/// .glb, .gltf, .obj: what is visible, in metres, y up, grouped by symbol; .cga: the rules as text;
/// .png: a picture in `view`, or one that shows all of it.
/// errors  kUnknownName  another ending (the hint lists those there are);  kNothingMade  the model
///         is empty;  kFile.
Result<void> ExportModel(const Model& model, const std::optional<Camera>& view,
                         const std::string& path);

/// Whether ExportModel knows the path's ending, capitals or not; for before the model is made.
/// errors  kUnknownName.
Result<void> CheckExportEnding(const std::string& path);
/// The same for all that a command is to write: exports, a picture, a document; "" none.
Result<void> CheckEndings(const std::vector<std::string>& exports, const std::string& png,
                          const std::string& document);

/// ".glb, .gltf, …": the endings that ExportModel knows.
std::string ExportEndings();

}  // namespace parti::app
