#include "app/panels/rules_sheet.h"

#include "app/panels/layers_sheet.h"
#include "app/panels/text_sheet.h"
#include "app/panels/tree_rows.h"
#include "app/panels/words.h"
#include "grammar/query.h"

namespace parti::app::panels {
namespace {

/// A row with its texts and their heights.
struct RowText {
  TreeRow row;
  std::string words, query;
  float indent = 0, words_height = 0, query_height = 0, notes_height = 0, height = 0;
  bool in_hand = false;
};

constexpr float kSwitchWidth = 48;

float WordsWidth(Ui* ui, const RowText& text, float width) {
  return width - text.indent - ui->U(38 + kSwitchWidth + 4);
}

RowText TextsOf(Ui* ui, TreeRow row, const NodePath& in_hand, float width) {
  RowText text;
  text.in_hand = row.node && row.path == in_hand;
  text.indent = ui->U(11) * static_cast<float>(std::min(row.depth, 7));
  text.words = row.tree ? row.tree->name : WordsOf(row.node->action);
  if (row.node) text.query = grammar::TextOf(row.node->query);
  text.row = std::move(row);
  const Box room{0, 0, WordsWidth(ui, text, width), 0};
  text.words_height = ui->Paragraph(text.words, room, {}, false);
  if (!text.query.empty()) {
    text.query_height = ui->Paragraph(text.query, room, {Letter::kSmall}, false);
  }
  for (const std::string& note : text.row.notes) {
    text.notes_height += ui->Paragraph(note, room, {Letter::kSmall}, false) + ui->U(2);
  }
  const float texts = text.words_height + text.query_height + text.notes_height + ui->U(12);
  text.height = std::max(ui->U(kMeasures.target + 2), texts);
  return text;
}

void DrawTexts(Ui* ui, const RowText& text, Box box, Ground ground) {
  const Tone tone = text.row.runs ? Tone::kText : Tone::kOff;
  box.y0 += (box.height() - text.words_height - text.query_height - text.notes_height) / 2;
  ui->Paragraph(text.words, box.CutTop(text.words_height),
                {text.in_hand || text.row.tree ? Letter::kStrong : Letter::kBody, tone, ground});
  if (!text.query.empty()) {
    ui->Paragraph(text.query, box.CutTop(text.query_height),
                  {Letter::kSmall, text.row.runs ? Tone::kQuiet : Tone::kOff, ground});
  }
  for (const std::string& note : text.row.notes) {
    const TextLook look{Letter::kSmall, Tone::kWarning, ground};
    ui->Paragraph(note, box.CutTop(ui->Paragraph(note, box, look, false), ui->U(2)), look);
  }
}

/// Draws rows, and the line where what is dragged would go.
class RuleList {
 public:
  RuleList(Ui* ui, Memory* memory) : ui_(ui), memory_(memory) {}

  void Draw(const std::vector<RowText>& rows, Box list) {
    bool held = false;
    for (const RowText& text : rows) {
      const Box row = list.CutTop(text.height, ui_->U(2));
      Row(text, row);
      if (!text.in_hand) continue;
      const Box strip = list.CutTop(ui_->U(kMeasures.target), ui_->U(2));
      held = Strip(text, strip);
      Show(text.row.path, {row.x0, row.y0, row.x1, strip.y1});
    }
    if (memory_->dragged_node.empty() || held) return;
    if (drop_ && ui_->pointer_px().x >= 0) ui_->Send(Command(Move{memory_->dragged_node, *drop_}));
    memory_->dragged_node.clear();
  }

 private:
  /// What was just taken in hand, in the drawing or by a key, comes into sight.
  void Show(const NodePath& path, const Box& box) {
    if (memory_->shown_node == path) return;
    memory_->shown_node = path;
    ui_->ScrollTo(box);
  }

  void Row(const RowText& text, const Box& box) {
    const std::string path = PathText(text.row.path);
    Box rest = box;
    const Box toggle = rest.CutRight(ui_->U(kSwitchWidth));
    const Press press = ui_->Area(path + " " + text.words, rest);
    const bool lit = press.hovered && memory_->dragged_node.empty();
    const Ground ground = text.in_hand ? Ground::kChosen : lit ? Ground::kHover : Ground::kPanel;
    if (ground != Ground::kPanel) ui_->Fill(box, ground, kMeasures.small_radius);
    rest.CutLeft(text.indent);
    const Tone tone = text.row.runs ? text.in_hand ? Tone::kAccent : Tone::kQuiet : Tone::kOff;
    const Icon icon = text.row.node ? IconOf(text.row.node->action) : Icon::kRules;
    ui_->Picture(icon, rest.CutLeft(ui_->U(38)), tone, ground);
    DrawTexts(ui_, text, rest, ground);
    if (ui_->Switch("Run " + path, toggle, text.row.on, ground)) {
      ui_->Send(Command(Switch{text.row.path, !text.row.on}));
    }
    if (press.pressed && text.row.node) {
      ui_->Send(Command(Take{text.in_hand ? NodePath{} : text.row.path}));
    }
    if (!memory_->dragged_node.empty()) FindDrop(text.row, box);
  }

  /// What can be done with the node in hand; whether it is being dragged.
  bool Strip(const RowText& text, Box box) {
    const NodePath& path = text.row.path;
    const float side = ui_->U(kMeasures.target), gap = ui_->U(kMeasures.gap);
    const auto to = [&](int by) {
      NodePath there = path;
      there.back() += by;
      return Command(Move{path, there});
    };
    box.CutLeft(ui_->U(kMeasures.pad));
    const bool first = path.back() == 0, last = path.back() + 1 == text.row.siblings;
    const auto button = [&](const char* name, Icon icon, bool enabled) {
      const Box at = box.CutLeft(side, gap);
      return ui_->Button({.name = name, .icon = icon, .enabled = enabled}, at).pressed;
    };
    if (button("Move up", Icon::kUp, !first)) ui_->Send(to(-1));
    if (button("Move down", Icon::kDown, !last)) ui_->Send(to(1));
    const Press grip =
        ui_->Button({.name = "Drag to another place", .icon = Icon::kGrip}, box.CutLeft(side, gap));
    if (grip.held) {
      ui_->KeepDrag();
      memory_->dragged_node = path;
    }
    if (button("Delete", Icon::kDelete, true)) ui_->Send(Command(Delete{path}));
    return grip.held;
  }

  void FindDrop(const TreeRow& row, const Box& box) {
    const Vec2 at = ui_->pointer_px();
    if (at.y < box.y0 || at.y >= box.y1) return;
    const double part = (at.y - box.y0) / std::max(1.0f, box.height());
    const Drop drop = part < 0.3 ? Drop::kBefore : part > 0.7 ? Drop::kAfter : Drop::kInto;
    drop_ = DropPath(row, drop, memory_->dragged_node);
    if (!drop_) return;
    if (drop == Drop::kInto) {
      ui_->Accent(box);
    } else {
      const float y = drop == Drop::kBefore ? box.y0 : box.y1;
      ui_->Accent({box.x0, y - ui_->U(1), box.x1, y + ui_->U(1)});
    }
  }

  Ui* ui_;
  Memory* memory_;
  std::optional<NodePath> drop_;
};

constexpr const char* kNoRules =
    "Rules appear here as you draw: each suggestion that you tap becomes one.";
constexpr const char* kOnlyFiles =
    "This building is made by rule files: see them as text. What you draw is added here.";

std::vector<RowText> AllRows(Ui* ui, float width) {
  std::vector<RowText> rows;
  if (!ui->view().session) return rows;
  const SessionState& state = *ui->view().session->state;
  for (TreeRow& row : RowsOf(state)) {
    rows.push_back(TextsOf(ui, std::move(row), state.in_hand, width));
  }
  return rows;
}

float HeightOf(Ui* ui, const std::vector<RowText>& rows) {
  float height = 0;
  for (const RowText& row : rows) {
    height += row.height + ui->U(2);
    if (row.in_hand) height += ui->U(kMeasures.target + 2);
  }
  return height;
}

/// Of the list, in a sheet of this width.
float ListWidth(Ui* ui, float width) { return width - ui->U(2 * kMeasures.gap); }

bool HasFiles(const Ui& ui) {
  return ui.view().session && ui.view().session->state->model.ground->source;
}

/// What is shown: what was asked for, where there is any.
RulesAs ShownAs(const Ui& ui, Memory* memory, bool has_rows) {
  if (memory->rules_as == RulesAs::kText && (has_rows || HasFiles(ui))) return RulesAs::kText;
  if (memory->rules_as == RulesAs::kLayers && HasLayers(ui, memory)) return RulesAs::kLayers;
  return RulesAs::kRows;
}

/// Buttons that show the rules in another way, and back.
void DrawWays(Ui* ui, Memory* memory, bool has_rows, Box* head) {
  const RulesAs shown = ShownAs(*ui, memory, has_rows);
  const auto way = [&](const char* name, RulesAs as, float width) {
    const ButtonLook look{.name = name, .label = name, .chosen = shown == as};
    if (!ui->Button(look, head->CutRight(ui->U(width), ui->U(4))).pressed) return;
    memory->rules_as = shown == as ? RulesAs::kRows : as;
  };
  if (has_rows || HasFiles(*ui)) way("As text", RulesAs::kText, 88);
  if (HasLayers(*ui, memory)) way("Layers", RulesAs::kLayers, 80);
}

/// Where there are no rows.
const char* WordsFor(const Ui& ui) { return HasFiles(ui) ? kOnlyFiles : kNoRules; }

float ListHeight(Ui* ui, Memory* memory, const std::vector<RowText>& rows, float width) {
  switch (ShownAs(*ui, memory, !rows.empty())) {
    case RulesAs::kText:
      return RulesTextHeight(ui, memory, width);
    case RulesAs::kLayers:
      return LayersHeight(ui, memory, width);
    case RulesAs::kRows:
      break;
  }
  if (!rows.empty()) return HeightOf(ui, rows);
  const Box room{0, 0, width - ui->U(16), 0};
  return ui->Paragraph(WordsFor(*ui), room, {}, false) + ui->U(20);
}

void DrawList(Ui* ui, Memory* memory, const std::vector<RowText>& rows, const Box& list) {
  switch (ShownAs(*ui, memory, !rows.empty())) {
    case RulesAs::kText:
      return DrawRulesText(ui, memory, list);
    case RulesAs::kLayers:
      return DrawLayers(ui, memory, list);
    case RulesAs::kRows:
      return RuleList(ui, memory).Draw(rows, list);
  }
}

}  // namespace

float RulesHeight(Ui* ui, Memory* memory, float width) {
  const float list = ListWidth(ui, width), head = ui->U(kMeasures.target + 3 * kMeasures.gap);
  return head + ListHeight(ui, memory, AllRows(ui, list), list);
}

void DrawRules(Ui* ui, Memory* memory, const Box& box) {
  ui->BeginSheet("Rules", box);
  const float gap = ui->U(kMeasures.gap), width = ListWidth(ui, box.width());
  Box rest = box.Inset(gap);
  Box head = rest.CutTop(ui->U(kMeasures.target), gap);
  ui->Hairline(head);
  const std::vector<RowText> rows = AllRows(ui, width);
  DrawWays(ui, memory, !rows.empty(), &head);
  ui->Text("Rules", head.Inset(ui->U(8), 0), {Letter::kStrong});
  if (rows.empty() && ShownAs(*ui, memory, false) == RulesAs::kRows) {
    ui->Paragraph(WordsFor(*ui), rest.Inset(ui->U(8)), {Letter::kBody, Tone::kQuiet});
    return ui->EndSheet();
  }
  constexpr const char* kNames[] = {"list", "text", "layers"};
  const RulesAs shown = ShownAs(*ui, memory, !rows.empty());
  DrawList(
      ui, memory, rows,
      ui->BeginList(kNames[static_cast<size_t>(shown)], rest, ListHeight(ui, memory, rows, width)));
  ui->EndList();
  ui->EndSheet();
}

}  // namespace parti::app::panels
