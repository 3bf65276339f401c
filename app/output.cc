#include "app/output.h"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "app/export_glb.h"
#include "app/export_obj.h"
#include "app/file_ending.h"
#include "app/picture.h"
#include "base/text_file.h"
#include "grammar/rules/rule_text.h"

namespace parti::app {
namespace {

/// The CityEngine whose words we write, for rules that name none.
constexpr std::string_view kCgaVersion = "2021.0";

struct Request {
  const Model& model;
  const std::optional<Camera>& view;
  const std::string& path;
};

std::vector<const grammar::ShapeTree*> TreesOf(const Model& model) {
  std::vector<const grammar::ShapeTree*> trees;
  for (const auto& derivation : model.derived) trees.push_back(&derivation->tree);
  return trees;
}

Result<void> WriteGltf(const Request& request, GltfForm form) {
  return ExportGltf(PartsOf(TreesOf(request.model)), form, request.path);
}

Result<void> WriteRules(const Request& request) {
  grammar::RuleSet rules;
  if (request.model.ground->source) {
    auto written = RulesToWrite(*request.model.ground->source);
    if (!written) return tl::unexpected<Error>(written.error().front());
    rules = std::move(*written);
    if (rules.version.empty()) rules.version = kCgaVersion;
  }
  rules.trees = request.model.trees();
  const std::string text = grammar::TextOf(rules);
  if (text.empty()) {
    return Fail(ErrorCode::kNothingMade, fmt::format("there are no rules for {}", request.path));
  }
  return WriteFile(request.path, text);
}

Result<void> WriteView(const Request& request) {
  SessionState state;
  state.model = request.model;
  state.camera = request.view.value_or(AutoViewOf(request.model, kPictureSize_px));
  return WritePicture(state, request.path);
}

struct Format {
  std::string_view ending;
  Result<void> (*write)(const Request&);
};

constexpr std::array kFormats = {
    Format{".glb", [](const Request& r) { return WriteGltf(r, GltfForm::kBinary); }},
    Format{".gltf", [](const Request& r) { return WriteGltf(r, GltfForm::kText); }},
    Format{".obj", [](const Request& r) { return ExportObj(PartsOf(TreesOf(r.model)), r.path); }},
    Format{".cga", WriteRules},
    Format{".png", WriteView},
};

/// null: none.
const Format* FormatFor(const std::string& path) {
  const std::string ending = EndingOf(path);
  for (const Format& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

}  // namespace

Result<void> CheckExportEnding(const std::string& path) {
  if (FormatFor(path) != nullptr) return {};
  return Fail(ErrorCode::kUnknownName,
              fmt::format("'{}' is no format to export to ({})", EndingOf(path), path),
              fmt::format("there are {}", ExportEndings()));
}

Result<void> CheckEndings(const std::vector<std::string>& exports, const std::string& png,
                          const std::string& document) {
  for (const std::string& path : exports) {
    if (auto known = CheckExportEnding(path); !known) return known;
  }
  if (auto fine = CheckEnding(png, ".png"); !fine) return fine;
  return CheckEnding(document, kDocumentEnding);
}

std::string ExportEndings() {
  std::string endings;
  for (const Format& format : kFormats) {
    endings += fmt::format("{}{}", endings.empty() ? "" : ", ", format.ending);
  }
  return endings;
}

Result<void> ExportModel(const Model& model, const std::optional<Camera>& view,
                         const std::string& path) {
  if (auto known = CheckExportEnding(path); !known) return known;
  return FormatFor(path)->write({model, view, path});
}

}  // namespace parti::app
