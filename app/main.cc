// The program: parses the command line and runs the chosen command.
#include <fcntl.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <csignal>

#include "app/commands/commands.h"

namespace {

/// A descriptor that somebody closed would be given to a file or the connection to the display, and
/// what is said would be written into it. Opened the wrong way around, each still fails when used.
void KeepStandardDescriptors() {
  for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd) {
    if (::fcntl(fd, F_GETFD) >= 0) continue;
    static_cast<void>(::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace parti::app;
  KeepStandardDescriptors();
  // A write past the limit of a file's size fails, as on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("Parti: draw a building, get the rules", "parti");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", "parti 0.1.0");
  Run run;
  AddOpenCommand(app, &run);
  AddSegmentCommand(app, &run);
  AddSuggestCommand(app, &run);
  AddDevicesCommand(app, &run);
  AddRecordCommand(app, &run);
  AddCheckCommand(app, &run);
  AddQueryCommand(app, &run);
  AddReplayCommand(app, &run);
  AddReportCommand(app, &run);
  AddRenderCommand(app, &run);
  AddExportCommand(app, &run);
  AddDeriveCommand(app, &run);
  // What follows a misspelt command is no reason to complain of that: AddOpenCommand looks at both.
  app.allow_extras();
  app.failure_message([](const CLI::App* program, const CLI::Error& error) {
    const auto chosen = program->get_subcommands();
    const std::string command = chosen.empty() ? "parti" : "parti " + chosen.front()->get_name();
    return parti::FormatError({parti::ErrorCode::kBadArguments, error.what(),
                               command + " --help shows what it takes", std::nullopt}) +
           "\n";
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kWrongUsage;
  }
  return run ? run() : kWrongUsage;
}
