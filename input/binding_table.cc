#include "input/binding_table.h"

#include <fmt/format.h>
#include <linux/input-event-codes.h>

#include <algorithm>
#include <bit>
#include <optional>

namespace parti::input {
namespace {

template <typename Value>
struct Named {
  std::string_view word;
  Value value;
};

constexpr Named<PenAct> kActs[] = {{"none", PenAct::kNone},   {"draw", PenAct::kDraw},
                                   {"erase", PenAct::kErase}, {"select", PenAct::kSelect},
                                   {"orbit", PenAct::kOrbit}, {"pan", PenAct::kPan},
                                   {"zoom", PenAct::kZoom}};
constexpr Named<PenSource> kSources[] = {{"pen", PenSource::kPen},
                                         {"eraser", PenSource::kEraser},
                                         {"mouse", PenSource::kMouse},
                                         {"wheel", PenSource::kWheel}};
constexpr Named<uint8_t> kModifiers[] = {{"shift", kShift}, {"ctrl", kCtrl}, {"alt", kAlt}};
constexpr Named<uint32_t> kPenButtons[] = {
    {"lower", BTN_STYLUS}, {"upper", BTN_STYLUS2}, {"third", BTN_STYLUS3}};
constexpr Named<uint32_t> kMouseButtons[] = {{"left", BTN_LEFT},
                                             {"right", BTN_RIGHT},
                                             {"middle", BTN_MIDDLE},
                                             {"side", BTN_SIDE},
                                             {"extra", BTN_EXTRA}};

template <typename Value, size_t n>
std::optional<Value> ValueOf(const Named<Value> (&names)[n], std::string_view word) {
  for (const auto& name : names) {
    if (name.word == word) return name.value;
  }
  return std::nullopt;
}

template <typename Value, size_t n>
std::string_view WordOf(const Named<Value> (&names)[n], Value value) {
  for (const auto& name : names) {
    if (name.value == value) return name.word;
  }
  return {};
}

std::optional<uint32_t> ButtonOf(PenSource source, std::string_view word) {
  if (source == PenSource::kWheel) return std::nullopt;
  return source == PenSource::kMouse ? ValueOf(kMouseButtons, word) : ValueOf(kPenButtons, word);
}

std::string TextOf(const Binding& row) {
  std::string text;
  for (const auto& modifier : kModifiers) {
    if ((row.modifiers & modifier.value) != 0) text += fmt::format("{}+", modifier.word);
  }
  text += WordOf(kSources, row.source);
  const bool mouse = row.source == PenSource::kMouse;
  if (row.button != 0) {
    text += '+';
    text += mouse ? WordOf(kMouseButtons, row.button) : WordOf(kPenButtons, row.button);
  }
  return fmt::format("{}={}", text, WordOf(kActs, row.act));
}

tl::unexpected<Error> Unknown(std::string_view word, std::string_view row) {
  return Fail(
      ErrorCode::kBadText, fmt::format("unknown word \"{}\" in binding \"{}\"", word, row),
      "write as shift+mouse+left=select: shift ctrl alt; pen eraser mouse wheel; lower upper "
      "third, left right middle side extra; draw erase select orbit pan zoom none");
}

/// Cuts off what stands before the next `mark`.
std::string_view CutWord(std::string_view* text, char mark) {
  const size_t stop = std::min(text->find(mark), text->size());
  const std::string_view word = text->substr(0, stop);
  text->remove_prefix(std::min(stop + 1, text->size()));
  return word;
}

Result<Binding> ReadRow(std::string_view row) {
  Binding binding;
  std::string_view act = row;
  std::string_view conditions = CutWord(&act, '=');
  std::string_view word = CutWord(&conditions, '+');
  while (const auto modifier = ValueOf(kModifiers, word)) {
    binding.modifiers = static_cast<uint8_t>(binding.modifiers | *modifier);
    word = CutWord(&conditions, '+');
  }
  const auto source = ValueOf(kSources, word);
  if (!source) return Unknown(word, row);
  binding.source = *source;
  if (!conditions.empty() || *source == PenSource::kMouse) {
    const auto button = ButtonOf(*source, conditions);
    if (!button) return Unknown(conditions, row);
    binding.button = *button;
  }
  const auto which = ValueOf(kActs, act);
  if (!which) return Unknown(act, row);
  binding.act = *which;
  return binding;
}

bool SameConditions(const Binding& a, const Binding& b) {
  return a.source == b.source && a.button == b.button && a.modifiers == b.modifiers;
}

}  // namespace

BindingTable DefaultBindings() {
  return {{PenSource::kPen, 0, 0, PenAct::kDraw},
          {PenSource::kPen, BTN_STYLUS, 0, PenAct::kErase},
          {PenSource::kPen, BTN_STYLUS2, 0, PenAct::kSelect},
          {PenSource::kEraser, 0, 0, PenAct::kErase},
          {PenSource::kMouse, BTN_LEFT, 0, PenAct::kDraw},
          {PenSource::kMouse, BTN_LEFT, kCtrl, PenAct::kErase},
          {PenSource::kMouse, BTN_LEFT, kShift, PenAct::kSelect},
          {PenSource::kMouse, BTN_MIDDLE, 0, PenAct::kPan},
          {PenSource::kMouse, BTN_RIGHT, 0, PenAct::kOrbit},
          {PenSource::kWheel, 0, 0, PenAct::kZoom},
          {PenSource::kWheel, 0, kShift, PenAct::kPan}};
}

PenAct ActFor(const BindingTable& table, PenSource source, uint32_t pressed, const Held& held) {
  PenAct act = PenAct::kNone;
  int most = -1;
  for (const Binding& row : table) {
    if (row.source != source || (row.modifiers & ~held.modifiers) != 0) continue;
    const auto& buttons = held.buttons;
    const bool fits = source == PenSource::kMouse
                          ? row.button == pressed
                          : row.button == 0 || std::find(buttons.begin(), buttons.end(),
                                                         row.button) != buttons.end();
    const int conditions = std::popcount(row.modifiers) + (row.button != 0 ? 1 : 0);
    if (!fits || conditions <= most) continue;
    most = conditions;
    act = row.act;
  }
  return act;
}

std::string BindingsText(const BindingTable& table) {
  std::string text;
  for (const Binding& row : table) {
    if (!text.empty()) text += ' ';
    text += TextOf(row);
  }
  return text;
}

Result<BindingTable> ReadBindings(std::string_view text) {
  BindingTable table;
  while (!text.empty()) {
    const std::string_view word = CutWord(&text, ' ');
    if (word.empty()) continue;
    const auto row = ReadRow(word);
    if (!row) return Fail(row);
    const auto same = [&](const Binding& other) { return SameConditions(other, *row); };
    if (std::any_of(table.begin(), table.end(), same)) {
      return Fail(ErrorCode::kBadText, fmt::format("binding \"{}\" is given twice", word),
                  "keep one of the two");
    }
    table.push_back(*row);
  }
  return table;
}

}  // namespace parti::input
