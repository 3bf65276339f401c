#include "app/panels/queries.h"

#include <fmt/format.h>

#include "app/panels/element_bar.h"
#include "app/panels/node_sheet.h"
#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

using grammar::SelectionActionNode;

/// One card's texts and heights.
struct QueryCard {
  std::string reading, query, count;
  bool chosen = false;
  float reading_height = 0, query_height = 0, height = 0;
};

constexpr float kMark = 30;  ///< room for that of the chosen one, units

float WordsWidth(Ui* ui, float width) { return width - ui->U(12 + kMark + 56); }

QueryCard CardOf(Ui* ui, const grammar::QueryCandidate& candidate, bool chosen, float width) {
  QueryCard card{Capital(candidate.reading), grammar::TextOf(candidate.query),
                 fmt::format("{}", candidate.count), chosen};
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
  const Ground ground = lit ? Ground::kHover : card.chosen ? Ground::kChosen : Ground::kPanel;
  if (ground != Ground::kPanel) ui->Fill(box, ground, kMeasures.small_radius);
  const Box count = box.CutRight(ui->U(56));
  ui->Text(card.count, {count.x0, count.y0, count.x1 - ui->U(12), count.y1},
           {Letter::kStrong, Tone::kAccent, ground, 1});
  const Box mark = box.CutRight(ui->U(kMark));
  if (card.chosen) ui->Picture(Icon::kCheck, mark, Tone::kAccent, ground);
  box.x0 += ui->U(12);
  box.y0 += (box.height() - card.reading_height - card.query_height) / 2;
  ui->Paragraph(card.reading, box.CutTop(card.reading_height),
                {Letter::kBody, Tone::kText, ground});
  ui->Paragraph(card.query, box.CutTop(card.query_height), {Letter::kSmall, Tone::kQuiet, ground});
  return press;
}

std::string TitleOf(const SelectionActionNode* node) {
  return node ? fmt::format("What is {} to act on?", WordsOf(node->action)) : "Which do you mean?";
}

/// What the cards would change: the query that is in force now, which may be none of theirs.
std::optional<grammar::Query> InForce(const SessionState& state, const SelectionActionNode* node) {
  return node ? node->query : state.sketch.query;
}

void Choose(Ui* ui, size_t i, const SelectionActionNode* node) {
  // One that is in hand and not shown is not what the card said.
  if (!node && !ui->view().session->state->in_hand.empty()) ui->Send(Command(Take{}));
  ui->Send(Command(SetQuery{fmt::format("{}", i + 1)}));
}

}  // namespace

std::optional<size_t> DrawQueries(Ui* ui, Memory* memory) {
  if (!ui->view().session) return std::nullopt;
  const SessionState& state = *ui->view().session->state;
  const Selection& selection = state.selection;
  if (selection.shapes.empty()) return std::nullopt;
  const SelectionActionNode* node = NodeShown(ui->view(), *memory);
  const auto in_force = InForce(state, node);
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  const float width = ui->U(kMeasures.card + 40), inner = width - 2 * gap;
  std::vector<QueryCard> cards;
  float content = 0;
  for (const auto& candidate : selection.candidates) {
    cards.push_back(CardOf(ui, candidate, candidate.query == in_force, inner));
    content += cards.back().height + ui->U(2);
  }
  const Box free = memory->layout.free;
  const std::string title = TitleOf(node);
  const Box title_room{0, 0, inner - side - ui->U(16), 0};
  const float title_height = ui->Paragraph(title, title_room, {Letter::kStrong}, false);
  const float head_height = std::max(side, title_height);
  const float height = std::min({content + head_height + 3 * gap, ui->U(420), free.height()});
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
  Box head = rest.CutTop(head_height, gap);
  const ButtonLook close{.name = "Select nothing", .icon = Icon::kClose};
  if (ui->Button(close, head.CutRight(side).CutTop(side)).pressed) ui->Send(Command(Select{}));
  head = head.Inset(ui->U(8), 0);
  head.y0 += (head.height() - title_height) / 2;
  ui->Paragraph(title, head, {Letter::kStrong});
  std::optional<size_t> preview;
  Box list = ui->BeginList("list", rest, content);
  for (size_t i = 0; i < cards.size(); ++i) {
    const Box box = list.CutTop(cards[i].height, ui->U(2));
    const Press press = DrawCard(ui, cards[i], i, box);
    const std::string full = fmt::format("Queries/{} {}", i + 1, cards[i].reading);
    if (press.hovered || press.held || ui->focus() == full) preview = i;
    if (press.pressed) Choose(ui, i, node);
  }
  ui->EndList();
  ui->EndSheet();
  return preview;
}

}  // namespace parti::app::panels
