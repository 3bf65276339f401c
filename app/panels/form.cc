#include "app/panels/form.h"

namespace parti::app::panels {

Box Form::Row(float height, float gap_units) {
  const float y = room_.y0 + height_;
  height_ += height + ui_->U(gap_units);
  return {room_.x0, y, room_.x1, y + height};
}

bool Form::Heading(const std::string& words) {
  Box row = Row(ui_->U(kMeasures.target), 8);
  if (!draw_) return false;
  ui_->Hairline(row);
  const Box close = row.CutRight(ui_->U(kMeasures.target));
  ui_->Text(words, row.Inset(ui_->U(8), 0), {Letter::kStrong});
  return ui_->Button({.name = "Close", .icon = Icon::kClose}, close).pressed;
}

void Form::Label(const std::string& words) {
  const Box row = Row(ui_->LineHeight(Letter::kSmall) + ui_->U(2), 3);
  if (draw_) ui_->Text(words, row.Inset(ui_->U(8), 0), {Letter::kSmall, Tone::kQuiet});
}

void Form::Words(const std::string& words) {
  const TextLook look{Letter::kSmall, Tone::kQuiet};
  const Box room = room_.Inset(ui_->U(8), 0);
  const Box row = Row(ui_->Paragraph(words, room, look, false), 8);
  if (draw_) ui_->Paragraph(words, row.Inset(ui_->U(8), 0), look);
}

bool Form::Choice(const ButtonLook& look, const std::string& below) {
  const float target = ui_->U(kMeasures.target);
  const float two = ui_->LineHeight(Letter::kBody) + ui_->LineHeight(Letter::kSmall) + ui_->U(12);
  Box row = Row(below.empty() ? target : std::max(target, two), 2);
  if (!draw_) return false;
  const Press press = ui_->Area(look.name, row, look.enabled);
  const bool lit = press.hovered || press.held;
  const Ground ground = look.chosen ? Ground::kChosen : lit ? Ground::kHover : Ground::kPanel;
  if (ground != Ground::kPanel) ui_->Fill(row, ground, kMeasures.small_radius);
  const Tone tone = look.enabled ? Tone::kText : Tone::kOff;
  ui_->Picture(look.icon, row.CutLeft(target), look.chosen ? Tone::kAccent : tone, ground);
  row = row.Inset(0, ui_->U(6));
  row.x1 -= ui_->U(8);
  const std::string& words = look.label.empty() ? look.name : look.label;
  const Box line = below.empty() ? row : row.CutTop(ui_->LineHeight(Letter::kBody));
  ui_->Text(words, line, {Letter::kBody, tone, ground});
  if (!below.empty()) ui_->Text(below, row, {Letter::kSmall, Tone::kQuiet, ground});
  return press.pressed;
}

bool Form::Action(const std::string& words, bool enabled) {
  const Box row = Row(ui_->U(kMeasures.target), 4);
  if (!draw_) return false;
  const ButtonLook look{.name = words,
                        .label = words,
                        .enabled = enabled,
                        .ground = enabled ? Ground::kAccent : Ground::kRaised};
  return ui_->Button(look, row).pressed;
}

int Form::Buttons(const std::vector<ButtonLook>& looks) {
  Box row = Row(ui_->U(kMeasures.target), 8);
  if (!draw_) return -1;
  const float gap = ui_->U(kMeasures.gap);
  const auto n = static_cast<float>(looks.size());
  const float width = (row.width() - gap * (n - 1)) / n;
  int pressed = -1;
  for (size_t i = 0; i < looks.size(); ++i) {
    ButtonLook look = looks[i];
    look.ground = Ground::kRaised;
    look.bordered = true;
    if (ui_->Button(look, row.CutLeft(width, gap)).pressed) pressed = static_cast<int>(i);
  }
  return pressed;
}

std::optional<bool> Form::AskOnceMore(const std::string& question, const std::string& act) {
  Words(question);
  const int pressed =
      Buttons({{.name = act + " for good", .label = act}, {.name = "Keep it", .label = "Keep"}});
  return pressed < 0 ? std::nullopt : std::optional(pressed == 0);
}

int Form::Stepper(const std::string& what, const std::string& words, bool less, bool more) {
  Box row = Row(ui_->U(kMeasures.target), 8);
  if (!draw_) return 0;
  const float side = ui_->U(2 * kMeasures.target);
  const ButtonLook down{.name = "Smaller " + what,
                        .icon = Icon::kMinus,
                        .enabled = less,
                        .ground = Ground::kRaised,
                        .bordered = true};
  ButtonLook up = down;
  up.name = "Larger " + what;
  up.icon = Icon::kPlus;
  up.enabled = more;
  const bool is_less = ui_->Button(down, row.CutLeft(side)).pressed;
  const bool is_more = ui_->Button(up, row.CutRight(side)).pressed;
  ui_->Text(words, row, {Letter::kBody, Tone::kText, Ground::kPanel, 0.5f});
  return is_more ? 1 : is_less ? -1 : 0;
}

std::optional<std::string> Form::Field(const std::string& label, const std::string& value,
                                       const std::string& hint) {
  Label(label);
  const Box row = Row(ui_->U(kMeasures.target), 10);
  return draw_ ? ui_->Field(label, row, value, hint) : std::nullopt;
}

bool Form::Switch(const std::string& name, const std::string& below, bool on) {
  Box row = Row(ui_->U(kMeasures.target + 6), 4);
  if (!draw_) return false;
  const Box toggle = row.CutRight(ui_->U(56));
  row = row.Inset(ui_->U(8), ui_->U(6));
  ui_->Text(name, row.CutTop(ui_->LineHeight(Letter::kBody)), {});
  ui_->Text(below, row, {Letter::kSmall, Tone::kQuiet});
  return ui_->Switch(name, toggle, on);
}

}  // namespace parti::app::panels
