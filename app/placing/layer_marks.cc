#include "app/placing/layer_marks.h"

#include <algorithm>

namespace parti::app {
namespace {

using grammar::InteractiveLayer;
using grammar::LayerHandle;
using grammar::LayerSnap;

constexpr float kRim_px = 3;      ///< of a handle's color around its white
constexpr double kBeyond = 0.06;  ///< of their length: guides reach a little farther

/// Segments of rectangles in one frame.
class Lines {
 public:
  explicit Lines(const grammar::Scope& frame) : frame_(frame) {}

  void Add(const Vec2& a, const Vec2& b) {
    segments_.push_back({frame_.ToWorld({a, 0}), frame_.ToWorld({b, 0})});
  }
  void AddRectangle(const InteractiveLayer& layer) {
    for (size_t i = 0; i < 4; ++i) {
      Add(PlaceOf(layer, kLayerHandles[i]), PlaceOf(layer, kLayerHandles[(i + 1) % 4]));
    }
  }
  std::vector<Segment3> Taken() { return std::move(segments_); }

 private:
  const grammar::Scope& frame_;
  std::vector<Segment3> segments_;
};

void AddDot(const Vec2& px, float diameter_px, const render::Vec4f& color,
            std::vector<render::Mark>* marks) {
  marks->push_back({{render::Vec2f(px)}, color, diameter_px});
}

/// A rectangle with its handles; the one that is meant is filled.
void AddElement(const grammar::Scope& frame, const InteractiveLayer& layer, bool stands_out,
                const std::optional<LayerHandle>& meant, const View& view,
                std::vector<render::Mark>* marks, const DrawingStyle& style) {
  Lines lines(frame);
  lines.AddRectangle(layer);
  const render::Vec4f color = stands_out ? style.selected : style.layer;
  Project({WorldMarks{lines.Taken(), color, style.layer_px}}, view, marks);
  for (const LayerHandle handle : kLayerHandles) {
    const auto px = view.Project(frame.ToWorld({PlaceOf(layer, handle), 0}));
    if (!px) continue;
    AddDot(*px, style.handle_px, color, marks);
    const bool filled = meant && (meant->whole() || *meant == handle);
    if (!filled) AddDot(*px, style.handle_px - kRim_px, {1, 1, 1, 1}, marks);
  }
}

/// The line through two rectangles that they have in common.
void AddCommonLine(const InteractiveLayer& a, const InteractiveLayer& b, double at,
                   grammar::LayerAxis axis, Lines* lines) {
  const bool across = axis == grammar::LayerAxis::kHorizontal;
  const Vec2 low(std::min(a.left, b.left), std::min(a.bottom, b.bottom));
  const Vec2 high(std::max(a.left + a.width, b.left + b.width),
                  std::max(a.bottom + a.height, b.bottom + b.height));
  const Vec2 beyond = (high - low) * kBeyond;
  if (across) {
    lines->Add({at, low.y - beyond.y}, {at, high.y + beyond.y});
  } else {
    lines->Add({low.x - beyond.x, at}, {high.x + beyond.x, at});
  }
}

/// Through its middle from side to side, where the other has the same.
void AddSize(const InteractiveLayer& layer, grammar::LayerAxis axis, Lines* lines) {
  const bool across = axis == grammar::LayerAxis::kHorizontal;
  const LayerHandle low = across ? LayerHandle{-1, 0} : LayerHandle{0, -1};
  const LayerHandle high = across ? LayerHandle{1, 0} : LayerHandle{0, 1};
  lines->Add(PlaceOf(layer, low), PlaceOf(layer, high));
}

void AddGuide(const LayerDrag& drag, const std::optional<LayerSnap>& snap, grammar::LayerAxis axis,
              Lines* lines) {
  // The last of the others is the element where it was: no news.
  if (!snap || snap->like + 1 >= drag.others().size()) return;
  const InteractiveLayer &mine = drag.snapped().layer, &other = drag.others()[snap->like];
  if (snap->kind != LayerSnap::Kind::kSize) {
    return AddCommonLine(mine, other, snap->at_m, axis, lines);
  }
  AddSize(mine, axis, lines);
  AddSize(other, axis, lines);
}

}  // namespace

void AddLayerMarks(const PlacedLayers& placed, const LayersMeant& meant, const View& view,
                   std::vector<render::Mark>* marks, const DrawingStyle& style) {
  // The uppermost last, over the others.
  for (size_t i = placed.layers.size(); i-- > 0;) {
    std::optional<LayerHandle> handle;
    if (meant.grip && meant.grip->layer == i) handle = meant.grip->handle;
    AddElement(placed.layers[i].frame, placed.layers[i].rules.layer, handle || meant.held == i,
               handle, view, marks, style);
  }
  if (!meant.held || !meant.by) return;
  Lines by(placed.layers[*meant.held].frame);
  by.AddRectangle(*meant.by);
  Project({WorldMarks{by.Taken(), style.guide, style.guide_px}}, view, marks);
}

void AddLayerMarks(const LayerDrag& drag, const View& view, std::vector<render::Mark>* marks,
                   const DrawingStyle& style) {
  const std::vector<PlacedLayer>& layers = drag.placed().layers;
  for (size_t i = layers.size(); i-- > 0;) {
    std::optional<LayerHandle> handle;
    if (drag.grip().layer == i) handle = drag.grip().handle;
    AddElement(layers[i].frame, drag.LayerNow(i), handle.has_value(), handle, view, marks, style);
  }
  Lines guides(layers[drag.grip().layer].frame);
  AddGuide(drag, drag.snapped().across, grammar::LayerAxis::kHorizontal, &guides);
  AddGuide(drag, drag.snapped().up, grammar::LayerAxis::kVertical, &guides);
  Project({WorldMarks{guides.Taken(), style.guide, style.guide_px}}, view, marks);
}

}  // namespace parti::app
