#include "app/scene_from_model.h"

#include <algorithm>
#include <string_view>

#include "app/covered_edges.h"
#include "app/crease_lines.h"
#include "app/line_spacing.h"
#include "grammar/item_surface.h"

namespace parti::app {
namespace {

using grammar::Item;
using grammar::ItemType;
using render::Scene;
using render::Vec3f;

/// FNV-1a, the same on every machine as std::hash need not be.
uint32_t HashOf(std::string_view text) {
  uint32_t hash = 2166136261u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash ^ hash >> 15;
}

/// Shapes of one symbol look alike and a little unlike others: warmer or cooler, lighter or darker.
Vec3f Tinted(const Vec3f& color, std::string_view symbol, float tint) {
  const uint32_t hash = HashOf(symbol);
  const auto part = [hash](int shift) {
    return static_cast<float>(hash >> shift & 255) / 127.5f - 1;
  };
  const float warm = tint * part(0), light = 0.6f * tint * part(8);
  return color + Vec3f(0.6f * warm + light, light, light - warm);
}

Vec3f ColorOf(const Item& item, std::string_view symbol, const DrawingStyle& style) {
  if (const uint32_t rgb = item.color_rgb) {
    return Vec3f(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0f;
  }
  if (item.type == ItemType::kVolume) return Tinted(style.body, symbol, style.tint);
  const bool faces_up = item.scope.z.y > 0.7;
  return Tinted(faces_up ? style.ground : style.wall, symbol, style.tint);
}

/// Images repeat: each triangle's coordinates may begin where float has most digits.
void Wear(const grammar::SurfacePart& part, render::Faces* faces) {
  if (!part.material || !part.material->image || part.uvs.empty()) return;
  const auto& image = part.material->image;
  faces->image = {image, &image->bytes};
  if (!part.color_rgb) faces->color = Vec3f(1, 1, 1);
  for (size_t i = 0; i < part.uvs.size(); ++i) {
    faces->uvs.emplace_back(part.uvs[i] - glm::floor(part.uvs[i / 3 * 3]));
  }
}

void AddSegments(const std::vector<Segment3>& segments, render::Lines* lines) {
  for (const Segment3& segment : segments) {
    lines->ends.emplace_back(segment.a);
    lines->ends.emplace_back(segment.b);
  }
}

void AddCreases(const std::vector<Segment3>& edges, const Vec3& behind, const DrawingStyle& style,
                Scene* scene) {
  render::Lines creases{{}, style.crease, style.crease_px};
  creases.behind = Vec3f(behind);
  AddSegments(WithoutOverlaps(edges), &creases);
  if (!creases.ends.empty()) scene->lines.push_back(std::move(creases));
}

}  // namespace

void AddModel(const grammar::ShapeTree& tree, Scene* scene, uint32_t first_id,
              const DrawingStyle& style) {
  const std::vector<grammar::ShapeIndex> leaves = tree.Leaves();
  const size_t first_face = scene->faces.size();
  const SortedEdges edges = SortEdges(tree, leaves);
  auto covered_shape = edges.covered_shapes.begin();
  for (const grammar::ShapeIndex i : leaves) {
    const bool is_covered = covered_shape != edges.covered_shapes.end() && *covered_shape == i;
    if (is_covered) ++covered_shape;
    const grammar::Shape& shape = tree[i];
    for (const grammar::SurfacePart& part : grammar::SurfaceOf(shape.item)) {
      Item worn = shape.item;
      worn.color_rgb = part.color_rgb;
      scene->faces.push_back({{part.corners.begin(), part.corners.end()},
                              ColorOf(worn, tree.Name(shape.symbol), style),
                              first_id + i,
                              grammar::IsClosedBody(shape.item),
                              is_covered});
      Wear(part, &scene->faces.back());
    }
  }
  const size_t first_line = scene->lines.size();
  AddCreases(edges.open, Vec3(0, 0, 0), style, scene);
  for (const CoveredEdges& covered : edges.covered) {
    AddCreases(covered.edges, covered.normal, style, scene);
  }
  const float spacing_m = LineSpacing_m(std::span(scene->faces).subspan(first_face));
  for (size_t i = first_line; i < scene->lines.size(); ++i) scene->lines[i].spacing_m = spacing_m;
}

void AddModels(std::span<const grammar::ShapeTree* const> trees, Scene* scene, uint32_t first_id,
               const DrawingStyle& style) {
  for (const grammar::ShapeTree* tree : trees) {
    AddModel(*tree, scene, first_id, style);
    first_id += tree->size();
  }
}

float InkWidth_px(const std::optional<double>& pressure, const DrawingStyle& style) {
  return style.ink_px * static_cast<float>(0.5 + std::clamp(pressure.value_or(0.5), 0.0, 1.0));
}

render::Ink InkOf(const Stroke& stroke, double scale, const DrawingStyle& style) {
  render::Ink ink{{}, {}, style.ink};
  for (const StrokeSample& sample : stroke) {
    ink.points.emplace_back(sample.position * scale);
    ink.widths_px.push_back(InkWidth_px(sample.pressure, style) * static_cast<float>(scale));
  }
  return ink;
}

void AddStroke(const Stroke& stroke, Scene* scene, double scale, const DrawingStyle& style) {
  if (!stroke.empty()) scene->ink.push_back(InkOf(stroke, scale, style));
}

void AddLiftedLines(std::span<const Segment3> lines, Scene* scene, const DrawingStyle& style) {
  render::Lines lifted{{}, style.lifted, style.lifted_px, 0, true};
  AddSegments({lines.begin(), lines.end()}, &lifted);
  if (!lifted.ends.empty()) scene->lines.push_back(std::move(lifted));
}

void AddSuggestion(std::span<const Segment3> edges, Scene* scene, const DrawingStyle& style) {
  render::Lines wires{{}, style.suggestion, style.suggestion_px, style.suggestion_dash_px, true};
  AddSegments({edges.begin(), edges.end()}, &wires);
  if (!wires.ends.empty()) scene->lines.push_back(std::move(wires));
}

}  // namespace parti::app
