#include "app/panels/node_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "app/panels/words.h"
#include "grammar/operation.h"

namespace parti::app::panels {
namespace {

using grammar::Argument;
using grammar::Axis;
using grammar::ParameterKind;

constexpr int kInRow = 6;

/// What buildings are made of, roughly.
struct Swatch {
  const char *name, *color;
};
constexpr std::array<Swatch, 12> kSwatches = {{{"Plaster", "#f2efe6"},
                                               {"Sand", "#e3d3b0"},
                                               {"Brick", "#b5654a"},
                                               {"Clay", "#9c4a33"},
                                               {"Oak", "#a77b4f"},
                                               {"Walnut", "#5d4030"},
                                               {"Concrete", "#b9b6ae"},
                                               {"Zinc", "#8f979d"},
                                               {"Slate", "#5b6470"},
                                               {"Charcoal", "#33363a"},
                                               {"Glass", "#7e98a8"},
                                               {"Copper", "#6f9c86"}}};

void AddAxes(std::span<const std::string_view> words, WordPick* pick) {
  constexpr std::array<std::pair<Axis, const char*>, 3> kAxes = {
      {{Axis::kX, "across"}, {Axis::kY, "upward"}, {Axis::kZ, "in depth"}}};
  for (const auto& [axis, words_of_it] : kAxes) {
    const auto name = grammar::NameOf(axis);
    if (!words.empty() && std::find(words.begin(), words.end(), name) == words.end()) continue;
    pick->choices.push_back({words_of_it, words_of_it, axis});
  }
}

std::string WordsOf(const Argument& argument) {
  if (const auto* axis = std::get_if<Axis>(&argument)) return std::string(grammar::NameOf(*axis));
  if (const auto* on = std::get_if<bool>(&argument)) return *on ? "yes" : "no";
  const auto* text = std::get_if<std::string>(&argument);
  return text ? *text : "";
}

int RowsOf(const WordPick& pick) {
  const auto count = static_cast<int>(pick.choices.size());
  const int in_row = pick.is_color ? kInRow : 3;
  return (count + in_row - 1) / in_row;
}

/// 0xaabbggrr of "#rrggbb"; nothing where it is none.
std::optional<Color> ColorFrom(const std::string& text) {
  uint32_t rgb = 0;
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  const auto [end, code] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
  if (code != std::errc() || end != text.data() + 7) return std::nullopt;
  return 0xff000000u | (rgb & 0xff) << 16 | (rgb & 0xff00) | rgb >> 16;
}

bool DrawSwatch(Ui* ui, const WordPick& pick, const WordPick::Choice& choice, const Box& box) {
  const std::string& text = std::get<std::string>(choice.value);
  const Press press = ui->Area(choice.name, box);
  if (press.hovered) ui->Note(choice.name, box);
  const Box inner = box.Inset(ui->U(text == pick.now ? 6 : 3));
  ui->list()->AddRectFilled({inner.x0, inner.y0}, {inner.x1, inner.y1},
                            ColorFrom(text).value_or(0xff000000u), ui->U(kMeasures.small_radius));
  ui->Border(inner, kMeasures.small_radius);
  if (text == pick.now) ui->Border(box, kMeasures.small_radius);
  return press.pressed;
}

bool DrawChoice(Ui* ui, const WordPick& pick, const WordPick::Choice& choice, const Box& box) {
  if (pick.is_color) return DrawSwatch(ui, pick, choice, box);
  const ButtonLook look{.name = pick.label + " " + choice.name,
                        .label = choice.label,
                        .chosen = WordsOf(choice.value) == pick.now,
                        .ground = Ground::kRaised,
                        .bordered = true};
  return ui->Button(look, box).pressed;
}

}  // namespace

std::vector<WordPick> WordPicksOf(const grammar::Action& action) {
  std::vector<WordPick> picks;
  const auto parameters = action.operation->parameters;
  const bool is_comp = action.operation->name == "comp";
  for (size_t i = 0; i < std::min(parameters.size(), action.arguments.size()); ++i) {
    const grammar::Parameter& parameter = parameters[i];
    const Argument& argument = action.arguments[i];
    const bool is_text = std::holds_alternative<std::string>(argument);
    WordPick pick{i, Capital(std::string(parameter.name)), WordsOf(argument), false, {}};
    pick.is_color = is_text && parameter.kind == ParameterKind::kColor;
    if (std::holds_alternative<Axis>(argument)) {
      AddAxes(parameter.words, &pick);
    } else if (std::holds_alternative<bool>(argument)) {
      pick.choices = {{"yes", "yes", true}, {"no", "no", false}};
    } else if (pick.is_color) {
      for (const Swatch& s : kSwatches) pick.choices.push_back({s.name, "", std::string(s.color)});
    } else if (is_text && parameter.words.size() != 1) {
      for (const auto& word : parameter.words) {
        const std::string label(is_comp ? NameOfComponent(word) : word);
        pick.choices.push_back({label, label, std::string(word)});
      }
    } else {
      continue;
    }
    picks.push_back(std::move(pick));
  }
  return picks;
}

float WordPickHeight(Ui* ui, const WordPick& pick) {
  const float row = ui->U(kMeasures.target + kMeasures.gap);
  const bool typed = pick.is_color || pick.choices.empty();
  return ui->LineHeight(Letter::kSmall) + ui->U(3 + 6) + row * static_cast<float>(RowsOf(pick)) +
         (typed ? row : 0);
}

std::optional<Argument> DrawWordPick(Ui* ui, const WordPick& pick, Box box) {
  std::optional<Argument> picked;
  ui->Text(pick.label, box.CutTop(ui->LineHeight(Letter::kSmall), ui->U(3)),
           {Letter::kSmall, Tone::kQuiet});
  const float gap = ui->U(kMeasures.gap), side = ui->U(kMeasures.target);
  const int in_row = pick.is_color ? kInRow : std::min(3, static_cast<int>(pick.choices.size()));
  const float width = (box.width() - gap * static_cast<float>(in_row - 1)) /
                      static_cast<float>(std::max(1, in_row));
  Box row;
  for (size_t i = 0; i < pick.choices.size(); ++i) {
    if (i % static_cast<size_t>(in_row) == 0) row = box.CutTop(side, gap);
    const Box at = row.CutLeft(width, gap);
    if (DrawChoice(ui, pick, pick.choices[i], at)) picked = pick.choices[i].value;
  }
  if (pick.is_color || pick.choices.empty()) {
    const auto typed = ui->Field(pick.label, box.CutTop(side, gap), pick.now);
    if (typed) picked = *typed;
  }
  return picked;
}

}  // namespace parti::app::panels
