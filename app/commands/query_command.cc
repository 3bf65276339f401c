// `parti query FILE QUERY`: the shapes that match, as docs/interfaces.md says.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/model_file.h"
#include "grammar/operation.h"

namespace parti::app {
namespace {

using grammar::ShapeIndex;
using grammar::ShapeTree;
using OrderedJson = nlohmann::ordered_json;

struct QueryOptions {
  std::string file;
  std::string query;
  std::string lot{kUsualLot};
  bool json = false;
};

struct Match {
  std::string id;
  const ShapeTree* tree;
  ShapeIndex shape;
};

OrderedJson JsonOf(const Match& match) {
  const grammar::Shape& shape = (*match.tree)[match.shape];
  OrderedJson tags = OrderedJson::array();
  for (const grammar::NameId tag : shape.tags) tags.push_back(match.tree->Name(tag));
  return {{"id", match.id},
          {"symbol", match.tree->Name(shape.symbol)},
          {"tags", tags},
          {"operation", shape.operation != nullptr ? shape.operation->word : std::string_view()},
          {"leaf", match.tree->IsLeaf(match.shape)}};
}

/// One tree per lot, all rules run.
Result<std::vector<ShapeTree>> DeriveAll(const ModelFile& model) {
  std::vector<ShapeTree> trees;
  for (const Lot& lot : model.lots) {
    auto derivation = grammar::Derive(model.trees, ShapeTree(lot.item));
    if (!derivation) {
      Error error = derivation.error();
      if (model.lots.size() > 1)
        error.message = fmt::format("lot '{}': {}", lot.name, error.message);
      return tl::unexpected<Error>(std::move(error));
    }
    trees.push_back(std::move(derivation->tree));
  }
  return trees;
}

Result<std::vector<Match>> MatchesOf(const grammar::Query& query,
                                     const std::vector<ShapeTree>& trees) {
  std::vector<Match> matches;
  for (size_t lot = 0; lot < trees.size(); ++lot) {
    const auto product = grammar::ProductOf(query, trees[lot]);
    if (!product) return Fail(product);
    for (const ShapeIndex shape : *product) {
      const std::string id = trees[lot].IdOf(shape);
      matches.push_back(
          {trees.size() > 1 ? fmt::format("lot-{}:{}", lot, id) : id, &trees[lot], shape});
    }
  }
  return matches;
}

void Print(const std::vector<Match>& matches, double ms, bool as_json) {
  if (!as_json) {
    for (const Match& match : matches) fmt::print("{}\n", match.id);
    return;
  }
  OrderedJson shapes = OrderedJson::array();
  for (const Match& match : matches) shapes.push_back(JsonOf(match));
  fmt::print("{}\n", OrderedJson{{"shapes", shapes}, {"ms", ms}}.dump());
}

int RunQuery(const QueryOptions& options) {
  const auto query = grammar::ParseQuery(options.query, "QUERY");
  if (!query) return Report(query.error());
  const auto model = ReadModelFile(options.file, options.lot);
  if (!model) {
    for (const Error& error : model.error()) Report(error);
    return kFailed;
  }
  const auto trees = DeriveAll(*model);
  if (!trees) return Report(trees.error());
  const auto start = std::chrono::steady_clock::now();
  const auto matches = MatchesOf(*query, *trees);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  if (!matches) return Report(matches.error());
  Print(*matches, took.count(), options.json);
  if (!matches->empty()) return kDone;
  return Report({ErrorCode::kNothingMade, fmt::format("'{}' selects no shape", options.query),
                 "parti query FILE '*' lists all shapes"});
}

}  // namespace

void AddQueryCommand(CLI::App& app, Run* run) {
  CLI::App* command = app.add_subcommand("query", "Lists the shapes that a query selects");
  const auto options = std::make_shared<QueryOptions>();
  command->add_option("FILE", options->file, "a .cga text with trees")->required();
  command->add_option("QUERY", options->query, "Operation.symbol#tag:filter, joined by > / ~")
      ->required();
  command
      ->add_option(
          "--lot", options->lot,
          "rect(WIDTH,DEPTH), poly(x,z x,z …), or a GeoJSON (in metres), CityJSON or rings "
          "JSONL file")
      ->capture_default_str();
  command->add_flag("--json", options->json, "one JSON object instead of ids");
  command->footer(
      "Example:\n"
      "  parti query house.cga '.Facade:north / .Floor:even > .Window' --lot 'rect(20,12)'");
  command->callback([options, run] { *run = [options] { return RunQuery(*options); }; });
}

}  // namespace parti::app
