#include "app/panels/queries.h"

#include <fmt/format.h>

#include "app/panels/element_bar.h"
#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

/// One card's texts and heights.
struct QueryCard {
  std::string reading, query, count;
  float reading_height = 0, query_height = 0, height = 0;
};

float WordsWidth(Ui* ui, float width) { return width - ui->U(12 + 56); }

QueryCard CardOf(Ui* ui, const grammar::QueryCandidate& candidate, float width) {
  QueryCard card{Capital(candidate.reading), grammar::TextOf(candidate.query),
                 fmt::format("{}", candidate.count)};
  const Box room{0, 0, WordsWidth(ui, width), 0};
  card.reading_height = ui->Paragraph(card.reading, room, {}, false);
  card.query_height = ui->Paragraph(card.query, room, {Letter::kSmall}, false);
  card.height =
      std::max(ui->U(kMeasures.target), card.reading_height + card.query_height + ui->U(14));
  return card;
}

Press DrawCard(Ui* ui, const QueryCard& card, size_t i, Box box) {
  const Press press = ui->Area(fmt::format("{} {}", i + 1, card.reading), box);
  const bool lit = press.hovered || press.held;
  const Ground ground = lit ? Ground::kHover : i == 0 ? Ground::kChosen : Ground::kPanel;
  if (ground != Ground::kPanel) ui->Fill(box, ground, kMeasures.small_radius);
  const Box count = box.CutRight(ui->U(56));
  ui->Text(card.count, {count.x0, count.y0, count.x1 - ui->U(12), count.y1},
           {Letter::kStrong, Tone::kAccent, ground, 1});
  box.x0 += ui->U(12);
  box.y0 += (box.height() - card.reading_height - card.query_height) / 2;
  ui->Paragraph(card.reading, box.CutTop(card.reading_height),
                {Letter::kBody, Tone::kText, ground});
  ui->Paragraph(card.query, box.CutTop(card.query_height), {Letter::kSmall, Tone::kQuiet, ground});
  return press;
}

}  // namespace

std::optional<size_t> DrawQueries(Ui* ui, Memory* memory) {
  if (!ui->view().session) return std::nullopt;
  const Selection& selection = ui->view().session->state->selection;
  if (selection.shapes.empty()) return std::nullopt;
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  const float width = ui->U(kMeasures.card + 40), inner = width - 2 * gap;
  std::vector<QueryCard> cards;
  float content = 0;
  for (const auto& candidate : selection.candidates) {
    cards.push_back(CardOf(ui, candidate, inner));
    content += cards.back().height + ui->U(2);
  }
  const Box free = memory->layout.free;
  const float height = std::min({content + side + 3 * gap, ui->U(420), free.height()});
  const Vec2 tap = ui->view().tapped_px.value_or(Vec2(free.middle_x(), free.middle_y()));
  const float reach = ui->U(20);
  const auto x = static_cast<float>(tap.x), y = static_cast<float>(tap.y);
  const Box sheet = memory->queries.Stand({{x - reach, y - reach, x + reach, y + reach},
                                           width,
                                           height,
                                           free,
                                           ui->view().pen.position_px,
                                           ui->view().settings.left_handed,
                                           ui->scale(),
                                           HandlesOf(*ui)});
  ui->BeginSheet("Queries", sheet);
  Box rest = sheet.Inset(gap);
  Box head = rest.CutTop(side, gap);
  const ButtonLook close{.name = "Select nothing", .icon = Icon::kClose};
  if (ui->Button(close, head.CutRight(side)).pressed) ui->Send(Command(Select{}));
  ui->Text("Which do you mean?", head.Inset(ui->U(8), 0), {Letter::kStrong});
  std::optional<size_t> preview;
  Box list = ui->BeginList("list", rest, content);
  for (size_t i = 0; i < cards.size(); ++i) {
    const Box box = list.CutTop(cards[i].height, ui->U(2));
    const Press press = DrawCard(ui, cards[i], i, box);
    const std::string full = fmt::format("Queries/{} {}", i + 1, cards[i].reading);
    if (press.hovered || press.held || ui->focus() == full) preview = i;
    if (press.pressed) ui->Send(Command(SetQuery{fmt::format("{}", i + 1)}));
  }
  ui->EndList();
  ui->EndSheet();
  return preview;
}

}  // namespace parti::app::panels
