#include "app/panels/node_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/edit_nodes.h"
#include "app/panels/node_words.h"
#include "app/panels/rules_text.h"
#include "app/panels/words.h"
#include "grammar/operation.h"
#include "grammar/query.h"

namespace parti::app::panels {
namespace {

using grammar::Action;
using grammar::Dial;
using grammar::ParameterKind;
using grammar::SelectionActionNode;

/// A number of the node, and what the table says of it.
struct NumberRow {
  Dial dial;
  std::string label, range, unit;
  std::optional<double> usual;  ///< its default
};

const grammar::Parameter* ParameterNamed(const Action& action, std::string_view name) {
  const auto parameters = action.operation->parameters;
  const auto at = std::find_if(parameters.begin(), parameters.end(),
                               [&](const auto& p) { return p.name == name; });
  return at == parameters.end() ? nullptr : &*at;
}

/// Whether a size only says how it shares the rest with others: it stretches, and is not repeated.
bool IsShare(const Action& action, int number) {
  const grammar::Successor* successor = &grammar::SuccessorAt(action, number);
  const auto* size = std::get_if<grammar::Size>(&successor->key);
  const bool repeated = action.operation->name == "repeat" ||
                        std::none_of(action.successors.begin(), action.successors.end(),
                                     [&](const auto& s) { return &s == successor; });
  return size && size->kind == grammar::Size::Kind::kFloating && !repeated;
}

std::string UnitOfDial(const Action& action, const Dial& dial) {
  int number = 0;
  const bool is_size = std::sscanf(dial.name.c_str(), "sizes[%d]", &number) == 1 && number >= 0;
  return is_size && IsShare(action, number) ? "" : UnitOf(dial.kind);
}

/// "Size of Ground" for sizes[0].
std::string LabelOf(const Action& action, const Dial& dial) {
  std::string label = dial.name;
  const grammar::Parameter* parameter = ParameterNamed(action, dial.name);
  if (parameter && parameter->kind == ParameterKind::kAngle &&
      dial.kind == ParameterKind::kLength) {
    label = "height";  // of a roof
  }
  int number = 0;
  if (std::sscanf(dial.name.c_str(), "sizes[%d]", &number) == 1 && number >= 0) {
    const grammar::Successor& successor = grammar::SuccessorAt(action, number);
    const auto* size = std::get_if<grammar::Size>(&successor.key);
    const bool part = size && size->kind == grammar::Size::Kind::kRelative;
    const bool share = size && IsShare(action, number);
    label = successor.symbol.empty() ? fmt::format("{}", number + 1) : successor.symbol;
    label = (part ? "part of " : share ? "share of " : "size of ") + label;
  }
  return Capital(label);
}

std::vector<NumberRow> NumbersOf(Action* action) {
  std::vector<NumberRow> rows;
  for (const Dial& dial : grammar::Dials(action)) {
    NumberRow row{dial, LabelOf(*action, dial), {}, {}, {}};
    row.unit = UnitOfDial(*action, dial);
    const std::string& unit = row.unit;
    row.range = fmt::format("{} to {}{}", PlainNumber(dial.low), PlainNumber(dial.high),
                            unit.empty() ? "" : " " + unit);
    if (const auto* parameter = ParameterNamed(*action, dial.name)) {
      if (const auto* usual = std::get_if<double>(&parameter->default_value)) row.usual = *usual;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<std::string> Symbols(const Action& action) {
  std::vector<std::string> symbols;
  const std::string all = SymbolsOf(action);
  for (size_t from = 0; from < all.size();) {
    const size_t comma = std::min(all.find(", ", from), all.size());
    symbols.push_back(all.substr(from, comma - from));
    from = comma + 2;
  }
  return symbols;
}

double StepOf(ParameterKind kind) {
  return kind == ParameterKind::kLength ? 0.05 : kind == ParameterKind::kAngle ? 1 : 0.01;
}

/// Draws row after row, or only measures where `draw` is false.
class NodeRows {
 public:
  NodeRows(Ui* ui, const SelectionActionNode& node, const Box& room, bool draw)
      : ui_(ui), node_(node), rest_(room), top_(room.y0), draw_(draw) {}

  float Run() {
    Action action = node_.action;
    Query();
    for (const NumberRow& row : NumbersOf(&action)) Number(row);
    for (const WordPick& pick : WordPicksOf(node_.action)) Word(pick);
    bool first = true;
    for (const std::string& symbol : Symbols(node_.action)) {
      Symbol(symbol, first);
      first = false;
    }
    return y_;
  }

 private:
  /// The next `height` px; measuring counts them, drawing cuts them off.
  Box Take(float height, float gap_units) {
    y_ += height + ui_->U(gap_units);
    const Box box{rest_.x0, top_, rest_.x1, top_ + height};
    top_ += height + ui_->U(gap_units);
    return box;
  }

  void Label(const std::string& label, const std::string& beside) {
    const Box box = Take(ui_->LineHeight(Letter::kSmall), 3);
    if (!draw_) return;
    const float width = ui_->TextWidth(label, Letter::kSmall) + ui_->U(10);
    ui_->Text(label, {box.x0, box.y0, box.x1, box.y1}, {Letter::kSmall, Tone::kQuiet});
    ui_->Text(beside, {std::min(box.x0 + width, box.x1), box.y0, box.x1, box.y1},
              {Letter::kSmall, Tone::kQuiet, Ground::kPanel, 1});
  }

  void Query() {
    Label("Acts on", "");
    const Box box = Take(ui_->U(kMeasures.target), 10);
    if (!draw_) return;
    if (const auto typed = ui_->Field("Acts on", box, grammar::TextOf(node_.query))) {
      ui_->SendTyped(SetQuery{*typed});
    }
  }

  void Number(const NumberRow& row) {
    const double value = *row.dial.value;
    const bool changed = row.usual && *row.usual != value;
    Label(row.label, row.range);
    Box box = Take(ui_->U(kMeasures.target), 3);
    if (draw_) {
      const NumberLook look{row.dial.name,         value,    row.dial.low, row.dial.high,
                            StepOf(row.dial.kind), row.unit, changed};
      const NumberWish wish = ui_->Number(look, box);
      if (wish.trial) ui_->Try({row.dial.name, *wish.trial});
      if (wish.commit) ui_->SendTyped(SetNumber{row.dial.name, *wish.commit});
    }
    if (row.usual) Usual(row, changed);
    Take(0, 7);
  }

  /// The default: named, and to be had again where it was overridden.
  void Usual(const NumberRow& row, bool changed) {
    const std::string& unit = row.unit;
    const std::string number = PlainNumber(*row.usual) + (unit.empty() ? "" : " " + unit);
    const Box box = Take(ui_->U(changed ? kMeasures.target : 20), 0);
    if (!draw_) return;
    if (!changed) {
      return ui_->Text("As usual: " + number, box, {Letter::kSmall, Tone::kQuiet});
    }
    const ButtonLook look{.name = "Usual " + row.dial.name,
                          .icon = Icon::kReset,
                          .label = "Back to the usual " + number};
    if (ui_->Button(look, box).pressed) ui_->SendTyped(SetNumber{row.dial.name, *row.usual});
  }

  void Word(const WordPick& pick) {
    const Box box = Take(WordPickHeight(ui_, pick), 0);
    if (!draw_) return;
    auto picked = DrawWordPick(ui_, pick, box);
    if (!picked) return;
    const SessionState& state = *ui_->view().session->state;
    grammar::Trees trees = state.model.trees();
    NodeAt(&trees, state.in_hand).action.arguments[pick.argument] = std::move(*picked);
    ui_->SendTyped(RewriteAs(trees));
  }

  void Symbol(const std::string& symbol, bool first) {
    if (first) Label("Gives", "");
    const Box box = Take(ui_->U(kMeasures.target), 6);
    if (!draw_) return;
    if (const auto typed = ui_->Field("Name of " + symbol, box, symbol)) {
      ui_->SendTyped(RenameSymbol{symbol, *typed});
    }
  }

  Ui* ui_;
  const SelectionActionNode& node_;
  Box rest_;
  float top_;
  bool draw_;
  float y_ = 0;
};

float HeadHeight(Ui* ui) { return ui->U(kMeasures.target); }

Box Rows(Ui* ui, const Box& box) {
  return {box.x0 + ui->U(12), box.y0, box.x1 - ui->U(12), box.y1};
}

}  // namespace

const SelectionActionNode* NodeInHand(const PanelView& view) {
  if (!view.session) return nullptr;
  const SessionState& state = *view.session->state;
  const NodePath& path = state.in_hand;
  const grammar::Trees& trees = state.model.trees();
  if (path.size() < 2 || path[0] < 0 || path[0] >= static_cast<int>(trees.size())) return nullptr;
  const std::vector<SelectionActionNode>* nodes = &trees[static_cast<size_t>(path[0])].nodes;
  const SelectionActionNode* node = nullptr;
  for (size_t i = 1; i < path.size(); ++i) {
    if (path[i] < 0 || path[i] >= static_cast<int>(nodes->size())) return nullptr;
    node = &(*nodes)[static_cast<size_t>(path[i])];
    nodes = &node->children;
  }
  return node && node->action.operation ? node : nullptr;
}

const SelectionActionNode* NodeShown(const PanelView& view, const Memory& memory) {
  return memory.rules_shown ? NodeInHand(view) : nullptr;
}

float NodeHeight(Ui* ui, const SelectionActionNode& node, float width) {
  const Box room = Rows(ui, {0, 0, width - ui->U(2 * kMeasures.gap), 0});
  const float doc = ui->Paragraph(node.action.operation->doc, room, {Letter::kSmall}, false);
  return HeadHeight(ui) + doc + ui->U(28) + NodeRows(ui, node, room, false).Run();
}

void DrawNode(Ui* ui, const SelectionActionNode& node, const Box& box) {
  ui->BeginSheet("Node", box);
  Box rest = box.Inset(ui->U(kMeasures.gap));
  Box head = rest.CutTop(HeadHeight(ui), ui->U(8));
  ui->Hairline(head);
  if (ui->Button({.name = "Let go", .icon = Icon::kClose}, head.CutRight(ui->U(kMeasures.target)))
          .pressed) {
    ui->Send(Command(Take{}));
  }
  ui->Picture(IconOf(node.action), head.CutLeft(ui->U(40)), Tone::kAccent, Ground::kPanel);
  ui->Text(node.action.operation->word, head, {Letter::kStrong});
  const TextLook small{Letter::kSmall, Tone::kQuiet};
  const Box words = Rows(ui, rest);
  rest.CutTop(ui->Paragraph(node.action.operation->doc, words, small), ui->U(8));
  const float content = NodeRows(ui, node, Rows(ui, rest), false).Run();
  const Box list = ui->BeginList("list", rest, content);
  NodeRows(ui, node, Rows(ui, list), true).Run();
  ui->EndList();
  ui->EndSheet();
}

}  // namespace parti::app::panels
