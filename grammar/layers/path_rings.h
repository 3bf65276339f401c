// A path sampled down to rings (Jesus 2018, 4.2.3, vectorial; errata 4): ends of its segments are
// kept, samples are spread over the curves.
// Whether the rings are simple is PolygonFrom's to say.
#pragma once

#include <vector>

#include "grammar/layers/svg_path.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// One ring per loop of the path, its coordinates times `size`. About `samples` corners are spread
/// over all curves, evenly by length on the sized path, at least one in each curve.
std::vector<Ring> RingsOf(const SvgPath& path, int samples, const Vec2& size);

}  // namespace parti::grammar
