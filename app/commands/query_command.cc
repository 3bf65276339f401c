// `parti query FILE QUERY`: the shapes that match, as docs/interfaces.md says.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/open_model.h"
#include "grammar/operation.h"

namespace parti::app {
namespace {

using grammar::ShapeIndex;
using grammar::ShapeTree;
using OrderedJson = nlohmann::ordered_json;

struct QueryOptions {
  ModelOptions model;
  std::string query;
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

Result<std::vector<Match>> MatchesOf(const grammar::Query& query, const Model& model) {
  std::vector<Match> matches;
  for (size_t lot = 0; lot < model.derived.size(); ++lot) {
    const ShapeTree& tree = model.derived[lot]->tree;
    const auto product = grammar::ProductOf(query, tree);
    if (!product) return Fail(product);
    for (const ShapeIndex shape : *product) {
      matches.push_back({IdOf(model, {lot, shape}), &tree, shape});
    }
  }
  return matches;
}

int Print(const std::vector<Match>& matches, double ms, bool as_json) {
  if (!as_json) {
    std::string ids;
    for (const Match& match : matches) ids += match.id + '\n';
    return PrintAnswer(ids);
  }
  OrderedJson shapes = OrderedJson::array();
  for (const Match& match : matches) shapes.push_back(JsonOf(match));
  return PrintAnswer(OrderedJson{{"shapes", shapes}, {"ms", ms}}.dump() + '\n');
}

int RunQuery(const QueryOptions& options) {
  const auto query = grammar::ParseQuery(options.query, "QUERY");
  if (!query) return Report(query.error());
  const auto opened = OpenModel(options.model);
  if (!opened) return ReportAll(opened.error());
  const auto start = std::chrono::steady_clock::now();
  const auto matches = MatchesOf(*query, opened->model);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  if (!matches) return Report(matches.error());
  const int printed = Print(*matches, took.count(), options.json);
  if (!matches->empty() || printed != kDone) return printed;
  return Report({ErrorCode::kNothingMade, fmt::format("'{}' selects no shape", options.query),
                 "parti query FILE '*' lists all shapes"});
}

}  // namespace

void AddQueryCommand(CLI::App& app, Run* run) {
  CLI::App* command = app.add_subcommand("query", "Lists the shapes that a query selects");
  const auto options = std::make_shared<QueryOptions>();
  AddModelOptions(command, &options->model);
  command->add_option("QUERY", options->query, "Operation.symbol#tag:filter, joined by > / ~")
      ->required();
  command->add_flag("--json", options->json, "one JSON object instead of ids");
  command->footer(
      "Example:\n"
      "  parti query house.cga '.Facade:north / .Floor:even > .Window' --lot 'rect(20,12)'");
  command->callback([options, run] { *run = [options] { return RunQuery(*options); }; });
}

}  // namespace parti::app
