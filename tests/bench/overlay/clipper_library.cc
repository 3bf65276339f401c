// Clipper 6.4 (libpolyclipping): integers; a grid of 1e-8 m.
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "tests/bench/overlay/overlay_library.h"

namespace parti::bench {
namespace {

using grammar::Polygon;
using grammar::Ring;

constexpr double kPerMetre = 1e8;

ClipperLib::Path PathOf(const Ring& ring) {
  ClipperLib::Path path;
  for (const Vec2& p : ring) {
    path.emplace_back(std::llround(p.x * kPerMetre), std::llround(p.y * kPerMetre));
  }
  return path;
}

void Add(const Polygon& polygon, ClipperLib::PolyType type, ClipperLib::Clipper* clipper) {
  clipper->AddPath(PathOf(polygon.outer), type, true);
  for (const Ring& hole : polygon.holes) clipper->AddPath(PathOf(hole), type, true);
}

Ring RingFrom(const ClipperLib::Path& path) {
  Ring ring;
  for (const ClipperLib::IntPoint& p : path) {
    ring.emplace_back(static_cast<double>(p.X) / kPerMetre, static_cast<double>(p.Y) / kPerMetre);
  }
  return ring;
}

void Read(const ClipperLib::PolyNode& node, Polygons* polygons) {
  for (const ClipperLib::PolyNode* outline : node.Childs) {
    Polygon polygon{RingFrom(outline->Contour), {}};
    for (const ClipperLib::PolyNode* hole : outline->Childs) {
      polygon.holes.push_back(RingFrom(hole->Contour));
      Read(*hole, polygons);
    }
    polygons->push_back(std::move(polygon));
  }
}

std::optional<Polygons> Execute(ClipperLib::ClipType type, const Polygon& a, const Polygons& b) {
  try {
    ClipperLib::Clipper clipper;
    Add(a, ClipperLib::ptSubject, &clipper);
    for (const Polygon& polygon : b) Add(polygon, ClipperLib::ptClip, &clipper);
    ClipperLib::PolyTree tree;
    if (!clipper.Execute(type, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero)) {
      return std::nullopt;
    }
    Polygons polygons;
    Read(tree, &polygons);
    return polygons;
  } catch (const ClipperLib::clipperException&) {
    return std::nullopt;
  }
}

std::optional<Polygons> Intersection(const Polygon& a, const Polygon& b) {
  return Execute(ClipperLib::ctIntersection, a, {b});
}
std::optional<Polygons> Difference(const Polygon& whole, const Polygons& parts) {
  return Execute(ClipperLib::ctDifference, whole, parts);
}

}  // namespace

const OverlayLibrary kClipper = {"Clipper", Intersection, Difference};

}  // namespace parti::bench
