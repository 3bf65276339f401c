// Images as faces wear them: decoded, opaque, and of a size that every device takes.
// Where they are on a face is the scene's.
#pragma once

#include <string_view>

#include "render/image.h"

namespace parti::render {

/// Larger images are halved until both sides are at most this long: a wall of a picture is never
/// wider, and memory stays bounded. [px]
inline constexpr int kMostTextureSide_px = 2048;

/// A PNG or JPEG, told apart by its first bytes. What is transparent shows white, and so the face's
/// own colour.
/// errors  kDamagedFile  neither, cut short, inconsistent, or of more than 2^28 pixels.
Result<Image> DecodeTexture(std::string_view bytes);

/// Baseline and progressive, grey and colour; CMYK is refused. A file that is cut short gives what
/// it has, the rest grey. Sides longer than `most_side_px` are made smaller by up to 8 while
/// decoding.
/// errors  kDamagedFile  as above.
Result<Image> DecodeJpeg(std::string_view bytes, int most_side_px = kMostTextureSide_px);

}  // namespace parti::render
