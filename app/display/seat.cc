#include "app/display/seat.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace parti::app {

Result<std::unique_ptr<Seat>> OpenSeat() {
  auto managed = OpenLibseatSeat();
  if (managed) return managed;
  auto direct = OpenDirectSeat();
  if (direct) return direct;
  return Fail(ErrorCode::kDevice, managed.error().message + "; " + direct.error().message,
              direct.error().hint.empty() ? managed.error().hint : direct.error().hint);
}

Error CannotOpenScreen(const std::string& path, int reason) {
  Error error{ErrorCode::kDevice,
              fmt::format("can't open the screen {}: {}", path, std::strerror(reason)),
              {},
              std::nullopt};
  if (reason == EACCES || reason == EPERM) {
    error.hint =
        "log in on a console of this machine (not over ssh), or `sudo usermod -aG video $USER` "
        "and log in again";
  } else if (reason == EBUSY) {
    error.message = fmt::format("another program drives the screen {}", path);
    error.hint =
        "a desktop or another Parti is running: start this one within it with `--display x11`, or "
        "end it first";
  } else if (reason == ENOENT || reason == ENODEV || reason == ENXIO) {
    error.hint = "`ls /dev/dri` shows the screens that the kernel knows";
  }
  return error;
}

}  // namespace parti::app
