// Models as Wavefront OBJ, with a material file (MTL) beside it where shapes have colours.
// One group for each symbol; shapes share no corners, so that each body stays closed in itself.
#pragma once

#include <string>

#include "app/model_mesh.h"

namespace parti::app {

/// The texts of both files.
struct ObjText {
  std::string obj;
  std::string mtl;  ///< "" where no shape has a colour
};

/// The same for the same model. Metres to the micrometre, y up, counter-clockwise from outside,
/// flat normals. Blanks in symbols become _. `mtl_name` is how the OBJ names its material file.
/// Takes as much memory as the files, and little more.
/// errors  kNothingMade  no triangle.
Result<ObjText> ObjTextOf(const ModelParts& parts, const std::string& mtl_name);
Result<ObjText> ObjTextOf(const ModelMesh& mesh, const std::string& mtl_name);

/// Writes `path`, and the material file with the ending .mtl beside it.
/// errors  kNothingMade, naming the file; kFile  one can't be written.
Result<void> ExportObj(const ModelParts& parts, const std::string& path);
Result<void> ExportObj(const ModelMesh& mesh, const std::string& path);

}  // namespace parti::app
