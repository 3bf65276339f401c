// The files of assets/shaders, built into the program, which so works from any folder.
// Compiling them is GlProgram's.
#pragma once

#include <string_view>

namespace parti::render {

/// The text of assets/shaders/NAME, without a version line; the file must exist.
std::string_view ShaderText(std::string_view name);

}  // namespace parti::render
