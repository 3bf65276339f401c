// A document's whole session as a drawing (.pen), to be attached to a report of a fault: `parti
// replay` does everything again that was done in it. docs/drawings.md describes the form.
#pragma once

#include <string>

#include "app/document.h"
#include "input/drawing.h"

namespace parti::app {

/// Its strokes come from one pen that points into the view, one pixel a millimetre; strokes that
/// were drawn in another run of the program follow half a second after the one before.
/// Property  (1) replayed, it gives the document's rules, as long as the program reads sketches as
///               it did.
/// errors  kDamagedFile  the history names a stroke that is not there;  kNothingMade  there is
/// none.
Result<input::Drawing> DrawingOf(const Document& document);

/// errors  those of DrawingOf and WriteDrawing; kFile.
Result<void> WriteReport(const Document& document, const std::string& path);

}  // namespace parti::app
