// A tablet that is not there: plays recorded or drawn pen events through the real libinput, with
// umockdev, without root and without uinput. For any test that wants to know what a drawing becomes
// on its way through a tablet:
//
//   const auto seen = PlayThroughLibinput(*EvdevFromDrawing(drawing));
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "input/drawing.h"
#include "tests/support/evdev_recording.h"

namespace parti::tests {

/// The node under which a program sees the mocked tablet.
inline constexpr const char* kMockNode = "/dev/input/event5";

/// A folder with what umockdev needs; gone with the value.
class MockTablet {
 public:
  explicit MockTablet(const EvdevRecording& recording);
  ~MockTablet();
  MockTablet(const MockTablet&) = delete;
  MockTablet& operator=(const MockTablet&) = delete;

  struct Outcome {
    int status = 0;      ///< the program's exit status
    std::string output;  ///< standard output
    std::string errors;  ///< standard error
  };

  /// What of a program's writing to watch.
  struct Watch {
    std::string file = {};   ///< that it writes; "" for its standard output
    std::string ready = {};  ///< shows that it has opened the tablet: the events play. "": none
    std::string end = {};  ///< shows that it has seen the last: it gets SIGINT. "": it ends itself
  };

  /// Runs a program that sees the tablet. After the recording's last event the pen comes to the
  /// surface's far corner and goes again, so that there is an end to watch for.
  /// errors  kDevice  it did not end within `patience_s` (it is killed then).
  Result<Outcome> Run(const std::vector<std::string>& program, const Watch& watch,
                      double patience_s = 120) const;

  /// How `parti record` writes the far corner that ends a playing.
  std::string EndMark() const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::vector<std::string> CommandFor(const std::vector<std::string>& program) const;
  std::string File(const char* name) const { return (folder_ / name).string(); }

  EvdevRecording recording_;
  std::filesystem::path folder_;
};

/// What `parti record` made of the recording: the events of LibinputSource, their times since the
/// recording's first event. It takes no longer than the program takes to read the events.
/// errors  as MockTablet::Run; kDamagedFile  if what was recorded can't be read.
Result<input::Drawing> PlayThroughLibinput(const EvdevRecording& recording);

}  // namespace parti::tests
