#include "app/model_file.h"

#include "base/text_file.h"

namespace parti::app {

tl::expected<ModelFile, std::vector<Error>> ReadModelFile(const std::string& path,
                                                          std::string_view lot) {
  const auto text = ReadFile(path);
  if (!text) return tl::unexpected<std::vector<Error>>({text.error()});
  auto trees = grammar::ParseTrees(*text, path);
  if (!trees) return tl::unexpected<std::vector<Error>>(std::move(trees.error()));
  auto lots = ParseLots(lot);
  if (!lots) return tl::unexpected<std::vector<Error>>({lots.error()});
  return ModelFile{std::move(*lots), std::move(*trees)};
}

}  // namespace parti::app
