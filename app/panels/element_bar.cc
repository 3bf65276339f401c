#include "app/panels/element_bar.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

constexpr float kHandle = 12;  ///< half a handle's side, with what a finger needs around it

struct Arrangement {
  Icon icon;
  const char* name;
};

/// In the order of ElementCommand.
constexpr std::array<Arrangement, kArrangements> kArrange = {{
    {Icon::kSameSize, "Same size"},
    {Icon::kAlignLeft, "Left edges in line"},
    {Icon::kCenterAcross, "Middles in line, across"},
    {Icon::kAlignRight, "Right edges in line"},
    {Icon::kAlignTop, "Top edges in line"},
    {Icon::kCenterUp, "Middles in line, in height"},
    {Icon::kAlignBottom, "Bottom edges in line"},
}};

/// Far beyond any window is far enough.
float Near(double px) { return static_cast<float>(std::clamp(px, -1e5, 1e5)); }

Box BoxOf(const Vec2& low, const Vec2& high) {
  return {Near(low.x), Near(low.y), Near(high.x), Near(high.y)};
}

std::string FiguresOf(const grammar::InteractiveLayer& layer) {
  return fmt::format("{} × {} m, {} m from the left, {} m up", PlainNumber(layer.width),
                     PlainNumber(layer.height), PlainNumber(layer.left), PlainNumber(layer.bottom));
}

void DrawHead(Ui* ui, const ElementInHand& element, Box head) {
  const Box close = head.CutRight(ui->U(kMeasures.target));
  if (ui->Button({.name = "Let go", .icon = Icon::kClose}, close).pressed) {
    ui->Send(ElementCommand::kLetGo);
  }
  Box words = head.Inset(ui->U(8), ui->U(3));
  ui->Text(element.layer.name, words.CutTop(words.height() / 2), {Letter::kStrong});
  ui->Text(FiguresOf(element.layer), words, {Letter::kSmall, Tone::kQuiet});
}

void DrawBy(Ui* ui, const ElementInHand& element, const Box& row) {
  const std::string by = element.by.empty() ? "the whole face" : element.by;
  const ButtonLook look{.name = "By the next",
                        .icon = Icon::kRight,
                        .label = "Arrange by " + by,
                        .enabled = element.by_others};
  if (ui->Button(look, row).pressed) ui->Send(ElementCommand::kByNext);
}

void DrawArrangements(Ui* ui, const ElementInHand& element, const Box& row) {
  Box rest = row;
  for (size_t i = 0; i < kArrangements; ++i) {
    const Box at = rest.CutLeft(ui->U(kMeasures.target), ui->U(kMeasures.gap));
    const ButtonLook look{
        .name = kArrange[i].name, .icon = kArrange[i].icon, .enabled = element.changes[i]};
    const Press press = ui->Button(look, at);
    if (press.hovered) ui->Note(look.name, row);  // beside all of them, and over none
    if (press.pressed) ui->Send(static_cast<ElementCommand>(i));
  }
}

}  // namespace

std::vector<Box> HandlesOf(const Ui& ui) {
  std::vector<Box> boxes;
  for (const SeenElement& element : ui.view().elements) {
    boxes.push_back(BoxOf(element.low_px, element.high_px));
    for (const Vec2& px : element.handles_px) {
      boxes.push_back(BoxOf(px, px).Inset(-ui.U(kHandle)));
    }
  }
  return boxes;
}

void DrawElementBar(Ui* ui, Memory* memory) {
  const auto& element = ui->view().element;
  if (!element) return;
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  constexpr auto kButtons = static_cast<float>(kArrangements);
  std::vector<Box> clear_of = HandlesOf(*ui);
  clear_of.push_back(memory->queries.at);
  const Box sheet =
      memory->element.Stand({BoxOf(element->low_px, element->high_px).Inset(-ui->U(kHandle)),
                             kButtons * (side + gap) + gap, 3 * side + 4 * gap, memory->layout.free,
                             ui->view().pen.position_px, ui->view().settings.left_handed,
                             ui->scale(), std::move(clear_of)});
  ui->BeginSheet("Element", sheet);
  Box rest = sheet.Inset(gap);
  const Box head = rest.CutTop(side, gap);
  ui->Hairline(head);
  DrawHead(ui, *element, head);
  DrawBy(ui, *element, rest.CutTop(side, gap));
  DrawArrangements(ui, *element, rest);
  ui->EndSheet();
}

}  // namespace parti::app::panels
