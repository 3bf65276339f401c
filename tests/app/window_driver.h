// The program in a window of a desktop under test, with a mouse and keys that xdotool moves: what
// was drawn is read from its document, and what is safe from --acknowledged.
// Which desktop it is, is each test's.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/document.h"
#include "tests/support/xvfb.h"

namespace parti::tests {

/// A fixture. The document begins with a lot of 20 by 14 m.
class WindowDriver : public testing::Test {
 protected:
  /// Before its desktop ends: what looks at a server can't outlive it.
  void TearDown() override;

  /// Starts the program with these variables and arguments and waits for its window on `server`,
  /// and until it has come to rest. Mouse and keys are those of `hands`, which must outlive it.
  void Open(const std::string& server, const Xvfb* hands,
            const std::vector<std::string>& environment, const std::string& display);

  /// Until nothing has been written for a while: the lot is there, and the view has come to rest.
  void Rest() const;
  /// Whether it came to be within a minute: on a busy machine.
  static bool Until(const std::function<bool()>& done);

  std::string File() const { return folder_ + "/house.parti"; }
  std::string Errors() const;  ///< what the program had to say
  /// The number of the last request that is safe.
  int Safe() const;
  bool WaitForSafe(int number);

  /// A line with the left button, not let go.
  void Press(const Vec2& from, const Vec2& to);
  void Release();

  /// Closes the window as its cross does, and reads what is left.
  app::Document Closed();

  std::string folder_;
  std::unique_ptr<Child> program_;
  std::unique_ptr<XSpectator> look_;
  unsigned long window_ = 0;
  int at_start_ = 0;  ///< requests that the program made of itself
  const Xvfb* hands_ = nullptr;
};

}  // namespace parti::tests
