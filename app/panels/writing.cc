#include "app/panels/writing.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/panels/sheet_rows.h"

namespace parti::app::panels {
namespace {

constexpr const char* kUnnamed = "House";

bool IsThere(const PanelFiles& files, const std::string& name) {
  const auto is_it = [&](const PanelFile& file) { return file.name == name; };
  return std::any_of(files.here.begin(), files.here.end(), is_it) ||
         (files.others && files.others->contains(name));
}

/// Whether a file goes for good by this: the document's own doesn't, but what another Parti wrote
/// into it does.
bool Replaces(const PanelView& view, const DocumentRequest& request) {
  if (request.kind == DocumentRequest::Kind::kSaveAs && view.session) {
    const DocumentStatus& document = view.session->document;
    if (document.path == request.path && !document.read_only) return false;
  }
  return FolderOf(request.path) == view.files.folder && IsThere(view.files, NameIn(request.path));
}

}  // namespace

std::string FreeName(const PanelFiles& files, const std::string& name, std::string_view ending) {
  std::string free = name;
  for (int i = 2; IsThere(files, fmt::format("{}{}", free, ending)); ++i)
    free = fmt::format("{} {}", name, i);
  return free;
}

std::string NameNow(const PanelView& view, std::string_view ending) {
  if (!view.session || !view.session->document.named) {
    return FreeName(view.files, kUnnamed, ending);
  }
  const std::string name = NameIn(view.session->document.path);
  return name.ends_with(kDocumentEnding) ? name.substr(0, name.size() - kDocumentEnding.size())
                                         : name;
}

std::optional<DocumentRequest> WriteButton(Ui* ui, Memory* memory, Form* form,
                                           const std::string& words, DocumentRequest request,
                                           bool enabled) {
  if (memory->doomed_file != request.path) {
    if (!form->Action(words, enabled)) return std::nullopt;
    if (!Replaces(ui->view(), request)) return request;
    memory->doomed_file = request.path;
    return std::nullopt;
  }
  const auto goes = form->AskOnceMore(
      fmt::format("Replace {}? What it holds can't be had again.", NameIn(request.path)),
      "Replace");
  if (goes) memory->doomed_file.clear();
  if (!goes || !*goes) return std::nullopt;
  request.replace = true;
  return request;
}

}  // namespace parti::app::panels
