// Shape trees, sketches and suggestions as pictures show them: a render::Scene with quiet colours.
// Which tree, sketch or suggestion is shown is the caller's; how it is drawn is render's.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "app/auto_view.h"
#include "base/stroke.h"
#include "grammar/shape_tree.h"
#include "render/scene.h"

namespace parti::app {

/// Colours and widths of what Parti draws. Colours are sRGB.
struct DrawingStyle {
  render::Vec3f body{0.945f, 0.935f, 0.910f};    ///< volumes without a colour: card board
  render::Vec3f wall{0.930f, 0.925f, 0.905f};    ///< upright planar shapes
  render::Vec3f ground{0.880f, 0.890f, 0.845f};  ///< planar shapes that face up: lots, terraces
  float tint = 0.045f;                           ///< how far symbols' own tints stray from these

  render::Vec4f crease{0.16f, 0.15f, 0.16f, 1};
  float crease_px = 1.4f;

  render::Vec4f ink{0.07f, 0.12f, 0.40f, 1};
  float ink_px = 3.0f;  ///< at half pressure, and where a device has none

  render::Vec4f lifted{0.10f, 0.38f, 0.80f, 1};
  float lifted_px = 2.2f;

  render::Vec4f suggestion{0.86f, 0.33f, 0.10f, 1};
  float suggestion_px = 2.0f;
  float suggestion_dash_px = 7;

  render::Vec4f selected{0.86f, 0.33f, 0.10f, 1};
  float selected_px = 2.6f;
  render::Vec4f hovered{0.10f, 0.38f, 0.80f, 0.55f};
  float hovered_px = 2.0f;
  float snap_px = 9.0f;  ///< diameter of the dot on a corner; edges are a third as wide

  render::Vec4f layer{0.10f, 0.38f, 0.80f, 1};  ///< elements that can be placed by hand
  float layer_px = 1.8f;
  float handle_px = 9.0f;                       ///< diameter
  render::Vec4f guide{0.80f, 0.08f, 0.52f, 1};  ///< what an element being placed falls in with
  float guide_px = 1.6f;
};

/// Adds the leaves of a tree: faces with `first_id` + ShapeIndex as their ids, and each crease
/// once, wherever edges of neighbours lie on each other. Give the second of several lots a first_id
/// beyond the first's shapes. first_id >= 1.
void AddModel(const grammar::ShapeTree& tree, render::Scene* scene, uint32_t first_id = 1,
              const DrawingStyle& style = {});

/// The same for the trees of several lots, numbered on from first_id.
void AddModels(std::span<const grammar::ShapeTree* const> trees, render::Scene* scene,
               uint32_t first_id = 1, const DrawingStyle& style = {});

/// Width follows pressure from half to one and a half of ink_px; a device without it is in between.
float InkWidth_px(const std::optional<double>& pressure, const DrawingStyle& style = {});

/// A stroke where it was drawn; `scale` is the picture's pixels per pixel of the stroke's view.
render::Ink InkOf(const Stroke& stroke, double scale = 1, const DrawingStyle& style = {});

/// Adds InkOf the stroke, if it has samples.
void AddStroke(const Stroke& stroke, render::Scene* scene, double scale = 1,
               const DrawingStyle& style = {});

/// Adds the lines that a sketch means in the world, faint where the model hides them.
void AddLiftedLines(std::span<const Segment3> lines, render::Scene* scene,
                    const DrawingStyle& style = {});

/// Adds what an operation would make, as a dashed wire frame of its edges.
void AddSuggestion(std::span<const Segment3> edges, render::Scene* scene,
                   const DrawingStyle& style = {});

}  // namespace parti::app
