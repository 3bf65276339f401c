// Models as glTF 2.0, binary (.glb) or text (.gltf).
// One node and mesh for each symbol, named by it; one primitive for each material in it.
#pragma once

#include <string>

#include "app/model_mesh.h"

namespace parti::app {

/// .glb or .gltf, the latter with its buffer inside.
enum class GltfForm { kBinary, kText };

/// What a file may hold besides its JSON: its lengths are 32 bits wide.
inline constexpr size_t kMostGltfBytes = 0xf0000000;

/// The bytes of a file, the same for the same model. Metres, y up, front faces counter-clockwise,
/// flat normals; corners that touch within a shape are bit for bit the same. Coordinates become
/// floats: 0.06 mm at a kilometre from the origin. Takes as much memory as the file, and little
/// more (four times as much for the text); of a model that may not fit the bytes are counted first.
/// errors  kNothingMade  no triangle;  kLimitReached  more than `most_bytes` besides the JSON.
Result<std::string> GltfBytes(const ModelParts& parts, GltfForm form,
                              size_t most_bytes = kMostGltfBytes);
Result<std::string> GltfBytes(const ModelMesh& mesh, GltfForm form,
                              size_t most_bytes = kMostGltfBytes);

/// errors  those above, naming the file; kFile  it can't be written.
Result<void> ExportGltf(const ModelParts& parts, GltfForm form, const std::string& path,
                        size_t most_bytes = kMostGltfBytes);

}  // namespace parti::app
