#include "app/panels/layers_sheet.h"

#include <fmt/format.h>

namespace parti::app::panels {
namespace {

using grammar::LayeredRule;
using grammar::ListedLayer;
using How = ChangeLayer::How;

constexpr float kSwitchWidth = 48;
constexpr const char* kAll =
    "The layers of all rules, topmost first. Tap a face to have its own alone.";
constexpr const char* kOfFace = "The layers of the face in hand, topmost first.";
constexpr const char* kOwn = "a rule of its own";

/// What a layer is made by, in words.
std::string MadeBy(const ListedLayer& layer) {
  const std::string own = layer.own.empty() ? kOwn : layer.own;
  if (layer.symbol == layer.own) return own;
  return fmt::format("{}, not {}", layer.symbol, own);
}

/// Draws row after row, or only measures where `draw` is false.
class LayerList {
 public:
  LayerList(Ui* ui, Memory* memory, const grammar::RuleSet& rules, const Box& list, bool draw)
      : ui_(ui), memory_(memory), rules_(rules), rest_(list), draw_(draw) {}

  /// How high all of it is, px.
  float Run(const ShownLayers& shown) {
    Words(shown.of_face ? kOfFace : kAll, {Letter::kSmall, Tone::kQuiet});
    for (const LayeredRule& rule : shown.rules) {
      Words(rule.rule, {Letter::kStrong});
      for (size_t i = 0; i < rule.layers.size(); ++i) Layer(rule, i);
    }
    return height_;
  }

 private:
  /// The next strip; measuring counts it, too.
  Box Take(float height, float gap) {
    const Box box{rest_.x0, rest_.y0 + height_, rest_.x1, rest_.y0 + height_ + height};
    height_ += height + gap;
    return box;
  }

  void Words(std::string_view text, const TextLook& look) {
    const float side = ui_->U(8);
    const float height = ui_->Paragraph(text, rest_.Inset(side, 0), look, false);
    const Box box = Take(height, ui_->U(6)).Inset(side, 0);
    if (draw_) ui_->Paragraph(text, box, look);
  }

  void Layer(const LayeredRule& rule, size_t i) {
    const ListedLayer& layer = rule.layers[i];
    const std::string name = grammar::LayerName(rule.rule, layer.name);
    const bool open = memory_->open_layer == name;
    Row(rule, i, name, open);
    if (!open) return;
    Choice(name, layer, "", layer.symbol == layer.own);
    for (const std::string& symbol : SymbolsForLayers(rules_, rule.rule)) {
      if (symbol != layer.own) Choice(name, layer, symbol, symbol == layer.symbol);
    }
  }

  void Row(const LayeredRule& rule, size_t i, const std::string& name, bool open) {
    const ListedLayer& layer = rule.layers[i];
    const float buttons = ui_->U(2 * kMeasures.target + kSwitchWidth);
    const Box words{0, 0, rest_.width() - buttons - ui_->U(12), 0};
    const std::string made_by = MadeBy(layer);
    const float name_height = ui_->Paragraph(layer.name, words, {}, false);
    const float made_height = ui_->Paragraph(made_by, words, {Letter::kSmall}, false);
    const float content = name_height + made_height;
    Box row = Take(std::max(ui_->U(kMeasures.target + 2), content + ui_->U(12)), ui_->U(2));
    if (!draw_) return;
    const Box toggle = row.CutRight(ui_->U(kSwitchWidth));
    if (ui_->Switch("Show " + name, toggle, layer.on)) {
      Send({name, layer.on ? How::kOff : How::kOn});
    }
    MoveButtons(rule, i, name, row.CutRight(ui_->U(2 * kMeasures.target)));
    const Press press = ui_->Area(name, row);
    const Ground ground = open ? Ground::kChosen : press.hovered ? Ground::kHover : Ground::kPanel;
    if (ground != Ground::kPanel) ui_->Fill(row, ground, kMeasures.small_radius);
    if (press.pressed) memory_->open_layer = open ? "" : name;
    Box text{row.x0 + ui_->U(8), row.middle_y() - content / 2, row.x1 - ui_->U(4), row.y1};
    const bool changed = layer.symbol != layer.own;
    ui_->Paragraph(layer.name, text.CutTop(name_height),
                   {Letter::kBody, layer.on ? Tone::kText : Tone::kOff, ground});
    ui_->Paragraph(made_by, text,
                   {Letter::kSmall,
                    !layer.on ? Tone::kOff
                    : changed ? Tone::kAccent
                              : Tone::kQuiet,
                    ground});
  }

  void MoveButtons(const LayeredRule& rule, size_t i, const std::string& name, Box box) {
    const Box up = box.CutLeft(ui_->U(kMeasures.target));
    const bool first = i == 0, last = i + 1 == rule.layers.size();
    const ButtonLook higher{.name = "Move up " + name, .icon = Icon::kUp, .enabled = !first};
    if (ui_->Button(higher, up).pressed) Send({name, How::kUp});
    const ButtonLook lower{.name = "Move down " + name, .icon = Icon::kDown, .enabled = !last};
    if (ui_->Button(lower, box).pressed) Send({name, How::kDown});
  }

  /// A symbol that the layer may get; "": the one of the text.
  void Choice(const std::string& name, const ListedLayer& layer, const std::string& symbol,
              bool chosen) {
    Box box = Take(ui_->U(kMeasures.target), ui_->U(2));
    if (!draw_) return;
    box.CutLeft(ui_->U(20));
    const std::string own =
        layer.own.empty() ? "As in the text" : fmt::format("As in the text: {}", layer.own);
    const ButtonLook look{.name = fmt::format("{} gets {}", name, symbol),
                          .icon = Icon::kNone,
                          .label = symbol.empty() ? own : symbol,
                          .chosen = chosen,
                          .align = 0};
    if (!ui_->Button(look, box).pressed || chosen) return;
    Send({name, How::kGets, symbol});
    memory_->open_layer.clear();
  }

  void Send(const ChangeLayer& change) { ui_->SendTyped(change); }

  Ui* ui_;
  Memory* memory_;
  const grammar::RuleSet& rules_;
  Box rest_;
  bool draw_;
  float height_ = 0;
};

float Run(Ui* ui, Memory* memory, const Box& list, bool draw) {
  const SessionState& state = *ui->view().session->state;
  const grammar::RuleSet* rules = memory->known_rules.Of(state.model);
  if (!rules) return 0;
  return LayerList(ui, memory, *rules, list, draw).Run(LayersOf(state, *rules));
}

}  // namespace

bool HasLayers(const Ui& ui, Memory* memory) {
  if (!ui.view().session) return false;
  const grammar::RuleSet* rules = memory->known_rules.Of(ui.view().session->state->model);
  return rules && !grammar::LayerNames(*rules).empty();
}

float LayersHeight(Ui* ui, Memory* memory, float width) {
  return Run(ui, memory, {0, 0, width, 0}, false);
}

void DrawLayers(Ui* ui, Memory* memory, const Box& list) { Run(ui, memory, list, true); }

}  // namespace parti::app::panels
