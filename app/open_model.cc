#include "app/open_model.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "app/commands/commands.h"
#include "app/document.h"
#include "app/file_ending.h"
#include "app/usable_lots.h"
#include "base/note.h"
#include "grammar/rules/rule_workers.h"

namespace parti::app {
namespace {

using Failed = tl::unexpected<std::vector<Error>>;

tl::expected<OpenedModel, std::vector<Error>> FromDocument(const std::string& path,
                                                           const grammar::RuleThreads& threads) {
  const auto document = OpenDocument(path);
  if (!document) return Failed({document.error()});
  const SessionRecord& present = PresentOf(*document);
  auto ground = WithRoots(present.ground, nullptr, threads);
  if (!ground) return Failed({ground.error()});
  auto model = Derived(std::move(*ground), present.rules, nullptr, grammar::Unfit::kSkip);
  if (!model) return Failed({model.error()});
  return OpenedModel{std::move(*model), present.camera, {}};
}

/// The first option that only a text can have; "" none.
std::string OptionOfTexts(const ModelOptions& options) {
  if (!options.lot.empty()) return "--lot";
  if (!options.start.empty()) return "--start";
  if (!options.sets.empty()) return "--set";
  if (!options.style.empty()) return "--style";
  if (!options.layers_off.empty()) return "--layers-off";
  if (options.seed != 0) return "--seed";
  if (options.skip_bad_lots) return "--skip-bad-lots";
  return options.skip_unknown ? "--skip-unknown" : "";
}

std::vector<std::string> SplitAtCommas(const std::string& list) {
  std::vector<std::string> names;
  for (size_t from = 0; from < list.size();) {
    const size_t comma = std::min(list.find(',', from), list.size());
    if (comma > from) names.push_back(list.substr(from, comma - from));
    from = comma + 1;
  }
  return names;
}

Result<RuleSource> SourceOf(const ModelOptions& options) {
  RuleSource source;
  source.style = options.style;
  source.skip_unknown = options.skip_unknown;
  source.layers.off = SplitAtCommas(options.layers_off);
  source.settings.start = options.start;
  source.settings.seed = options.seed;
  source.settings.limits = options.limits;
  for (const std::string& set : options.sets) {
    const size_t equals = set.find('=');
    if (equals == std::string::npos || equals == 0) {
      return Fail(ErrorCode::kBadArguments, fmt::format("--set '{}' is not NAME=VALUE", set),
                  "for example: --set height=12");
    }
    source.settings.attributes.emplace_back(set.substr(0, equals), set.substr(equals + 1));
  }
  return source;
}

/// What a person sets is held to @Range and @Enum; what rules set is not.
Result<void> AllowedSets(const grammar::RuleSet& rules, const grammar::RuleSettings& settings) {
  for (const auto& [name, text] : settings.attributes) {
    const auto given = grammar::AttributeValue(rules, name, text);
    if (!given) return Fail(given);
    auto allowed = grammar::CheckAllowed(rules.attributes[given->index], given->value);
    if (!allowed) return allowed;
  }
  return {};
}

void ShowSkipped(const UsedLots& used) {
  const size_t skipped = used.skipped.size();
  for (const Error& error : used.skipped) {
    Error shown = error;
    shown.message = "skipped " + shown.message;
    Say(FormatNote(shown));
  }
  if (skipped == 0) return;
  Say(fmt::format("parti: skipped {} of {} lots", skipped, skipped + used.ground->lots.size()));
}

tl::expected<OpenedModel, std::vector<Error>> FromText(const ModelOptions& options,
                                                       const grammar::RuleThreads& threads) {
  if (threads.count != 1) grammar::BeginRuleWorkers();  // while the text is read
  auto source = SourceOf(options);
  if (!source) return Failed({source.error()});
  auto rules = ReadRules(options.file, &*source);
  if (!rules) return Failed(std::move(rules.error()));
  ReportSkipped(*rules);
  if (const auto allowed = AllowedSets(*rules, source->settings); !allowed) {
    return Failed({allowed.error()});
  }
  const std::string lot = options.lot.empty() ? std::string(kUsualLot) : options.lot;
  auto used = UseLots(lot, std::make_shared<const RuleSource>(std::move(*source)), *rules, threads,
                      options.skip_bad_lots);
  if (!used) return Failed({used.error()});
  ShowSkipped(*used);
  auto trees = std::make_shared<const grammar::Trees>(std::move(rules->trees));
  auto model = Derived(std::move(used->ground), std::move(trees), nullptr);
  if (!model) return Failed({model.error()});
  return OpenedModel{std::move(*model), std::nullopt, {}};
}

/// What is wrong with a seed, of which -1 would be taken for 18446744073709551615; "" nothing.
std::string SeedError(const std::string& text) {
  uint64_t seed = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, seed);
  if (read.ec == std::errc() && read.ptr == end) return "";
  return fmt::format("a seed is a whole number from 0 to {}, not '{}'",
                     std::numeric_limits<uint64_t>::max(), text);
}

/// The same of a time; NaN would be no limit at all.
std::string SecondsError(const std::string& text) {
  double seconds = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, seconds);
  if (read.ec == std::errc() && read.ptr == end && seconds >= 0 && std::isfinite(seconds))
    return "";
  return fmt::format("--seconds is a time from 0 on, 0 for any, not '{}'", text);
}

void ShowPrints(const std::vector<grammar::LotNotes>& notes) {
  for (size_t lot = 0; lot < notes.size(); ++lot) {
    const std::string which = notes.size() > 1 ? fmt::format("lot-{}: ", lot) : "";
    for (const std::string& line : notes[lot].prints) Say(fmt::format("{}{}", which, line));
    if (notes[lot].more_prints == 0) continue;
    Say(fmt::format("{}parti: {} more lines were printed", which, notes[lot].more_prints));
  }
}

}  // namespace

void AddModelOptions(CLI::App* command, ModelOptions* options) {
  command->add_option("FILE", options->file, "a .parti document, or a .cga text")->required();
  command->add_option(
      "--lot", options->lot,
      fmt::format("for a text ({}): rect(WIDTH,DEPTH), poly(x,z x,z …), or a GeoJSON "
                  "(in metres), CityJSON or rings JSONL file",
                  kUsualLot));
  command->add_option("--start", options->start, "the lot's symbol (@StartRule, else Lot)");
  command->add_option("--set", options->sets, "NAME=VALUE: an attribute's value")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command->add_option("--seed", options->seed, "of all that is left to chance (0)")
      ->check(SeedError);
  command->add_option("--style", options->style, "a style of the rules");
  command->add_option("--layers-off", options->layers_off, "Rule.layer,Rule.layer: left out");
  command->add_flag("--skip-unknown", options->skip_unknown,
                    "leave out operations and annotations that are not known");
  command->add_flag("--skip-bad-lots", options->skip_bad_lots,
                    "leave out lots of a file that nothing can be made of, and say why");
  command->add_option("--threads", options->threads, "at once (as many as there are cores)")
      ->check(CLI::Range(0, 1024));
  command->add_option("--depth", options->limits.depth, "levels of rules at most (250)");
  command->add_option("--shapes", options->limits.shapes, "of one lot at most (2000000)");
  command->add_option("--seconds", options->limits.seconds, "for one lot at most (any time)")
      ->check(SecondsError);
}

tl::expected<OpenedModel, std::vector<Error>> OpenModel(const ModelOptions& options,
                                                        const grammar::RuleThreads& threads) {
  grammar::RuleThreads chosen = threads;
  chosen.count = options.threads;
  std::vector<grammar::LotNotes> notes;
  chosen.notes = &notes;
  // One that is empty or damaged from its first byte is no text either.
  const bool is_document =
      EndingOf(options.file) == kDocumentEnding || LooksLikeDocument(options.file);
  const std::string extra = is_document ? OptionOfTexts(options) : "";
  if (!extra.empty()) {
    return Failed({Error{ErrorCode::kBadArguments,
                         fmt::format("{} is for texts: a document has its own", extra),
                         "leave it out, or give a .cga text"}});
  }
  auto opened = is_document ? FromDocument(options.file, chosen) : FromText(options, chosen);
  ShowPrints(notes);
  if (opened) opened->notes = std::move(notes);
  return opened;
}

void ReportSkipped(const grammar::RuleSet& rules) {
  for (const std::string& what : rules.skipped) Say(fmt::format("parti: skipped {}", what));
}

int ReportAll(const std::vector<Error>& errors) {
  for (const Error& error : errors) Report(error);
  return kFailed;
}

}  // namespace parti::app
