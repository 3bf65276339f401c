// Runs the parti program as a person would, for tests of its command line.
#pragma once

#include <string>
#include <vector>

namespace parti::tests {

struct ProgramRun {
  int status = 0;      ///< exit status; 128 + the signal that ended it
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `parti ARGUMENTS…` with `input` on its standard input, in the folder of the caller. Where
/// `output_to` is given, standard output goes there and `output` is empty.
ProgramRun RunParti(const std::vector<std::string>& arguments, const std::string& input = "",
                    const std::string& output_to = "");

/// A new empty folder for one test, below the test's temporary folder.
std::string TestFolder();

}  // namespace parti::tests
