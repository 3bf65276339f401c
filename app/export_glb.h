// Models as glTF 2.0, binary (.glb) or text (.gltf).
// One node and mesh for each symbol, named by it; one primitive for each material in it.
#pragma once

#include <string>

#include "app/model_mesh.h"

namespace parti::app {

/// .glb or .gltf, the latter with its buffer inside.
enum class GltfForm { kBinary, kText };

/// The bytes of a file, the same for the same model. Metres, y up, front faces counter-clockwise,
/// flat normals; corners that touch within a shape are bit for bit the same. Coordinates become
/// floats: 0.06 mm at a kilometre from the origin.
/// errors  kNothingMade  no triangle;  kLimitReached  more than 4 GB, which the format can't hold.
Result<std::string> GltfBytes(const ModelMesh& mesh, GltfForm form);

/// errors  those above, naming the file; kFile  it can't be written.
Result<void> ExportGltf(const ModelMesh& mesh, GltfForm form, const std::string& path);

}  // namespace parti::app
