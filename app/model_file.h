// The rules of a model from a text file, and the lots they run on. `.parti` documents are
// app/document's.
#pragma once

#include <string>
#include <vector>

#include "app/lot.h"
#include "base/error.h"
#include "grammar/selection_action.h"

namespace parti::app {

/// What a text is derived on when no lot is given.
inline constexpr std::string_view kUsualLot = "rect(20,20)";

/// What a text says, and the ground that it was told of.
struct ModelFile {
  std::vector<Lot> lots;
  grammar::Trees trees;
};

/// errors  kFile;  those of ParseTrees, all of them;  those of ParseLots.
tl::expected<ModelFile, std::vector<Error>> ReadModelFile(const std::string& path,
                                                          std::string_view lot = kUsualLot);

}  // namespace parti::app
