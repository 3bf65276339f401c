// Property 1 of Canvas: repaired pixels are those of a canvas drawn whole, whatever happened.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/canvas_target.h"

namespace parti::render {
namespace {

using tests::CanvasTarget;

constexpr glm::ivec2 kSize{96, 64};
constexpr Vec4f kColors[] = {{0.05f, 0.1f, 0.45f, 1}, {0.8f, 0.1f, 0.1f, 0.5f}};

float Anywhere(int most) { return static_cast<float>(*rc::gen::inRange(-20, most + 20)); }

std::vector<Vec2f> SomePoints() {
  std::vector<Vec2f> points;
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
    const bool senseless = *rc::gen::inRange(0, 20) == 0;
    points.emplace_back(senseless ? NAN : Anywhere(kSize.x), Anywhere(kSize.y));
  }
  return points;
}

std::vector<float> Widths(size_t n) {
  std::vector<float> widths;
  for (; n > 0; --n) widths.push_back(static_cast<float>(*rc::gen::inRange(-1, 12)));
  return widths;
}

Mark SomeMark() {
  return {SomePoints(), kColors[*rc::gen::inRange(0, 2)],
          static_cast<float>(*rc::gen::inRange(0, 5)), static_cast<float>(*rc::gen::inRange(0, 8))};
}

UiMesh SomePanels() {
  UiMesh mesh;
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    const uint32_t rgba = 0x90000000u | static_cast<uint32_t>(*rc::gen::inRange(0, 1 << 24));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back({{Anywhere(kSize.x), Anywhere(kSize.y)}, {0, 0}, rgba});
      mesh.indices.push_back(first + static_cast<uint32_t>(corner));
    }
    mesh.commands.push_back({{*rc::gen::inRange(0, 50), *rc::gen::inRange(0, 30), 40, 30},
                             1,
                             static_cast<uint32_t>(mesh.indices.size() - 3),
                             3,
                             static_cast<uint32_t>(*rc::gen::inRange(0, 3))});
  }
  return mesh;
}

/// What an application might keep track of: which strokes it wants.
struct Wanted {
  uint64_t next_id = 1;
  std::vector<InkStroke> strokes;
};

void ChangeStrokes(Canvas* canvas, Wanted* wanted) {
  std::vector<InkStroke>& strokes = wanted->strokes;
  if (!strokes.empty() && *rc::gen::inRange(0, 2)) {
    strokes.erase(strokes.begin() + *rc::gen::inRange<ptrdiff_t>(0, std::ssize(strokes)));
  }
  if (*rc::gen::inRange(0, 3) == 0) std::reverse(strokes.begin(), strokes.end());
  const std::vector<Vec2f> points = SomePoints();
  const Ink ink{points, Widths(points.size()), kColors[*rc::gen::inRange(0, 2)]};
  strokes.push_back({wanted->next_id++, std::make_shared<Ink>(ink)});
  canvas->SetStrokes(strokes);
}

void ChangePicture(CanvasTarget* target) {
  CanvasPicture picture = tests::PlainPicture(
      target->gl(), {*rc::gen::inRange(1, 99), *rc::gen::inRange(1, 99)}, {0.8f, 0.9f, 0.7f});
  if (*rc::gen::inRange(0, 2)) picture.picture_from_canvas[2][0] = *rc::gen::inRange(-9, 9);
  target->canvas().SetPicture(picture);
}

void FadePanels(Canvas* canvas) {
  std::vector<float> opacities;
  for (int n = *rc::gen::inRange(0, 4); n > 0; --n) {
    opacities.push_back(static_cast<float>(*rc::gen::inRange(0, 5)) / 4);
  }
  canvas->SetPanelOpacities(opacities);
}

void DoSomething(CanvasTarget* target, Wanted* wanted) {
  Canvas& canvas = target->canvas();
  const std::vector<Vec2f> points = SomePoints();
  switch (*rc::gen::inRange(0, 12)) {
    case 0:
      return canvas.BeginStroke(wanted->next_id++, kColors[*rc::gen::inRange(0, 2)]);
    case 1:
    case 2:
    case 3:
      return canvas.AddSamples(points, Widths(points.size()));
    case 4:
      return canvas.SetPrediction(points, Widths(points.size()));
    case 5:
      return canvas.EndStroke();
    case 6:
      return canvas.CancelStroke();
    case 7:
      return ChangeStrokes(&canvas, wanted);
    case 8:
      return *rc::gen::inRange(0, 2) ? canvas.SetMarksBelowPanels({SomeMark(), SomeMark()})
                                     : canvas.SetMarksAbovePanels({SomeMark()});
    case 9:
      return canvas.SetPanels(SomePanels());
    case 10:
      return FadePanels(&canvas);
    default:
      if (*rc::gen::inRange(0, 3)) return ChangePicture(target);
      return target->Resize({*rc::gen::inRange(1, 120), *rc::gen::inRange(1, 80)});
  }
}

int GreatestDifference(const Image& a, const Image& b) {
  int most = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    most = std::max(most, std::abs(int{a.pixels[i]} - int{b.pixels[i]}));
  }
  return most;
}

void CheckRepairs(OffscreenTarget kind) {
  const int buffers = *rc::gen::inRange(1, 4);
  const auto target = CanvasTarget::Create(kind, kSize, buffers);
  if (!target) return;
  (void)target->canvas().SetPanelTexture(1, {1, 1, {255, 255, 255, 255}});
  Wanted wanted;
  for (int frames = *rc::gen::inRange(1, 12); frames > 0; --frames) {
    for (int changes = *rc::gen::inRange(0, 4); changes > 0; --changes) {
      DoSomething(target.get(), &wanted);
    }
    (void)target->Draw();
    const Image repaired = target->Shown();
    const Image whole = target->Whole();
    RC_ASSERT(repaired.width == whole.width && repaired.height == whole.height);
    RC_ASSERT(GreatestDifference(repaired, whole) <= 2);
  }
}

RC_GTEST_PROP(CanvasDamage, Property1_RepairedPixelsAreThoseOfACanvasDrawnWhole_OsMesa, ()) {
  CheckRepairs(OffscreenTarget::kOsMesa);
}
RC_GTEST_PROP(CanvasDamage, Property1_RepairedPixelsAreThoseOfACanvasDrawnWhole_Egl, ()) {
  CheckRepairs(OffscreenTarget::kEglSurfaceless);
}

Image DrawnAtOnce(const std::vector<InkStroke>& strokes) {
  const auto fresh = CanvasTarget::Create(OffscreenTarget::kBest, kSize);
  fresh->canvas().SetStrokes(strokes);
  (void)fresh->Draw();
  return fresh->Shown();
}

InkStroke DrawBitByBit(CanvasTarget* target, uint64_t id) {
  auto ink = std::make_shared<Ink>();
  ink->color = kColors[*rc::gen::inRange(0, 2)];
  target->canvas().BeginStroke(id, ink->color);
  for (int batches = *rc::gen::inRange(0, 4); batches > 0; --batches) {
    const std::vector<Vec2f> points = SomePoints();
    const std::vector<float> widths = Widths(points.size());
    target->canvas().AddSamples(points, widths);
    target->canvas().SetPrediction(SomePoints(), {});
    if (*rc::gen::inRange(0, 3)) (void)target->Draw();
    ink->points.insert(ink->points.end(), points.begin(), points.end());
    ink->widths_px.insert(ink->widths_px.end(), widths.begin(), widths.end());
  }
  return {id, ink};
}

RC_GTEST_PROP(CanvasDamage, InkThatGrewAndWentIsInkDrawnAtOnce, ()) {
  const auto target = CanvasTarget::Create(OffscreenTarget::kBest, kSize);
  Canvas& canvas = target->canvas();
  std::vector<InkStroke> strokes;
  for (uint64_t id = 0, last = *rc::gen::inRange(1, 6); id <= last; ++id) {
    const InkStroke stroke = DrawBitByBit(target.get(), id);
    if (*rc::gen::inRange(0, 4) == 0) {
      canvas.CancelStroke();
    } else {
      canvas.EndStroke();
      strokes.push_back(stroke);
    }
    if (!strokes.empty() && *rc::gen::inRange(0, 4) == 0) {
      strokes.erase(strokes.begin() + *rc::gen::inRange<ptrdiff_t>(0, std::ssize(strokes)));
    }
    canvas.SetStrokes(strokes);
  }
  (void)target->Draw();
  const Image grown = target->Shown();
  RC_ASSERT(GreatestDifference(grown, DrawnAtOnce(strokes)) <= 2);
}

}  // namespace
}  // namespace parti::render
