#include "app/panels/suggestions.h"

#include <fmt/format.h>

#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

using sketch::Suggestion;

/// Around the last stroke, where it was drawn in this view; else nothing.
std::optional<Box> LastStroke(const SessionState& state, const Vec2& size_px) {
  if (state.sketch.strokes.empty()) return std::nullopt;
  const DrawnStroke& last = *state.sketch.strokes.back();
  if (!(last.camera == state.camera) || last.stroke.empty()) return std::nullopt;
  // The window may have another size since.
  const Vec2 zoom = size_px / Vec2(state.camera.width_px, state.camera.height_px);
  Box box{1e6f, 1e6f, -1e6f, -1e6f};
  for (const StrokeSample& sample : last.stroke) {
    const Vec2 at = sample.position * zoom;
    const auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
    box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
  }
  return box;
}

/// One card's sizes.
struct CardText {
  std::string words, symbols;
  float words_height = 0, height = 0;
};

CardText CardOf(Ui* ui, const Suggestion& suggestion, float width) {
  CardText card{WordsOf(suggestion.action), SymbolsOf(suggestion.action)};
  const Box room{0, 0, width - ui->U(44 + 12), 0};
  card.words_height = ui->Paragraph(card.words, room, {}, false);
  const float below = card.symbols.empty() ? 0 : ui->LineHeight(Letter::kSmall);
  card.height = std::max(ui->U(kMeasures.target), card.words_height + below + ui->U(14));
  return card;
}

Press DrawCard(Ui* ui, const CardText& card, const Suggestion& suggestion, size_t i, Box box) {
  const Press press = ui->Area(fmt::format("{} {}", i + 1, card.words), box);
  const bool lit = press.hovered || press.held;
  const Ground ground = lit ? Ground::kHover : i == 0 ? Ground::kChosen : Ground::kPanel;
  if (ground != Ground::kPanel) ui->Fill(box, ground, kMeasures.small_radius);
  const Tone tone = i == 0 && !lit ? Tone::kAccent : Tone::kText;
  ui->Picture(IconOf(suggestion.action), box.CutLeft(ui->U(44)), tone, ground);
  box = box.Inset(0, ui->U(7));
  box.x1 -= ui->U(12);
  if (card.symbols.empty()) box.y0 += (box.height() - card.words_height) / 2;
  ui->Paragraph(card.words, box.CutTop(card.words_height), {Letter::kBody, Tone::kText, ground});
  if (!card.symbols.empty()) {
    ui->Text(card.symbols, box.CutTop(ui->LineHeight(Letter::kSmall)),
             {Letter::kSmall, Tone::kQuiet, ground});
  }
  return press;
}

}  // namespace

std::optional<size_t> DrawSuggestions(Ui* ui, Memory* memory) {
  if (!ui->view().session) return std::nullopt;
  const SessionState& state = *ui->view().session->state;
  const auto& suggestions = state.sketch.suggestions;
  if (suggestions.empty()) return std::nullopt;

  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  const float width = ui->U(kMeasures.card), inner = width - 2 * gap;
  std::vector<CardText> cards;
  float content = 0;
  for (const Suggestion& suggestion : suggestions) {
    cards.push_back(CardOf(ui, suggestion, inner));
    content += cards.back().height + ui->U(2);
  }
  const Box free = memory->layout.free;
  const float height = std::min({content + side + 3 * gap, ui->U(340), free.height()});
  const Box stroke =
      LastStroke(state, ui->view().size_px).value_or(BoxAt(free.middle_x(), free.middle_y(), 1, 1));
  const Box sheet = memory->suggestions.Stand({stroke,
                                               width,
                                               height,
                                               free,
                                               ui->view().pen.position_px,
                                               ui->view().settings.left_handed,
                                               ui->scale(),
                                               {}});
  ui->BeginSheet("Suggestions", sheet);

  Box rest = sheet.Inset(gap);
  Box head = rest.CutTop(side, gap);
  if (ui->Button({.name = "Clear the sketch", .icon = Icon::kClose}, head.CutRight(side)).pressed) {
    ui->Send(Command(ClearSketch{}));
  }
  ui->Text("Did you mean", head.Inset(ui->U(8), 0), {Letter::kStrong, Tone::kText});
  std::optional<size_t> preview;
  Box list = ui->BeginList("list", rest, content);
  for (size_t i = 0; i < cards.size(); ++i) {
    const Box box = list.CutTop(cards[i].height, ui->U(2));
    const Press press = DrawCard(ui, cards[i], suggestions[i], i, box);
    const std::string full = fmt::format("Suggestions/{} {}", i + 1, cards[i].words);
    if (press.hovered || press.held || ui->focus() == full) preview = i;
    if (press.pressed) {
      ui->Send(Command(
          Pick{static_cast<int>(i + 1), std::string(suggestions[i].action.operation->name)}));
    }
  }
  ui->EndList();
  ui->EndSheet();
  return preview;
}

}  // namespace parti::app::panels
