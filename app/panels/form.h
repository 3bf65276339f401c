// Sheets that open under a button, row by row: a heading, fields, things to choose.
// What the rows mean is each sheet's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Rows from the top down; `height` is what they took so far.
class Form {
 public:
  /// A form that only measures where `draw` is false.
  Form(Ui* ui, const Box& room, bool draw) : ui_(ui), room_(room), draw_(draw) {}

  /// The next row; below it a gap.
  Box Row(float height, float gap_units = 4);
  bool draw() const { return draw_; }
  float height() const { return height_; }

  /// A heading, and a button that closes the sheet. true: it was pressed.
  bool Heading(const std::string& words);
  /// Small words over what follows.
  void Label(const std::string& words);
  /// Several lines of quiet words.
  void Words(const std::string& words);
  /// A row that can be tapped, with something small beside or under it.
  bool Choice(const ButtonLook& look, const std::string& below = {});
  /// The thing to do next.
  bool Action(const std::string& words, bool enabled = true);
  /// Several buttons side by side; the one that was pressed, -1 none.
  int Buttons(const std::vector<ButtonLook>& looks);
  /// A question about what can't be had again, with what does it and "Keep" under it: whether it is
  /// to be done; nothing while that is open.
  std::optional<bool> AskOnceMore(const std::string& question, const std::string& act);
  /// Less, words, more: -1, 0 or 1.
  int Stepper(const std::string& what, const std::string& words, bool less, bool more);
  /// A text field under a label.
  std::optional<std::string> Field(const std::string& label, const std::string& value,
                                   const std::string& hint = {});
  /// A name with a switch.
  bool Switch(const std::string& name, const std::string& below, bool on);

 private:
  Ui* ui_;
  Box room_;
  bool draw_;
  float height_ = 0;
};

}  // namespace parti::app::panels
