// `parti [FILE]`: the application, on the best display there is.
#include <fmt/format.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "app/acknowledgement_log.h"
#include "app/application.h"
#include "app/command_pipe.h"
#include "app/commands/commands.h"
#include "app/display/open_display.h"
#include "app/file_ending.h"
#include "app/play.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

/// For what is not executed yet when the end is asked for; what takes longer is done when the
/// document is opened again.
constexpr std::chrono::seconds kPatience{2};

struct Options {
  std::string file;
  std::string display = "best";
  std::string lot;           // for a document without one
  std::string commands;      // FIFO
  std::string acknowledged;  // file
  std::string play;          // drawing
  std::string screenshot;    // PNG
};

/// SIGINT, SIGTERM and SIGHUP as something to poll: the program ends as if its window were closed.
/// Threads that are started while it lives leave these signals to it.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    fd_ = signalfd(-1, &signals_, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  ~EndSignals() { close(fd_); }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  int fd() const { return fd_; }
  bool came() const {
    signalfd_siginfo info;
    return read(fd_, &info, sizeof info) == sizeof info;
  }

 private:
  sigset_t signals_;
  int fd_;
};

/// Plays what is sound of a drawing, then says what is not.
Result<void> PlayFile(const std::string& path, Application* application) {
  const auto text = ReadFile(path);
  if (!text) return Fail(text);
  const input::DrawingReading reading = input::ReadDrawing(*text, path);
  if (auto played = Play(reading.drawing, application); !played) return played;
  if (reading.damage) return tl::unexpected<Error>(*reading.damage);
  return {};
}

Result<void> TakeScreenshot(Application* application, const std::string& path) {
  if (auto settled = Settle(application); !settled) return settled;
  if (application->close_asked()) {
    return Fail(ErrorCode::kNothingMade,
                fmt::format("ended before there was anything for {}", path));
  }
  const auto image = application->Screenshot();
  if (!image) return Fail(image);
  return render::WritePng(*image, path);
}

/// Until the display is closed or a signal comes.
Result<void> Loop(Application* application, CommandPipe* pipe) {
  std::vector<int> also;
  if (pipe) also.emplace_back(pipe->fd());
  constexpr double kLong_s = 60;
  while (!application->close_asked()) {
    if (auto turned = application->Turn(kLong_s, also); !turned) {
      application->PutDown();  // the display is gone: what the pen has drawn so far counts
      return turned;
    }
    if (!pipe) continue;
    for (const auto& command : pipe->Read()) {
      if (command) {
        application->Do(PanelCommand(*command));
      } else {
        Report(command.error());
      }
    }
  }
  application->PutDown();
  return {};
}

/// The file or FIFO of an option, opened; nothing where the option is not given.
template <typename T>
Result<std::optional<T>> Opened(const std::string& path) {
  if (path.empty()) return std::nullopt;
  auto opened = T::Open(path);
  if (!opened) return Fail(opened);
  return std::optional<T>(std::move(*opened));
}

ApplicationOptions UsersOptions(const Display& display) {
  ApplicationOptions with;
  if (display.name() == "offscreen") with.stepping_aside.fade_s = 0;  // nobody sees it
  with.settings_path = SettingsPath();
  with.folders = UserFoldersFromEnvironment();
  auto settings = ReadSettings(with.settings_path);
  if (settings) {
    with.settings = *settings;
  } else {
    Report(settings.error());  // and goes on with those of a new user
  }
  return with;
}

/// A name that can't be a file's, such as one that is too long, is not there.
bool IsThere(const std::string& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// A file that is not there yet is begun, if its name is a document's. A bare word is taken for a
/// misspelt command. The exit status; kDone where all is well.
int CheckFile(const std::string& file, const std::vector<std::string>& commands) {
  if (file.empty() || IsThere(file) || file.ends_with(kDocumentEnding)) return kDone;
  Error error{ErrorCode::kFile, fmt::format("there is no file '{}'", file),
              "documents end in .parti; parti --help lists the commands"};
  if (file.find_first_of("./") != std::string::npos) return Report(error);
  error.code = ErrorCode::kUnknownName;
  error.message = fmt::format("there is no command and no file '{}'", file);
  if (const auto meant = DidYouMean(file, commands)) error.hint = "did you mean '" + *meant + "'?";
  Report(error);
  return kWrongUsage;
}

/// Whether nobody may be there to read what panels say.
bool IsUnattended(const Options& options) {
  return !options.play.empty() || !options.screenshot.empty();
}

/// Opens the file, or begins it. Who has nobody to tell does not go on without it.
Result<void> BeginFile(const Options& options, Application* application) {
  if (options.file.empty()) return {};
  const bool is_there = IsThere(options.file);
  if (is_there && !IsUnattended(options)) return {};  // OpeningReport says what goes wrong
  if (!is_there) {
    application->Do(PanelCommand(DocumentRequest{DocumentRequest::Kind::kSaveAs, options.file}));
  }
  if (auto settled = Settle(application); !settled) return settled;
  const SessionSnapshot& now = application->snapshot();
  const bool is_open = is_there ? !now.document.path.empty() : now.document.named;
  if (!now.last_error) return {};
  if (IsUnattended(options) && !is_open) return tl::unexpected<Error>(now.last_error->error);
  Report(now.last_error->error);
  return {};
}

/// What went wrong while the file was opened, once, for whoever started the program from a
/// terminal.
class OpeningReport {
 public:
  void Tell(const SessionSnapshot& snapshot) {
    if (told_ || !snapshot.last_error || snapshot.last_error->number != 0) return;
    told_ = true;
    Report(snapshot.last_error->error);
  }

 private:
  bool told_ = false;
};

/// The lot for a document that has none.
Result<void> BeginOn(const std::string& lot, Application* application) {
  if (lot.empty()) return {};
  if (const auto readable = ParseLots(lot); !readable) return Fail(readable);
  if (auto settled = Settle(application); !settled || application->close_asked()) return settled;
  if (!application->snapshot().state->model.lots().empty()) return {};
  application->Do(PanelCommand(Command(SetLot{lot})));
  if (auto settled = Settle(application); !settled) return settled;
  application->Do(PanelCommand(ViewRequest::kFit));
  return {};
}

Result<void> RunApplication(const Options& options, Display* display, SessionThread* session,
                            const EndSignals& signals) {
  auto log = Opened<AcknowledgementLog>(options.acknowledged);
  if (!log) return Fail(log);
  auto pipe = Opened<CommandPipe>(options.commands);
  if (!pipe) return Fail(pipe);
  ApplicationOptions with = UsersOptions(*display);
  Result<void> logged;
  with.end_asked = [&signals] { return signals.came(); };
  with.end_fd = signals.fd();
  OpeningReport opening;
  with.on_snapshot = [&](const SessionSnapshot& snapshot) {
    if (!IsUnattended(options)) opening.Tell(snapshot);
    if (*log && logged) logged = (*log)->Note(snapshot);
  };
  auto application = Application::Create(display, session, std::move(with));
  if (!application) return Fail(application);
  if (!IsUnattended(options)) opening.Tell((*application)->snapshot());
  if (auto begun = BeginFile(options, application->get()); !begun) return begun;
  if (auto begun = BeginOn(options.lot, application->get()); !begun) return begun;
  if (!options.play.empty()) {
    if (auto played = PlayFile(options.play, application->get()); !played) return played;
  }
  if (!options.screenshot.empty()) {
    auto taken = TakeScreenshot(application->get(), options.screenshot);
    return taken ? logged : taken;
  }
  if (auto looped = Loop(application->get(), *pipe ? &**pipe : nullptr); !looped) {
    return looped;
  }
  return logged;
}

/// Where it draws and what a new user is to try, for whoever started the program from a terminal.
void Greet(const Display& display, const Options& options) {
  const bool for_hands = options.play.empty() && options.screenshot.empty();
  const char* first = !for_hands || IsThere(options.file) ? ""
                      : options.lot.empty()
                          ? " Draw a closed outline on the ground, then a line up from it."
                          : " Draw a line up from the lot: it becomes a building.";
  Say(fmt::format("parti: {}.{}", display.Description(), first));
}

/// What the command line has besides; kDone where that is nothing but the mark before file names.
int CheckSurplus(const std::vector<std::string>& surplus) {
  const auto first =
      std::find_if(surplus.begin(), surplus.end(), [](const auto& word) { return word != "--"; });
  if (first == surplus.end()) return kDone;
  Report({ErrorCode::kBadArguments, fmt::format("'{}' is not expected here", *first),
          "parti --help shows what is"});
  return kWrongUsage;
}

/// What of the document is not where it belongs, now that the program ends; an exit status.
int ReportUnwritten(const DocumentStatus& document) {
  int status = kDone;
  if (!document.rescued_from.empty()) {
    status = Report({ErrorCode::kFile,
                     fmt::format("{} could not be written: all of it is kept as the draft {}",
                                 document.rescued_from, document.path),
                     "open the draft and save it under a name"});
  }
  if (document.trouble && document.unwritten > 0) {
    status = Report({document.trouble->code,
                     fmt::format("{} strokes and commands are lost: {}", document.unwritten,
                                 document.trouble->message),
                     "start it anew where it can write its documents"});
  }
  return status;
}

int Open(const Options& options, const std::vector<std::string>& commands,
         const std::vector<std::string>& surplus) {
  if (const int status = CheckFile(options.file, commands); status != kDone) return status;
  if (const int status = CheckSurplus(surplus); status != kDone) return status;
  if (const auto fine = CheckEnding(options.screenshot, ".png"); !fine) {
    return Report(fine.error());
  }
  const EndSignals signals;
  const auto kind = DisplayKindOf(options.display);
  if (!kind) return Report(kind.error());
  auto display = OpenDisplay(*kind);
  if (!display) return Report(display.error());
  Greet(**display, options);
  SessionThreadOptions with;
  if (IsThere(options.file)) with.path = options.file;
  SessionThread session(with);
  const auto ran = RunApplication(options, display->get(), &session, signals);
  const bool stopped = session.StopWithin(kPatience);
  display->reset();
  const auto last = session.Newest();
  const int kept = ReportUnwritten(last->document);
  const int status = ran ? kept : Report(ran.error());
  if (stopped) return status;
  std::fflush(nullptr);
  std::_Exit(status);  // a derivation goes on that nobody waits for; its request is kept
}

}  // namespace

void AddOpenCommand(CLI::App& app, Run* run) {
  auto options = std::make_shared<Options>();
  app.footer(
      "Examples:\n  parti house.parti\n  parti replay assets/drawings/house.pen --png a.png");
  app.add_option("FILE", options->file, "a document; a new one where there is none");
  app.add_option("--display", options->display, "x11, kms, offscreen, or best: what there is");
  app.add_option("--lot", options->lot, "the LOT to begin on, where the document has none");
  app.add_option("--play", options->play, "a drawing to play as if its tablet were there");
  app.add_option("--screenshot", options->screenshot,
                 "a PNG of the application once all is done; then it ends");
  app.add_option("--commands", options->commands,
                 "a FIFO whose lines are commands (tests, scripts)");
  app.add_option("--acknowledged", options->acknowledged,
                 "a file that gets a line for each command that is safe on the disk");
  *run = [=, &app] {
    std::vector<std::string> commands;
    for (const CLI::App* command : app.get_subcommands({}))
      commands.emplace_back(command->get_name());
    return Open(*options, commands, app.remaining());
  };
}

}  // namespace parti::app
