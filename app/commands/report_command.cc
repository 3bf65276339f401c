// `parti report FILE.parti OUT.pen`: a document's whole session as a drawing, for a bug report.
#include <memory>

#include "app/commands/commands.h"
#include "app/document_report.h"
#include "app/file_ending.h"

namespace parti::app {
namespace {

struct Options {
  std::string document, out;
};

int Record(const Options& options) {
  if (const auto fine = CheckEnding(options.out, ".pen"); !fine) return Report(fine.error());
  const auto document = OpenDocument(options.document);
  if (!document) return Report(document.error());
  const auto written = WriteReport(*document, options.out);
  return written ? kDone : Report(written.error());
}

}  // namespace

void AddReportCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("report", "Write everything that was done in a document as a drawing");
  command->footer("Example: parti report house.parti house.pen");
  command->add_option("FILE", options->document, "a .parti document")->required();
  command->add_option("OUT", options->out, "the drawing to write (.pen)")->required();
  command->callback([options, run] { *run = [options] { return Record(*options); }; });
}

}  // namespace parti::app
