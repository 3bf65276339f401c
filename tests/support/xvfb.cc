#include "tests/support/xvfb.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include "base/check.h"
#include "tests/support/program.h"

namespace parti::tests {
namespace {

constexpr int kPatience_ms = 20'000;  ///< a busy machine

Display* Of(void* display) { return static_cast<Display*>(display); }

bool Await(const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(kPatience_ms);
  while (!done()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

bool HasClass(Display* display, Window window, const std::string& of_class) {
  XClassHint hint{};
  if (!XGetClassHint(display, window, &hint)) return false;
  const bool has = of_class == hint.res_class;
  XFree(hint.res_name);
  XFree(hint.res_class);
  return has;
}

/// 0: none of the window's children and theirs has the class.
Window FindBelow(Display* display, Window parent, const std::string& of_class) {
  Window root = 0, above = 0, *children = nullptr, found = 0;
  unsigned count = 0;
  if (!XQueryTree(display, parent, &root, &above, &children, &count)) return 0;
  for (unsigned i = 0; i < count && found == 0; ++i) {
    found = HasClass(display, children[i], of_class) ? children[i]
                                                     : FindBelow(display, children[i], of_class);
  }
  if (children) XFree(children);
  return found;
}

/// The number that the server writes once it listens.
std::string ReadNumber(int fd) {
  std::string text;
  pollfd waiting{fd, POLLIN, 0};
  while (::poll(&waiting, 1, kPatience_ms) > 0) {
    char c = 0;
    if (::read(fd, &c, 1) != 1) return "";
    if (c == '\n') return text;
    text += c;
  }
  return "";
}

}  // namespace

std::unique_ptr<Xvfb> Xvfb::Start(const glm::ivec2& size_px, std::string* why) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) {
    *why = "no pipe";
    return nullptr;
  }
  const std::string folder = TestFolder();
  auto server = std::make_unique<Child>(
      std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                               fmt::format("{}x{}x24", size_px.x, size_px.y), "-nolisten", "tcp",
                               "-noreset"},
      folder + "/out", folder + "/err");
  ::close(ends[1]);
  const std::string number = ReadNumber(ends[0]);
  ::close(ends[0]);
  if (number.empty()) {
    *why = "Xvfb is missing or does not start: install the package xvfb";
    std::filesystem::remove_all(folder);
    return nullptr;
  }
  return std::unique_ptr<Xvfb>(new Xvfb(folder, std::move(server), ":" + number));
}

Xvfb::Xvfb(std::string folder, std::unique_ptr<Child> server, std::string name)
    : folder_(std::move(folder)), server_(std::move(server)), name_(std::move(name)) {}

Xvfb::~Xvfb() {
  server_.reset();
  RemoveTracesOf(name_);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

void RemoveTracesOf(const std::string& server) {
  const std::string number = server.substr(1);
  const auto temporary = std::filesystem::path("/") / "tmp";
  std::error_code ignored;
  std::filesystem::remove(temporary / (".X" + number + "-lock"), ignored);
  std::filesystem::remove(temporary / ".X11-unix" / ("X" + number), ignored);
}

bool Xvfb::Run(const std::string& program, const std::vector<std::string>& words) const {
  std::vector<std::string> command = {"env", "DISPLAY=" + name_, program};
  command.insert(command.end(), words.begin(), words.end());
  Child child(command, folder_ + "/" + program + ".out", folder_ + "/" + program + ".err");
  std::optional<int> status;
  Await([&] { return (status = child.Ended()).has_value(); });
  return status == 0;
}

bool Xvfb::Do(const std::vector<std::string>& words) const { return Run("xdotool", words); }

bool Xvfb::SetLayout(const std::string& layout) const { return Run("setxkbmap", {layout}); }

XSpectator::XSpectator(const std::string& server) {
  // Windows vanish while they are looked at.
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  display_ = XOpenDisplay(server.c_str());
  CHECK(display_ != nullptr, "the test's own server takes a second client");
}

XSpectator::~XSpectator() { XCloseDisplay(Of(display_)); }

unsigned long XSpectator::root() const { return DefaultRootWindow(Of(display_)); }

unsigned long XSpectator::Find(const std::string& of_class) {
  Window found = 0;
  Await([&] { return (found = FindBelow(Of(display_), root(), of_class)) != 0; });
  return found;
}

render::Image XSpectator::Picture(unsigned long window) {
  XWindowAttributes attributes{};
  XSync(Of(display_), False);
  XGetWindowAttributes(Of(display_), window, &attributes);
  if (attributes.map_state != IsViewable) return {};
  const auto width = static_cast<unsigned>(attributes.width);
  const auto height = static_cast<unsigned>(attributes.height);
  XImage* image = XGetImage(Of(display_), window, 0, 0, width, height, AllPlanes, ZPixmap);
  if (!image) return {};
  render::Image picture{attributes.width, attributes.height, {}};
  picture.pixels.reserve(size_t{4} * width * height);
  for (int y = 0; y < attributes.height; ++y) {
    for (int x = 0; x < attributes.width; ++x) {
      const unsigned long p = XGetPixel(image, x, y);
      for (const int shift : {16, 8, 0}) {
        picture.pixels.push_back(static_cast<uint8_t>(p >> shift & 0xff));
      }
      picture.pixels.push_back(255);
    }
  }
  XDestroyImage(image);
  return picture;
}

std::string XSpectator::Text(unsigned long window, const std::string& property) {
  Atom type = None;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  XGetWindowProperty(Of(display_), window, XInternAtom(Of(display_), property.c_str(), False), 0,
                     1 << 16, False, AnyPropertyType, &type, &format, &count, &left, &data);
  std::string text = data && format == 8 ? std::string(reinterpret_cast<char*>(data), count) : "";
  if (data) XFree(data);
  return text;
}

std::vector<unsigned long> XSpectator::Cardinals(unsigned long window,
                                                 const std::string& property) {
  Atom type = None;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  XGetWindowProperty(Of(display_), window, XInternAtom(Of(display_), property.c_str(), False), 0,
                     1 << 20, False, AnyPropertyType, &type, &format, &count, &left, &data);
  std::vector<unsigned long> values;
  if (data && format == 32) {
    const auto* longs = reinterpret_cast<const unsigned long*>(data);
    values.assign(longs, longs + count);
  }
  if (data) XFree(data);
  return values;
}

void XSpectator::SetRootText(const std::string& property, const std::string& text) {
  XChangeProperty(Of(display_), DefaultRootWindow(Of(display_)),
                  XInternAtom(Of(display_), property.c_str(), False), XA_STRING, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(text.data()),
                  static_cast<int>(text.size()));
  XSync(Of(display_), False);
}

glm::ivec2 XSpectator::Pointer() const {
  Window root_of = 0, child = 0;
  glm::ivec2 at{0, 0}, in_window{0, 0};
  unsigned mask = 0;
  XQueryPointer(Of(display_), root(), &root_of, &child, &at.x, &at.y, &in_window.x, &in_window.y,
                &mask);
  return at;
}

void XSpectator::Resize(unsigned long window, const glm::ivec2& size_px) {
  XResizeWindow(Of(display_), window, static_cast<unsigned>(size_px.x),
                static_cast<unsigned>(size_px.y));
  XSync(Of(display_), False);
}

void XSpectator::SetShown(unsigned long window, bool shown) {
  shown ? XMapWindow(Of(display_), window) : XUnmapWindow(Of(display_), window);
  XSync(Of(display_), False);
}

void XSpectator::AskToClose(unsigned long window) {
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(Of(display_), "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(Of(display_), "WM_DELETE_WINDOW", False));
  XSendEvent(Of(display_), window, False, NoEventMask, &event);
  XSync(Of(display_), False);
}

void XSpectator::Focus(std::optional<unsigned long> window) {
  XSetInputFocus(Of(display_), window.value_or(DefaultRootWindow(Of(display_))),
                 RevertToPointerRoot, CurrentTime);
  XSync(Of(display_), False);
}

}  // namespace parti::tests
