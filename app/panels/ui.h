// What panels are made of: sheets, lists, buttons, fields, text, in one style.
// Every thing drawn is noted (PanelOutput::targets, texts); what it does is the panels'.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/box.h"
#include "app/panels/icons.h"
#include "app/panels/imgui_host.h"
#include "app/panels/panel_output.h"
#include "app/panels/theme.h"

namespace parti::app::panels {

/// Sizes and weights of letters.
enum class Letter : uint8_t { kBody, kSmall, kStrong };

/// How a text looks.
struct TextLook {
  Letter letter = Letter::kBody;
  Tone tone = Tone::kText;
  Ground ground = Ground::kPanel;
  float align = 0;  ///< 0 left, 0.5 middle, 1 right
};

/// A button. `name` is what it is called, and written on it unless `label` is something else.
struct ButtonLook {
  std::string name;
  Icon icon = Icon::kNone;
  std::string label = {};  ///< with an icon and no label: a note says the name on hovering
  std::string keys = {};   ///< its shortcut, for the note
  bool chosen = false;
  bool enabled = true;
  Ground ground = Ground::kPanel;  ///< what it lies on, or kAccent: the thing to do next
  float align = 0.5f;
  bool bordered = false;
};

/// What became of a button in this frame.
struct Press {
  bool pressed = false;
  bool hovered = false;
  bool held = false;
};

/// A number that can be dragged, stepped and typed.
struct NumberLook {
  std::string name;
  double value = 0, low = 0, high = 0;
  double step = 0.05;    ///< of one pixel unit of dragging; typed numbers are not rounded
  std::string unit;      ///< "m"
  bool changed = false;  ///< differs from its default
};

/// What a person wants of it.
struct NumberWish {
  std::optional<double> trial;   ///< while it is dragged
  std::optional<double> commit;  ///< let go, stepped or typed, and other than before
};

/// Draws one frame into an ImGuiHost and remembers, between frames, what is typed and focused.
class Ui {
 public:
  explicit Ui(ImGuiHost* host) : host_(host) {}

  /// Between these, the rest may be called. `output` gets commands, targets and texts.
  void Begin(const PanelView& view, double scale, PanelOutput* output);
  void End();

  /// Notes a key for keyboard focus and shortcuts; call before Begin, at most one a frame.
  void FeedKey(const KeyEvent& key);

  double scale() const { return scale_; }
  /// Pixels of a length in the panels' units.
  float U(float units) const { return static_cast<float>(units * scale_); }
  const Palette& palette() const { return *palette_; }
  const PanelView& view() const { return *view_; }
  /// All of the view.
  Box window() const;

  /// Adds to PanelOutput::commands.
  void Send(PanelCommand command);
  /// The same for what a person has typed: text that ParseCommand would not read back as this
  /// command is complained of instead.
  void SendTyped(const Command& command);
  /// PanelOutput::trial.
  void Try(SetNumber number);
  /// What was wrong with the last that was typed; "" nothing.
  const std::string& complaint() const { return complaint_; }
  void DropComplaint() { complaint_.clear(); }
  bool touched() const { return touched_; }  ///< something was pressed or typed in this frame

  /// A sheet on the drawing.
  void BeginSheet(std::string_view name, const Box& box);
  void EndSheet();
  /// A part of the sheet that scrolls, by wheel and by dragging. Returns where its content begins:
  /// content_height tall, as wide as the box.
  Box BeginList(std::string_view name, const Box& box, float content_height);
  void EndList();

  /// In the style of all buttons.
  Press Button(const ButtonLook& look, const Box& box);
  /// What became of a FieldOver.
  struct Over {
    bool typing = false, hovered = false;
  };
  /// A part of a sheet that is drawn by the caller and becomes a field when it is tapped; what was
  /// typed. Where it is hovered the ground is there already, where it is typed into all of it.
  std::optional<std::string> FieldOver(const std::string& name, const Box& box,
                                       const std::string& value, Over* over);
  /// A press without a look of its own. `name` is unique in its sheet.
  Press Area(const std::string& name, const Box& box, bool enabled = true);
  /// Scrolls the list being drawn so that a part of it is seen.
  void ScrollTo(const Box& part);
  /// Only notes a target that somebody else presses.
  void NoteTarget(const std::string& name, const Box& box);
  /// What was typed, when it is done with.
  std::optional<std::string> Field(const std::string& name, const Box& box,
                                   const std::string& value, const std::string& hint = {});
  /// The field of this name is typed into from now on, all that it has selected; call it before it.
  void StartTyping(const std::string& name, const std::string& value) {
    StartEdit(Full(name), value);
  }
  /// Less, the number, more.
  NumberWish Number(const NumberLook& look, const Box& box);
  /// true: it is to be switched over.
  bool Switch(const std::string& name, const Box& box, bool on, Ground ground = Ground::kPanel);

  /// One line, cut off with "…" where it is too long for its room.
  void Text(std::string_view text, const Box& room, const TextLook& look = {});
  /// Several lines; the height that they take. `draw` false: only measured.
  float Paragraph(std::string_view text, const Box& room, const TextLook& look = {},
                  bool draw = true);
  float TextWidth(std::string_view text, Letter letter) const;
  float LineHeight(Letter letter) const;

  /// Shapes, in the colours of the theme.
  void Fill(const Box& box, Ground ground, float radius_units);
  /// A hairline around.
  void Border(const Box& box, float radius_units);
  void Accent(const Box& box);      ///< in the accent's colour, half transparent
  void Hairline(const Box& above);  ///< along its lower edge
  void Picture(Icon icon, const Box& box, Tone tone, Ground ground);
  void Note(const std::string& text, const Box& beside);
  /// What the pen hovers over, or how what it drags stands, beside its tip.
  void DrawPenWord();
  ImDrawList* list() const;

  /// The key of this frame was a field's, or moved or pressed what has the focus.
  bool took_key() const { return took_key_; }
  /// Something is being typed.
  bool field_active() const { return !editing_.empty(); }
  /// A name that has the keyboard's focus, "" none.
  const std::string& focus() const { return focus_; }
  void LetGoOfFocus() { focus_.clear(); }
  /// The drag under way is not to scroll the list that it began in.
  void KeepDrag() { scrolling_.clear(); }
  bool pointer_over() const { return pointer_over_; }  ///< a sheet, or it holds something of one
  Vec2 pointer_px() const;

 private:
  struct Place {
    std::string name;
    Box box;
    Box list;  ///< that it scrolls in; empty: none
  };
  std::string Full(const std::string& name) const { return sheet_ + "/" + name; }
  void MoveFocus(const KeyEvent& key);
  void FocusNext(int step);
  void FocusBeside(int dx, int dy);
  bool TakeEnter(const std::string& full);
  bool WantsNote(const std::string& full, const Press& press);
  void ShowFocus(const std::string& full, const Box& box);
  void ScrollWithPointer(const std::string& full, const Box& box);
  void AddTarget(const std::string& full, const Box& box, bool enabled);
  void StartEdit(const std::string& full, const std::string& value);
  std::optional<std::string> Edit(const std::string& full, const Box& box,
                                  const std::string& value);
  void EditText(const std::string& full, const Box& box, bool* entered);
  NumberWish Typed(const std::string& text, double before);
  NumberWish Drag(const std::string& full, const NumberLook& look, const Press& press);
  void DrawNote();
  void DrawNoteIn(const std::string& text, const Box& box, const Palette& palette);
  ImFont* FontOf(Letter letter) const;
  std::vector<std::string> Wrapped(std::string_view text, Letter letter, float width) const;
  std::string Elided(std::string_view text, Letter letter, float width) const;

  ImGuiHost* host_;
  const PanelView* view_ = nullptr;
  const Palette* palette_ = nullptr;
  PanelOutput* output_ = nullptr;
  double scale_ = 1;
  bool touched_ = false;
  bool pointer_over_ = false;

  std::string sheet_;        // being drawn
  std::optional<Box> list_;  // being drawn
  std::string scrolling_;    // the list that a press may scroll
  bool scrolls_ = false;     // and does

  std::string editing_, draft_;  // the active text field and its text
  int edit_age_ = 0;             // frames since it was asked for
  bool edit_seen_ = false;
  std::string dragging_;  // the number being dragged
  double drag_from_ = 0, drag_to_ = 0;
  bool drag_seen_ = false;

  std::string focus_;
  bool focus_moved_ = false;
  std::vector<Place> places_, places_before_;  // where Tab and arrows go
  std::optional<KeyEvent> key_;
  bool took_key_ = false;
  std::string complaint_;
  std::string hushed_;  // its note was read, or not wanted: it was pressed
  std::string note_;
  Box note_beside_;
};

}  // namespace parti::app::panels
