// A program started by a test that goes on meanwhile: watched, interrupted, never left behind.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace parti::tests {

/// A child in a process group of its own, with nothing to read; killed with all that it started
/// when the value goes, and by the kernel when the thread goes that started it.
class Child {
 public:
  /// `words` are the program, looked for in PATH, and its arguments; what it writes goes to two
  /// files.
  Child(const std::vector<std::string>& words, const std::string& output,
        const std::string& errors);
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// The exit status once it has ended: 128 + the signal that ended it; 127 if it can't be run.
  std::optional<int> Ended();
  /// A signal, to the program alone.
  void Send(int signal) const;

 private:
  pid_t pid_ = -1;
  std::optional<int> status_;
};

}  // namespace parti::tests
