// What panels remember between frames and nobody else needs: what is open, what is being chosen.
// What a person types is ui.h's; what is kept is the session's and the settings'.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/panels/box.h"
#include "app/panels/cards.h"
#include "app/panels/file_text.h"
#include "app/panels/layer_rows.h"
#include "app/panels/layout.h"
#include "app/panels/rules_text.h"

namespace parti::app::panels {

/// A sheet that opens under a button; at most one does.
enum class Sheet : uint8_t { kNone, kDocument, kOpen, kSaveAs, kViews, kExport, kSettings };

/// What the rules' sheet shows them as.
enum class RulesAs : uint8_t { kRows, kText, kLayers };

/// Shared by the panels of one frame.
struct Memory {
  Layout layout;
  Sheet open = Sheet::kNone;
  Box opened_at;             ///< the button that opened it
  bool rules_shown = false;  ///< the drawing stays clear until they are asked for
  RulesAs rules_as = RulesAs::kRows;
  TypedRules typed_rules;
  TypedFiles typed_files;
  KnownFiles known_files;
  KnownRules known_rules;
  std::string open_layer;             ///< "Facade.door": its rule is being picked; "" none
  std::optional<uint64_t> dismissed;  ///< FailedRequest::number that was read
  std::string file_name;              ///< being given, without its folder
  std::string doomed_file;            ///< asked about: replace it?
  bool name_asked = false;  ///< the sheet that asks for it has been opened, and not drawn yet
  std::string export_ending = "glb";
  std::string view_name;
  bool drafts_seen = false;  ///< the card that offers them at the start was closed
  std::string doomed_draft;  ///< asked about: throw it away?
  StandingCards suggestions, queries, element;
  std::vector<int> shown_node;    ///< path of the row in hand that was scrolled into sight
  std::vector<int> dragged_node;  ///< path of the row that is being moved; empty: none

  /// Opens a sheet where the one before stood. Names are proposed anew.
  void Show(Sheet sheet) {
    open = sheet;
    name_asked = sheet == Sheet::kSaveAs || sheet == Sheet::kExport;
    doomed_file.clear();
  }
  /// Opens a sheet, or closes it when it is the one that is open.
  void Toggle(Sheet sheet, const Box& button) {
    Show(open == sheet ? Sheet::kNone : sheet);
    opened_at = button;
  }
};

}  // namespace parti::app::panels
