// What panels show, as one value: a snapshot of the session and what the application knows beside
// it. Panels only read it; what a person does with them comes back as PanelOutput.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/placing/element_in_hand.h"
#include "app/session_snapshot.h"
#include "app/settings.h"
#include "base/math.h"

namespace parti::app {

/// What a pen, mouse or drawing finger does on the drawing.
enum class PointerMode : uint8_t { kDraw, kErase, kSelect, kOrbit, kPan, kZoom };

/// Where the pen or mouse is that draws.
struct PanelPen {
  std::optional<Vec2> position_px;  ///< in the view; absent: away
  bool down = false;                ///< it draws on the drawing: open sheets close
  /// What it hovers over: "corner of Facade"; or how what it drags stands: "1.20 m wide, 2.00 m
  /// high"; "" nothing.
  std::string word = {};
};

/// A name in a folder.
struct PanelFile {
  std::string name;  ///< UTF-8, without its folder
  bool is_folder = false;
};

/// Names of files for the document sheet; panels look into no folder themselves.
struct PanelFiles {
  std::vector<std::string> recent;       ///< paths of documents, the newest first
  std::string folder;                    ///< path of the folder that `here` lies in
  std::vector<PanelFile> here;           ///< folders and documents, in the order to show
  std::vector<std::string> drafts = {};  ///< paths of those that were left, the newest first
  std::string trouble = {};              ///< why a draft could not be thrown away; "" all is well
  /// Names of all else that lies in `folder`: a new file would replace it. null: nothing.
  std::shared_ptr<const std::set<std::string>> others = {};
};

/// Everything that a frame of panels depends on, input apart.
struct PanelView {
  std::shared_ptr<const SessionSnapshot> session;  ///< the newest; null: nothing yet
  PanelFiles files;
  Settings settings;
  double scale = 1;  ///< view pixels per unit of the panels, [1, 3]: what is set, or the display's
  PointerMode mode = PointerMode::kDraw;
  Vec2 size_px{1600, 1000};  ///< of the view, each in [1, 1e5]
  PanelPen pen;
  std::optional<Vec2> tapped_px;         ///< where shapes were tapped last, in the view
  std::vector<SeenElement> elements;     ///< that show handles on the drawing
  std::optional<ElementInHand> element;  ///< the one of them that is in hand
  bool has_keys = true;                  ///< a keyboard is there; else fields bring up our own
};

}  // namespace parti::app
