// How much of an item others hide in a view.
// By rays against flat facets: no picture is drawn for it.
#pragma once

#include <span>

#include "base/camera.h"
#include "grammar/item.h"

namespace parti::sketch {

/// A face of an item of the scene, ready for rays.
struct Facet {
  size_t item = 0;
  Plane plane;
  grammar::Scope scope;
  grammar::Polygon outline;
};

/// The faces of those items, in their order, planar items giving themselves.
std::vector<Facet> FacetsOf(std::span<const grammar::Item> items, std::span<const size_t> which);

/// Whether the ray through a pixel meets the facet in front of the eye.
bool IsOver(const Vec2& pixel, const Facet& facet, const View& view);

/// Share in [0, 1] of points spread over the item's faces towards the eye that other facets hide;
/// 1 for an item of which no face looks towards the eye. Touching and coplanar faces hide nothing.
double HiddenShare(size_t item, const std::vector<Facet>& facets, const View& view);

}  // namespace parti::sketch
