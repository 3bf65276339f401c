// Ink cut into pieces that shaders draw: capsules between neighbouring samples.
// The one place where a sample that can't be drawn is left out; colours and blending are not here.
#pragma once

#include <vector>

#include "render/pixel_rect.h"
#include "render/scene.h"
#include "render/vertex_stream.h"

namespace parti::render {

/// Between two samples, or a dot where both are the same. [px]
struct InkPiece {
  Vec2f a, b;
  Vec2f radii;  ///< finite, in [0, kWidestInk_px / 2]

  bool operator==(const InkPiece&) const = default;
};

/// Wider ink is drawn with this width. [px]
inline constexpr float kWidestInk_px = 4096;

/// How pieces lie in a VertexStream.
const std::vector<VertexAttribute>& InkLayout();

/// Appends the pieces that end at sample `from` or later. Samples that are not drawable (see
/// IsDrawable) leave gaps; one between gaps is a dot. Missing widths are 1 px, negative ones 0.
/// Properties: (1) appending from 0, or from each new sample as it comes, gives the same pieces but
/// for a dot at the last sample, which the next sample may make part of a line.
void AppendPieces(const Ink& ink, size_t from, std::vector<InkPiece>* pieces);

/// Whether the ink's last sample is, so far, a dot.
bool EndsInDot(const Ink& ink);

/// The pixels that a piece may colour in a picture of `size`.
PixelRect PixelsOf(const InkPiece& piece, const glm::ivec2& size);

}  // namespace parti::render
