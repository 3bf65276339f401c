// How close the lines of a model lie: what tells how far away they run together.
// Of faces as they are drawn; how lines fade is render's.
#pragma once

#include <span>

#include "render/scene.h"

namespace parti::app {

/// The width [m] of these faces, those of a square or a band for the whole of theirs: half of all
/// that their triangles' sides are long lies on narrower ones. 0 where nothing has a size. Cost: n
/// log n of the groups.
float LineSpacing_m(std::span<const render::Faces> faces);

}  // namespace parti::app
