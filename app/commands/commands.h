// The command line: one file per command, all registered here.
// A command reads its options, calls one function and prints what it gives; the work is elsewhere.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <string_view>

#include "base/error.h"

namespace parti::app {

inline constexpr int kDone = 0, kFailed = 1, kWrongUsage = 2;

/// What main runs after parsing; the chosen command sets it. Returns an exit status.
using Run = std::function<int()>;

/// Prints an error to standard error in the house's form; returns kFailed.
int Report(const Error& error);

/// Prints a line to standard error; one that can't be written is nobody's loss.
void Say(const std::string& line);

/// Prints an answer to standard output, whole and at once. Returns kDone; kFailed, reported, where
/// it can't be written.
int PrintAnswer(std::string_view text);

/// What runs where no command is named: the application.
void AddOpenCommand(CLI::App& app, Run* run);
/// Each adds its command to the command line; when it is chosen, *run is set.
void AddSegmentCommand(CLI::App& app, Run* run);
void AddSuggestCommand(CLI::App& app, Run* run);
void AddDevicesCommand(CLI::App& app, Run* run);
void AddRecordCommand(CLI::App& app, Run* run);
void AddReplayCommand(CLI::App& app, Run* run);
void AddReportCommand(CLI::App& app, Run* run);
void AddQueryCommand(CLI::App& app, Run* run);
void AddCheckCommand(CLI::App& app, Run* run);
void AddRenderCommand(CLI::App& app, Run* run);
void AddExportCommand(CLI::App& app, Run* run);
void AddDeriveCommand(CLI::App& app, Run* run);

}  // namespace parti::app
