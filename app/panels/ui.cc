#include "app/panels/ui.h"

#include <imgui_internal.h>

#include <cfloat>

#include "app/panels/layout.h"
#include "app/panels/words.h"

namespace parti::app::panels {
namespace {

constexpr ImGuiWindowFlags kSheetFlags =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollWithMouse |
    ImGuiWindowFlags_NoFocusOnAppearing;
constexpr ImGuiWindowFlags kListFlags =
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBackground;

ImVec2 Low(const Box& box) { return {box.x0, box.y0}; }
ImVec2 High(const Box& box) { return {box.x1, box.y1}; }

Box At(const PanelTarget& target) {
  return {static_cast<float>(target.low_px.x), static_cast<float>(target.low_px.y),
          static_cast<float>(target.high_px.x), static_cast<float>(target.high_px.y)};
}

/// ImGui refuses things without a size.
ImVec2 SizeOf(const Box& box) {
  return {std::max(1.0f, box.width()), std::max(1.0f, box.height())};
}

/// Control characters would break a line.
std::string OneLine(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

}  // namespace

void Ui::Begin(const PanelView& view, double scale, PanelOutput* output) {
  view_ = &view;
  scale_ = scale;
  palette_ = &PaletteOf(view.settings.theme);
  output_ = output;
  output_->targets.clear();
  output_->texts.clear();
  output_->trial.reset();
  touched_ = focus_moved_ = edit_seen_ = drag_seen_ = false;
  pointer_over_ = ImGui::IsAnyItemActive();
  note_.clear();
  output_->sheets.clear();
  output_->holds_pointer = pointer_over_;
  std::swap(places_, places_before_);
  places_.clear();
  ImGuiIO& io = ImGui::GetIO();
  io.MouseDragThreshold = U(6);
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = style.ItemSpacing = {0, 0};
  style.WindowBorderSize = style.ChildBorderSize = style.FrameBorderSize = 0;
  style.WindowMinSize = {1, 1};
  if (ImGui::IsMouseClicked(0)) focus_.clear();
  took_key_ = key_ && !editing_.empty();
  if (key_ && key_->pressed) MoveFocus(*key_);
}

void Ui::End() {
  DrawNote();
  if (!edit_seen_) editing_.clear();
  if (!drag_seen_) dragging_.clear();
  key_.reset();
}

void Ui::FeedKey(const KeyEvent& key) { key_ = key; }

Box Ui::window() const {
  return {0, 0, static_cast<float>(view_->size_px.x), static_cast<float>(view_->size_px.y)};
}

Vec2 Ui::pointer_px() const {
  const ImVec2 at = ImGui::GetIO().MousePos;
  return {at.x, at.y};
}

void Ui::Send(PanelCommand command) {
  output_->commands.push_back(std::move(command));
  touched_ = true;
}

void Ui::SendTyped(const Command& command) {
  const auto read = ParseCommand(TextOf(command));
  if (read && *read == command) {
    complaint_.clear();
    return Send(command);
  }
  const Error error =
      read ? Error{ErrorCode::kBadText, "that can't be understood", "one name, without blanks"}
           : read.error();
  complaint_ = error.message + (error.hint.empty() ? "" : " (" + error.hint + ")");
  touched_ = true;
}

void Ui::Try(SetNumber number) { output_->trial = std::move(number); }

void Ui::BeginSheet(std::string_view name, const Box& box) {
  sheet_ = name;
  ImGui::SetNextWindowPos(Low(box));
  ImGui::SetNextWindowSize(SizeOf(box));
  ImGui::Begin(sheet_.c_str(), nullptr, kSheetFlags);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());  // in the order drawn
  output_->sheets.push_back({sheet_, {box.x0, box.y0}, {box.x1, box.y1}});
  pointer_over_ = pointer_over_ || box.Contains(pointer_px());
  list()->PushClipRectFullScreen();
  for (float spread = 0.5f; spread < 7; spread += 0.75f) {  // soft: many faint edges
    const Box shadow = box.Inset(-U(spread)).Moved(0, U(1.5f));
    list()->AddRectFilled(Low(shadow), High(shadow), palette_->shadow,
                          U(kMeasures.radius + spread));
  }
  list()->PopClipRect();
  Fill(box, Ground::kPanel, kMeasures.radius);
  Border(box, kMeasures.radius);
}

void Ui::EndSheet() { ImGui::End(); }

Box Ui::BeginList(std::string_view name, const Box& box, float content_height) {
  const std::string full = Full(std::string(name));
  ImGui::SetCursorScreenPos(Low(box));
  ImDrawList* sheet = list();
  ImGui::BeginChild(full.c_str(), SizeOf(box), false, kListFlags);
  ScrollWithPointer(full, box);
  list_ = box;
  const ImVec2 top = ImGui::GetCursorScreenPos();
  ImGui::Dummy({1, std::max(1.0f, content_height)});
  if (ImGui::GetScrollMaxY() > 0) {  // how far it is scrolled: a thin line, not a target
    const float part = box.height() / std::max(box.height(), content_height);
    const float y =
        box.y0 + (box.height() * (1 - part)) * ImGui::GetScrollY() / ImGui::GetScrollMaxY();
    sheet->AddRectFilled({box.x1 + U(1), y}, {box.x1 + U(3), y + box.height() * part},
                         ColorOf(*palette_, Tone::kQuiet, Ground::kPanel), U(2));
  }
  return {box.x0, top.y, box.x1, top.y + content_height};
}

void Ui::EndList() {
  // Where there is more, rows fade out instead of being cut.
  const Color solid = palette_->panel, clear = solid & 0x00ffffffu;
  const float fade = U(20);
  const Box box = *list_;
  if (ImGui::GetScrollY() > 0) {
    list()->AddRectFilledMultiColor(Low(box), {box.x1, box.y0 + fade}, solid, solid, clear, clear);
  }
  if (ImGui::GetScrollY() < ImGui::GetScrollMaxY()) {
    list()->AddRectFilledMultiColor({box.x0, box.y1 - fade}, High(box), clear, clear, solid, solid);
  }
  list_.reset();
  ImGui::EndChild();
}

void Ui::ScrollWithPointer(const std::string& full, const Box& box) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  if (ImGui::IsMouseClicked(0) && over && box.Contains(pointer_px())) {
    scrolling_ = full;
    scrolls_ = false;
  }
  if (scrolling_ != full) return;
  if (!io.MouseDown[0]) return scrolling_.clear();
  const ImVec2 way = ImGui::GetMouseDragDelta(0, 0);
  const bool along = std::abs(way.y) > U(8) && std::abs(way.y) > std::abs(way.x);
  scrolls_ = scrolls_ || (along && dragging_.empty() && editing_.empty());
  if (!scrolls_) return;
  ImGui::ClearActiveID();  // what was pressed is let go without effect
  ImGui::SetScrollY(ImGui::GetScrollY() - io.MouseDelta.y);
}

void Ui::AddTarget(const std::string& full, const Box& box, bool enabled) {
  const bool visible = !list_ || (box.y0 >= list_->y0 - 1 && box.y1 <= list_->y1 + 1);
  output_->targets.push_back({full, {box.x0, box.y0}, {box.x1, box.y1}, enabled, visible});
  if (enabled) places_.push_back({full, box, list_.value_or(Box{})});
}

void Ui::ScrollTo(const Box& part) {
  if (!list_) return;
  const float above = list_->y0 - part.y0, below = part.y1 - list_->y1;
  if (above <= 0 && below <= 0) return;
  ImGui::SetScrollY(ImGui::GetScrollY() + (above > 0 ? -above : std::min(below, -above)));
  touched_ = true;
}

void Ui::NoteTarget(const std::string& name, const Box& box) {
  output_->targets.push_back({Full(name), {box.x0, box.y0}, {box.x1, box.y1}, true, true});
}

Press Ui::Area(const std::string& name, const Box& box, bool enabled) {
  const std::string full = Full(name);
  AddTarget(full, box, enabled);
  if (!enabled) return {};
  ImGui::SetCursorScreenPos(Low(box));
  const bool clicked = ImGui::InvisibleButton(full.c_str(), SizeOf(box));
  Press press{clicked, ImGui::IsItemHovered(), ImGui::IsItemActive()};
  press.pressed = TakeEnter(full) || press.pressed;
  touched_ = touched_ || press.pressed;
  ShowFocus(full, box);
  return press;
}

Press Ui::Button(const ButtonLook& look, const Box& box) {
  const Press press = Area(look.name, box, look.enabled);
  Ground ground = look.ground;
  if (look.chosen) ground = Ground::kChosen;
  const bool lit = press.hovered || press.held;
  if (lit && ground != Ground::kAccent) ground = look.chosen ? Ground::kChosen : Ground::kHover;
  if (ground != Ground::kPanel) Fill(box, ground, kMeasures.small_radius);
  if (look.bordered) Border(box, kMeasures.small_radius);
  const Tone tone = !look.enabled ? Tone::kOff : look.chosen ? Tone::kAccent : Tone::kText;
  Box rest = box;
  const bool alone = look.label.empty();
  if (look.icon != Icon::kNone) {
    const Box at = alone ? rest : rest.CutLeft(std::min(U(40), box.height()));
    Picture(look.icon, at, tone, ground);
  }
  if (!alone) {
    const bool text_only = look.icon == Icon::kNone;
    Text(look.label,
         text_only ? rest.Inset(U(8), 0) : Box{rest.x0, rest.y0, rest.x1 - U(8), rest.y1},
         {Letter::kBody, tone, ground, text_only ? look.align : 0});
  } else if (WantsNote(Full(look.name), press)) {
    Note(look.keys.empty() ? look.name : look.name + "   " + look.keys, box);
  }
  return press;
}

bool Ui::Switch(const std::string& name, const Box& box, bool on, Ground ground) {
  const Press press = Area(name, box);
  const Box pill = BoxAt(box.middle_x() - U(17), box.middle_y() - U(10), U(34), U(20));
  const Color track = on ? palette_->accent : ColorOf(*palette_, Tone::kQuiet, ground);
  list()->AddRect(Low(pill), High(pill), track, U(10), 0, U(1.6f));
  if (on) list()->AddRectFilled(Low(pill), High(pill), track, U(10));
  const float x = on ? pill.x1 - U(10) : pill.x0 + U(10);
  list()->AddCircleFilled({x, pill.middle_y()}, U(6), on ? palette_->on_accent : track, 24);
  if (press.hovered) Note(name, box);
  return press.pressed;
}

/// Who has pressed it knows it, and needs to see what it has opened.
bool Ui::WantsNote(const std::string& full, const Press& press) {
  if (press.pressed) hushed_ = full;
  if (!press.hovered && hushed_ == full) hushed_.clear();
  return press.hovered && hushed_ != full;
}

ImFont* Ui::FontOf(Letter letter) const {
  const Letters& letters = host_->letters();
  switch (letter) {
    case Letter::kBody:
      return letters.body;
    case Letter::kSmall:
      return letters.small;
    case Letter::kStrong:
      return letters.strong;
  }
  return letters.body;
}

float Ui::LineHeight(Letter letter) const { return FontOf(letter)->FontSize; }

float Ui::TextWidth(std::string_view text, Letter letter) const {
  const ImFont* font = FontOf(letter);
  return font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x;
}

std::string Ui::Elided(std::string_view text, Letter letter, float width) const {
  std::string line = OneLine(text);
  if (TextWidth(line, letter) <= width) return line;
  while (!line.empty()) {
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) {
      line.pop_back();
    }
    if (!line.empty()) line.pop_back();
    if (TextWidth(line + "…", letter) <= width) return line + "…";
  }
  return line;
}

void Ui::Text(std::string_view text, const Box& room, const TextLook& look) {
  const std::string line = Elided(text, look.letter, room.width());
  if (line.empty()) return;
  const ImFont* font = FontOf(look.letter);
  const float width = TextWidth(line, look.letter);
  const float x = std::floor(room.x0 + (room.width() - width) * look.align);
  const float y = std::floor(room.middle_y() - font->FontSize / 2);
  const Color color = ColorOf(*palette_, look.tone, look.ground);
  list()->AddText(font, font->FontSize, {x, y}, color, line.data(), line.data() + line.size());
  output_->texts.push_back({line,
                            {x, y},
                            {x + width, y + font->FontSize},
                            {room.x0, room.y0},
                            {room.x1, room.y1},
                            color,
                            ColorOf(*palette_, look.ground)});
}

std::vector<std::string> Ui::Wrapped(std::string_view text, Letter letter, float width) const {
  const std::string words = OneLine(KeptTogether(std::string(text)));
  const float room = width + 0.5f;  // measured and drawn rooms differ by rounding
  std::vector<std::string> lines(1);
  for (size_t from = 0; from < words.size();) {
    const size_t end = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, end - from);
    from = end + 1;
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    if (TextWidth(longer, letter) <= room) {
      lines.back() = longer;
      continue;
    }
    if (!lines.back().empty()) lines.emplace_back();
    for (size_t i = 0; i < word.size();) {  // a word longer than a line is broken anywhere
      size_t next = i + 1;
      while (next < word.size() && (static_cast<unsigned char>(word[next]) & 0xc0) == 0x80) ++next;
      const std::string grown = lines.back() + word.substr(i, next - i);
      if (!lines.back().empty() && TextWidth(grown, letter) > room) {
        lines.emplace_back();
        continue;
      }
      lines.back() = grown;
      i = next;
    }
  }
  return lines;
}

float Ui::Paragraph(std::string_view text, const Box& room, const TextLook& look, bool draw) {
  const float line_height = LineHeight(look.letter);
  const std::vector<std::string> lines = Wrapped(text, look.letter, room.width());
  if (draw) {
    Box rest{room.x0, room.y0, room.x1 + 1,
             room.y0 + line_height * static_cast<float>(lines.size())};
    for (const std::string& line : lines) Text(line, rest.CutTop(line_height), look);
  }
  return line_height * static_cast<float>(lines.size());
}

void Ui::Fill(const Box& box, Ground ground, float radius_units) {
  list()->AddRectFilled(Low(box), High(box), ColorOf(*palette_, ground), U(radius_units));
}

void Ui::Border(const Box& box, float radius_units) {
  list()->AddRect(Low(box), High(box), palette_->hairline, U(radius_units), 0,
                  std::max(1.0f, std::floor(U(1))));
}

void Ui::Accent(const Box& box) {
  list()->AddRectFilled(Low(box), High(box), (palette_->accent_text & 0x00ffffffu) | 0x80000000u);
}

void Ui::Hairline(const Box& above) {
  const float y = std::floor(above.y1);
  list()->AddRectFilled({above.x0, y}, {above.x1, y + std::max(1.0f, std::floor(U(1)))},
                        palette_->hairline);
}

void Ui::Picture(Icon icon, const Box& box, Tone tone, Ground ground) {
  const float side = U(kMeasures.icon);
  const Box at = BoxAt(box.middle_x() - side / 2, box.middle_y() - side / 2, side, side);
  DrawIcon(list(), icon, at, ColorOf(*palette_, tone, ground), U(kMeasures.stroke));
}

void Ui::Note(const std::string& text, const Box& beside) {
  note_ = text;
  note_beside_ = beside;
}

void Ui::DrawNote() {
  if (note_.empty()) return;
  const float width = TextWidth(note_, Letter::kSmall) + U(20), height = U(32);
  const bool left_half = note_beside_.middle_x() < window().middle_x();
  const bool upper = note_beside_.y0 < U(60);
  const float x = left_half ? note_beside_.x1 + U(8) : note_beside_.x0 - U(8) - width;
  const Box beside = BoxAt(x, note_beside_.middle_y() - height / 2, width, height);
  const Box under =
      BoxAt(note_beside_.middle_x() - width / 2, note_beside_.y1 + U(8), width, height);
  DrawNoteIn(note_, Within(upper ? under : beside, window().Inset(U(4))), *palette_);
}

void Ui::DrawPenWord() {
  const PanelPen& pen = view_->pen;
  if (pen.word.empty() || !pen.position_px) return;
  // A sheet came up under a resting pen.
  if (!pen.down && output_->IsOverSheet(*pen.position_px)) return;
  const Box room = window().Inset(U(4));
  const std::string word = Elided(pen.word, Letter::kSmall, room.width() - U(20));
  const float width = TextWidth(word, Letter::kSmall) + U(20);
  std::vector<Box> controls;
  for (const PanelTarget& target : output_->targets) {
    if (target.visible) controls.push_back(At(target));
  }
  DrawNoteIn(word,
             WordBeside(*pen.position_px, width, U(28), room, view_->settings.left_handed, scale_,
                        controls),
             PaletteOf(Theme::kLight));  // the drawing is paper in both themes
}

void Ui::DrawNoteIn(const std::string& text, const Box& box, const Palette& palette) {
  ImDrawList* over = ImGui::GetForegroundDrawList();
  over->AddRectFilled(Low(box), High(box), palette.note, U(kMeasures.small_radius));
  const ImFont* font = FontOf(Letter::kSmall);
  over->AddText(font, font->FontSize,
                {std::floor(box.x0 + U(10)), std::floor(box.middle_y() - font->FontSize / 2)},
                palette.on_note, text.data(), text.data() + text.size());
  output_->texts.push_back({text,
                            {box.x0 + U(10), box.middle_y() - font->FontSize / 2},
                            {box.x1 - U(10), box.middle_y() + font->FontSize / 2},
                            {box.x0, box.y0},
                            {box.x1, box.y1},
                            palette.on_note,
                            palette.note});
}

ImDrawList* Ui::list() const { return ImGui::GetWindowDrawList(); }

}  // namespace parti::app::panels
