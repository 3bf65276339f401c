#include "render/x11_connection.h"

#include <X11/Xlib.h>
#include <fmt/format.h>

#include <cstdlib>

namespace parti::render {
namespace {

int DropError(Display*, XErrorEvent*) { return 0; }
int StaySilent(Display*) { return 0; }
void NoteLoss(Display*, void* lost) { *static_cast<bool*>(lost) = true; }

}  // namespace

Result<std::shared_ptr<X11Connection>> X11Connection::Open(const std::string& name) {
  const char* variable = std::getenv("DISPLAY");
  const std::string wanted = !name.empty() ? name : variable ? variable : "";
  if (wanted.empty()) {
    return Fail(ErrorCode::kDevice, "no X server is named: DISPLAY is not set",
                "start it from a desktop's terminal; on a bare console use `--display kms`");
  }
  // The handlers are the process's, so they are set each time.
  XSetErrorHandler(DropError);
  XSetIOErrorHandler(StaySilent);
  Display* display = XOpenDisplay(wanted.c_str());
  if (!display) {
    return Fail(ErrorCode::kDevice,
                fmt::format("the X server {} does not answer, or refuses", wanted),
                "check DISPLAY and XAUTHORITY; over ssh use `ssh -X`, as another user `xhost "
                "+si:localuser:$USER`");
  }
  return std::shared_ptr<X11Connection>(new X11Connection(display, wanted));
}

X11Connection::X11Connection(XDisplay* display, std::string name)
    : display_(display), name_(std::move(name)) {
  XSetIOErrorExitHandler(display_, NoteLoss, &lost_);
}

X11Connection::~X11Connection() { XCloseDisplay(display_); }

Error X11Connection::WhyLost() const {
  return {ErrorCode::kDevice, fmt::format("the X server {} is gone", name_),
          "what was drawn is kept; start the program again once the desktop is back", std::nullopt};
}

}  // namespace parti::render
