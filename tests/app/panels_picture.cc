#include "tests/app/panels_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/picture.h"
#include "tests/support/canvas_target.h"

namespace parti::app::tests {
namespace {

/// The state as a window of another size shows it, its ink included.
SessionState InView(SessionState state, const Vec2& size_px) {
  const auto fit = [&](Camera* camera) {
    camera->width_px = size_px.x;
    camera->height_px = size_px.y;
  };
  const double zoom = size_px.y / state.camera.height_px;
  const Vec2 middle(state.camera.width_px / 2, state.camera.height_px / 2);
  for (auto& drawn : state.sketch.strokes) {
    DrawnStroke seen = *drawn;
    for (StrokeSample& sample : seen.stroke) {
      sample.position = (sample.position - middle) * zoom + size_px / 2.0;
    }
    fit(&seen.camera);
    drawn = std::make_shared<const DrawnStroke>(std::move(seen));
  }
  fit(&state.camera);
  return state;
}

/// The drawing as a texture that the canvas shows; paper where there is nothing yet.
render::Image DrawingOf(const SessionSnapshot* session, const Vec2& size_px) {
  const auto width = static_cast<int>(size_px.x), height = static_cast<int>(size_px.y);
  render::Image paper{width, height, std::vector<uint8_t>(size_t{4} * width * height, 245)};
  if (!session || session->state->model.lots().empty()) return paper;
  return PictureOf(InView(*session->state, size_px)).value_or(paper);
}

}  // namespace

render::Image PictureWith(const PanelOutput& output, const SessionSnapshot* session,
                          const Vec2& size_px) {
  const render::Image drawing = DrawingOf(session, size_px);
  const glm::ivec2 size(drawing.width, drawing.height);
  auto target = render::tests::CanvasTarget::Create(render::OffscreenTarget::kBest, size);
  if (!target) {
    ADD_FAILURE() << "no way to draw without a window";
    return drawing;
  }
  // The drawing is itself a panel's picture here, under the panels: no texture to make by hand.
  constexpr uint32_t kDrawing = 1;
  EXPECT_TRUE(target->canvas().SetPanelTexture(0, *output.letters));
  EXPECT_TRUE(target->canvas().SetPanelTexture(kDrawing, drawing));
  render::UiMesh mesh = output.mesh;
  const auto first = static_cast<uint32_t>(mesh.indices.size());
  const auto vertex = static_cast<uint32_t>(mesh.vertices.size());
  for (const glm::vec2 corner : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
    mesh.vertices.push_back({corner * glm::vec2(size), corner, 0xffffffff});
  }
  for (const uint32_t i : {0, 1, 2, 0, 2, 3}) mesh.indices.push_back(vertex + i);
  mesh.commands.insert(mesh.commands.begin(), {{0, 0, size.x, size.y}, kDrawing, first, 6});
  target->canvas().SetPanels(mesh);
  target->Draw();
  return target->Shown();
}

render::Image AroundSheets(const render::Image& image, const PanelOutput& output,
                           const std::vector<std::string>& sheets, double margin_px) {
  if (sheets.empty()) return image;
  const Vec2 size(image.width, image.height);
  Vec2 low = size, high(0, 0);
  for (const PanelSheet& sheet : output.sheets) {
    if (std::find(sheets.begin(), sheets.end(), sheet.name) == sheets.end()) continue;
    low = glm::min(low, sheet.low_px);
    high = glm::max(high, sheet.high_px);
  }
  low = glm::max(low - margin_px, Vec2(0, 0));
  high = glm::min(high + margin_px, size);
  if (low.x >= high.x || low.y >= high.y) {
    ADD_FAILURE() << "no sheet " << sheets.front();
    return image;
  }
  const auto x = static_cast<size_t>(low.x), y = static_cast<size_t>(low.y);
  render::Image part{static_cast<int>(high.x) - static_cast<int>(x),
                     static_cast<int>(high.y) - static_cast<int>(y),
                     {}};
  for (size_t row = 0; row < static_cast<size_t>(part.height); ++row) {
    const auto* from = &image.pixels[4 * ((y + row) * static_cast<size_t>(image.width) + x)];
    part.pixels.insert(part.pixels.end(), from, from + size_t{4} * static_cast<size_t>(part.width));
  }
  return part;
}

}  // namespace parti::app::tests
