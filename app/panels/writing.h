// Names to write files under: what is proposed, and the question before another file is replaced.
// What is there is in PanelView::files; that nothing is replaced unasked is the session's.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/file_ending.h"
#include "app/panels/form.h"

namespace parti::app::panels {

/// `name`, or the first of "name 2", "name 3", … that is free in the folder with this ending; "" is
/// none. Without the ending.
std::string FreeName(const PanelFiles& files, const std::string& name, std::string_view ending);

/// What the document is called; of one without a name a free one, "House". Without the ending.
std::string NameNow(const PanelView& view, std::string_view ending);

/// A form's action that writes a file. Where another one would be replaced it asks first, in the
/// same place. What to send; nothing until that is answered.
std::optional<DocumentRequest> WriteButton(Ui* ui, Memory* memory, Form* form,
                                           const std::string& words, DocumentRequest request,
                                           bool enabled);

}  // namespace parti::app::panels
