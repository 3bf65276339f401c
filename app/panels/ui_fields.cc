// Ui's fields: text that is typed, numbers that are dragged, stepped or typed.
#include <imgui_internal.h>

#include <cmath>

#include "app/length_text.h"
#include "app/panels/ui.h"
#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

int Resize(ImGuiInputTextCallbackData* data) {
  if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
  auto* text = static_cast<std::string*>(data->UserData);
  text->resize(static_cast<size_t>(data->BufTextLen));
  data->Buf = text->data();
  return 0;
}

/// The multiple of `step` next to `value`, as a person would write it: 0.3, not
/// 0.30000000000000004, into which six times 0.05 falls. Steps have six decimals at most.
double Rounded(double value, double step) {
  constexpr double kDecimals = 1e6;
  return std::round(std::round(value / step) * step * kDecimals) / kDecimals;
}

}  // namespace

void Ui::StartEdit(const std::string& full, const std::string& value) {
  editing_ = full;
  draft_ = value;
  edit_age_ = 0;
  edit_seen_ = true;
  focus_ = full;
  touched_ = true;
}

std::optional<std::string> Ui::Field(const std::string& name, const Box& box,
                                     const std::string& value, const std::string& hint) {
  const std::string full = Full(name);
  Fill(box, Ground::kRaised, kMeasures.small_radius);
  Border(box, kMeasures.small_radius);
  if (editing_ == full) return Edit(full, box, value);
  const Press press = Area(name, box);
  const bool empty = value.empty();
  Text(empty ? hint : value, box.Inset(U(10), 0),
       {Letter::kBody, empty ? Tone::kQuiet : Tone::kText, Ground::kRaised});
  if (press.pressed) StartEdit(full, value);
  return std::nullopt;
}

std::optional<std::string> Ui::FieldOver(const std::string& name, const Box& box,
                                         const std::string& value, Over* over) {
  const std::string full = Full(name);
  over->typing = editing_ == full;
  if (over->typing) {
    Fill(box, Ground::kRaised, kMeasures.small_radius);
    Border(box, kMeasures.small_radius);
    return Edit(full, box, value);
  }
  const Press press = Area(name, box);
  over->hovered = press.hovered || press.held;
  if (over->hovered) Fill(box, Ground::kHover, kMeasures.small_radius);
  if (press.pressed) StartEdit(full, value);
  return std::nullopt;
}

std::optional<std::string> Ui::Edit(const std::string& full, const Box& box,
                                    const std::string& value) {
  edit_seen_ = true;
  AddTarget(full, box, true);
  if (edit_age_ < 3) ScrollTo(box);
  bool entered = false;
  EditText(full, box, &entered);
  const bool given_up = ++edit_age_ > 3 && !ImGui::IsItemActive() && !entered;
  if (!entered && !ImGui::IsItemDeactivated() && !given_up) return std::nullopt;
  editing_.clear();
  touched_ = true;
  if (draft_ == value) return std::nullopt;
  return draft_;
}

void Ui::EditText(const std::string& full, const Box& box, bool* entered) {
  ImFont* font = FontOf(Letter::kBody);
  ImGui::PushFont(font);
  const auto color = [&](ImGuiCol what, Color value) { ImGui::PushStyleColor(what, value); };
  color(ImGuiCol_FrameBg, 0);
  color(ImGuiCol_Text, palette_->text);
  color(ImGuiCol_TextSelectedBg, palette_->chosen);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2{U(10), std::max(0.0f, (box.height() - font->FontSize) / 2)});
  ImGui::SetCursorScreenPos({box.x0, box.y0});
  ImGui::SetNextItemWidth(box.width());
  ImGui::PushID(full.c_str());
  if (edit_age_ == 0) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavNextActivateId = ImGui::GetID("text");
    context.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    touched_ = true;
  }
  *entered =
      ImGui::InputText("text", draft_.data(), draft_.capacity() + 1,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                           ImGuiInputTextFlags_CallbackResize,
                       Resize, &draft_);
  draft_.resize(std::char_traits<char>::length(draft_.c_str()));
  ImGui::PopID();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(3);
  ImGui::PopFont();
  Border(box, kMeasures.small_radius);
  list()->AddRect({box.x0, box.y0}, {box.x1, box.y1}, palette_->accent_text,
                  U(kMeasures.small_radius), 0, U(1.6f));
}

NumberWish Ui::Number(const NumberLook& look, const Box& box) {
  const std::string full = Full(look.name);
  Fill(box, Ground::kRaised, kMeasures.small_radius);
  if (editing_ == full) {
    const auto typed = Edit(full, box, PlainNumber(look.value));
    return typed ? Typed(*typed, look.value) : NumberWish{};
  }
  Box rest = box;
  const Box less = rest.CutLeft(U(kMeasures.target)), more = rest.CutRight(U(kMeasures.target));
  NumberWish wish;
  const double big = look.step * 2;
  const auto step = [&](double by) {
    const double to = std::clamp(Rounded(look.value + by, look.step), look.low, look.high);
    if (to != look.value) wish.commit = to;
  };
  const ButtonLook minus{.name = "Less " + look.name,
                         .icon = Icon::kMinus,
                         .enabled = look.value > look.low,
                         .ground = Ground::kRaised};
  const ButtonLook plus{.name = "More " + look.name,
                        .icon = Icon::kPlus,
                        .enabled = look.value < look.high,
                        .ground = Ground::kRaised};
  if (Button(minus, less).pressed) step(-big);
  const Press press = Area(look.name, rest);
  const NumberWish dragged = Drag(full, look, press);
  const double shown = dragged.trial.value_or(look.value);
  const std::string unit = look.unit.empty() ? "" : " " + look.unit;
  Text(PlainNumber(shown) + unit, rest,
       {look.changed ? Letter::kStrong : Letter::kBody, look.changed ? Tone::kAccent : Tone::kText,
        Ground::kRaised, 0.5f});
  if (Button(plus, more).pressed) step(big);
  Border(box, kMeasures.small_radius);
  if (wish.commit) return wish;
  if (press.pressed && dragging_ != full && !dragged.commit) {
    StartEdit(full, PlainNumber(look.value));
  }
  return dragged;
}

NumberWish Ui::Typed(const std::string& text, double before) {
  const auto number = ParseLength(text);
  complaint_ = number ? "" : number.error().message;
  if (!number || *number == before) return {};
  return {std::nullopt, *number};
}

NumberWish Ui::Drag(const std::string& full, const NumberLook& look, const Press& press) {
  const ImVec2 way = ImGui::GetMouseDragDelta(0, U(6));
  const bool begins = press.held && dragging_.empty() && std::abs(way.x) > std::abs(way.y);
  if (begins && !scrolls_) {
    dragging_ = full;
    drag_from_ = drag_to_ = look.value;
    KeepDrag();
  }
  if (dragging_ != full) return {};
  drag_seen_ = true;
  if (press.held) {
    const double moved = drag_from_ + way.x / scale_ * look.step / 4;
    drag_to_ = std::clamp(Rounded(moved, look.step), look.low, look.high);
    return {drag_to_, std::nullopt};
  }
  dragging_.clear();
  const bool given_up = !ImGui::IsMousePosValid();
  if (given_up || drag_to_ == look.value) return {};
  touched_ = true;
  return {std::nullopt, drag_to_};
}

}  // namespace parti::app::panels
