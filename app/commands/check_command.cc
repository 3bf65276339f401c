// `parti check RULES`: everything that is wrong with a rule file; nothing is derived.
#include <fmt/format.h>

#include <memory>

#include "app/commands/commands.h"
#include "app/open_model.h"
#include "app/rule_import.h"
#include "base/note.h"
#include "base/text_file.h"
#include "grammar/rules/rule_remarks.h"
#include "grammar/rules/rule_text.h"

namespace parti::app {
namespace {

struct CheckOptions {
  std::string file;
  std::string style;
  std::string start;
  bool skip_unknown = false;
};

/// "3 rules"
std::string Counted(size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

int RunCheck(const CheckOptions& options) {
  const auto text = ReadFile(options.file);
  if (!text) return Report(text.error());
  const auto rules = grammar::ParseRules(
      *text, options.file, {FileImporter(), options.style, options.skip_unknown, options.start});
  if (!rules) return ReportAll(rules.error());
  ReportSkipped(*rules);
  if (rules->rules.empty() && rules->trees.empty()) {
    return Report({ErrorCode::kNothingMade,
                   fmt::format("'{}' has neither rules nor trees", options.file),
                   "write Lot --> extrude(12) Mass"});
  }
  for (const Error& remark : grammar::RemarksOn(*rules)) {
    Say(FormatNote(remark));
  }
  return PrintAnswer(fmt::format(
      "{}: {}, {}, {}\n", options.file, Counted(rules->rules.size(), "rule"),
      Counted(rules->attributes.size(), "attribute"), Counted(rules->trees.size(), "tree")));
}

}  // namespace

void AddCheckCommand(CLI::App& app, Run* run) {
  CLI::App* command = app.add_subcommand("check", "Tells everything that is wrong with rules");
  const auto options = std::make_shared<CheckOptions>();
  command->add_option("RULES", options->file, "a .cga text; - reads standard input")->required();
  command->add_option("--style", options->style, "the style that is asked for");
  command->add_option("--start", options->start, "a symbol that must have a rule");
  command->add_flag("--skip-unknown", options->skip_unknown,
                    "leave out operations and annotations that are not known");
  command->footer("Example:\n  parti check house.cga");
  command->callback([options, run] { *run = [options] { return RunCheck(*options); }; });
}

}  // namespace parti::app
