// What a frame of panels comes to: commands for the session, requests to the application, and
// triangles for the canvas.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/panels/panel_view.h"
#include "render/image.h"
#include "render/ui_mesh.h"

namespace parti::app {

/// Asks for PanelFiles of another folder.
struct ListFolder {
  std::string path;
  bool operator==(const ListFolder&) const = default;
};

/// Deletes a draft that was left, for good.
struct ThrowAway {
  std::string path;
  bool operator==(const ThrowAway&) const = default;
};

/// A look at the model that needs no name: "fit" and the standard views.
enum class ViewRequest : uint8_t { kFit, kSouth, kEast, kNorth, kWest, kAbove, kNearer, kFarther };

/// For the session thread: Command, DocumentRequest; for the application: the others.
using PanelCommand = std::variant<Command, DocumentRequest, ListFolder, ThrowAway, ViewRequest,
                                  ElementCommand, PointerMode, Settings>;

/// A sheet that lies on the drawing.
struct PanelSheet {
  std::string name;  ///< the part of its targets' names before the slash
  Vec2 low_px, high_px;

  /// The lower and right edges are not its own.
  bool Contains(const Vec2& px) const {
    return px.x >= low_px.x && px.x < high_px.x && px.y >= low_px.y && px.y < high_px.y;
  }
};

/// A thing that can be tapped, as tests and helpers for the blind know it.
struct PanelTarget {
  std::string name;  ///< "Tools/Undo": its panel and what it says
  Vec2 low_px, high_px;
  bool enabled = true;
  bool visible = true;  ///< no part of it is scrolled away
};

/// A line of text as it was drawn.
struct PanelText {
  std::string text;
  Vec2 low_px, high_px;            ///< what the letters cover
  Vec2 room_low_px, room_high_px;  ///< what they may cover
  uint32_t color = 0, ground = 0;  ///< as UiVertex::rgba
};

/// One frame.
struct PanelOutput {
  std::vector<PanelCommand> commands;  ///< in the order they were asked for
  /// A number that is being dragged: the application may show what it would come to. Not a command:
  /// the one that counts is sent when it is let go, so that undo has one step.
  std::optional<SetNumber> trial;
  std::optional<size_t> preview;        ///< index of the suggestion to show as wire frame
  std::optional<size_t> query_preview;  ///< index of the query whose shapes to outline
  bool node_shown = false;              ///< the node in hand is to be seen: keys may act on it
  bool takes_pointer = false;           ///< the pointer is the panels'; draw no ink, orbit nothing
  bool holds_pointer = false;           ///< it is theirs wherever it goes: a press or a text field
  bool takes_keys = false;  ///< a text field is active, or a key of this frame moved or pressed
                            ///< what has the focus, or opened or closed a sheet

  render::UiMesh mesh;  ///< its texture 0 is `letters`
  bool changed = true;  ///< the mesh differs from the one before
  /// White, with letters and lines as alpha. Another picture after the scale changed: compare
  /// pointers.
  std::shared_ptr<const render::Image> letters;

  std::vector<PanelSheet>
      sheets;           ///< that are shown, from back to front; numbers of UiCommand::part
  double reach_px = 0;  ///< sheets this near to a pen that draws are to step aside
  std::vector<PanelTarget> targets;  ///< in the order in which Tab goes through them
  std::string focus;                 ///< the target's name that Enter presses; "" none
  std::vector<PanelText> texts;

  /// Whether a pixel is a sheet's.
  bool IsOverSheet(const Vec2& px) const {
    return std::any_of(sheets.begin(), sheets.end(),
                       [&](const PanelSheet& sheet) { return sheet.Contains(px); });
  }
};

}  // namespace parti::app
