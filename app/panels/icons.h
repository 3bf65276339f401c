// Our own icons, drawn as lines: no icon font, sharp at every scale.
// What they stand for is the panels'; colours are theme.h's.
#pragma once

#include <cstdint>

#include "app/panels/box.h"
#include "app/panels/theme.h"

struct ImDrawList;

namespace parti::app::panels {

/// All icons there are; kNone draws nothing.
enum class Icon : uint8_t {
  kNone,
  kDraw,
  kErase,
  kSelect,
  kOrbit,
  kPan,
  kZoom,
  kFit,
  kUndo,
  kRedo,
  kFinger,
  kDocument,
  kNew,
  kOpen,
  kSave,
  kFolder,
  kBookmark,
  kExport,
  kRules,
  kSettings,
  kClose,
  kUp,
  kDown,
  kLeft,
  kRight,
  kDelete,
  kGrip,
  kPlus,
  kMinus,
  kReset,
  kEye,
  kEyeOff,
  kCheck,
  kWarning,
  kLock,
  kBusy,
  kHint,
  kSun,
  kMoon,
  kBackspace,
  kEnter,
  kShift,
  kExtrude,
  kComp,
  kSplitUpward,
  kSplitAcross,
  kRepeatUpward,
  kRepeatAcross,
  kOffset,
  kColor,
  kTag,
  kOperation,
  kQuery,
  kRecord,
  kSameSize,
  kAlignLeft,
  kCenterAcross,
  kAlignRight,
  kAlignTop,
  kCenterUp,
  kAlignBottom,
};

/// Draws it into the middle of a box with lines of that width [px].
void DrawIcon(ImDrawList* list, Icon icon, const Box& box, Color color, float stroke_px);

}  // namespace parti::app::panels
