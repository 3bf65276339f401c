#include "render/x11_window.h"

#include <EGL/eglext.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <glm/common.hpp>
#include <vector>

#include "render/window_icon.h"

namespace parti::render {
namespace {

constexpr glm::ivec2 kLeast_px{320, 240};  ///< below it panels don't fit
constexpr double kMostOfScreen = 0.9;      ///< leaves room for a desktop's bars

Atom AtomOf(Display* display, const char* name) { return XInternAtom(display, name, False); }

std::string ResourcesOf(Display* display) {
  Atom type = None;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  XGetWindowProperty(display, DefaultRootWindow(display), XA_RESOURCE_MANAGER, 0, 1 << 20, False,
                     XA_STRING, &type, &format, &count, &left, &data);
  std::string text = data && format == 8 ? std::string(reinterpret_cast<char*>(data), count) : "";
  if (data) XFree(data);
  return text;
}

void SetText(Display* display, Window window, const char* property, const std::string& text) {
  XChangeProperty(display, window, AtomOf(display, property), AtomOf(display, "UTF8_STRING"), 8,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(text.data()),
                  static_cast<int>(text.size()));
}

/// 32-bit properties travel as longs, whatever their size.
void SetIcon(Display* display, Window window) {
  std::vector<unsigned long> cardinals;
  for (const int side : {16, 32, 48, 128}) {
    const Image icon = WindowIcon(side);
    cardinals.insert(cardinals.end(), 2, static_cast<unsigned long>(side));
    for (size_t i = 0; i < icon.pixels.size(); i += 4) {
      const uint8_t* p = &icon.pixels[i];
      cardinals.push_back(uint32_t{p[3]} << 24 | uint32_t{p[0]} << 16 | uint32_t{p[1]} << 8 |
                          uint32_t{p[2]});
    }
  }
  XChangeProperty(display, window, AtomOf(display, "_NET_WM_ICON"), XA_CARDINAL, 32,
                  PropModeReplace, reinterpret_cast<const unsigned char*>(cardinals.data()),
                  static_cast<int>(cardinals.size()));
}

}  // namespace

double ScaleIn(const std::string& resources) {
  constexpr std::string_view kKey = "Xft.dpi:";
  size_t at = 0;
  while (at < resources.size()) {
    const size_t end = std::min(resources.find('\n', at), resources.size());
    if (resources.compare(at, kKey.size(), kKey) == 0) {
      const double dpi = std::strtod(resources.c_str() + at + kKey.size(), nullptr);
      if (dpi > 0 && dpi < 1e4) return std::clamp(dpi / 96, 0.5, 4.0);
    }
    at = end + 1;
  }
  return 1;
}

Result<std::unique_ptr<X11Window>> X11Window::Create(std::shared_ptr<X11Connection> connection,
                                                     const glm::ivec2& size,
                                                     const std::string& title) {
  Display* display = connection->get();
  const int screen = DefaultScreen(display);
  const glm::ivec2 most(DisplayWidth(display, screen) * kMostOfScreen,
                        DisplayHeight(display, screen) * kMostOfScreen);
  const glm::ivec2 wanted_px(glm::dvec2(size) * ScaleIn(ResourcesOf(display)));
  const glm::ivec2 size_px = glm::max(glm::min(wanted_px, most), glm::ivec2(1));
  Visual* visual = DefaultVisual(display, screen);
  auto context = EglWindow::Create(
      {EGL_PLATFORM_X11_EXT, std::shared_ptr<void>(connection, display),
       static_cast<EGLint>(XVisualIDFromVisual(visual)), "the X server " + connection->name()});
  if (!context) return Fail(context);
  XSetWindowAttributes attributes{};
  attributes.background_pixmap = None;  // no flash of another colour before the first frame
  attributes.bit_gravity = NorthWestGravity;
  attributes.event_mask =
      StructureNotifyMask | ExposureMask | FocusChangeMask | VisibilityChangeMask;
  const Window id =
      XCreateWindow(display, DefaultRootWindow(display), 0, 0, static_cast<unsigned>(size_px.x),
                    static_cast<unsigned>(size_px.y), 0, DefaultDepth(display, screen), InputOutput,
                    visual, CWBackPixmap | CWBitGravity | CWEventMask, &attributes);
  std::unique_ptr<X11Window> window(
      new X11Window(std::move(connection), std::move(*context), id, size_px));
  window->TellDesktop();
  window->SetTitle(title);
  Window native = id;
  if (const auto set = window->context_->SetWindow(&native); !set) return Fail(set);
  XMapWindow(display, id);
  XFlush(display);
  if (window->connection_->lost()) return tl::unexpected(window->connection_->WhyLost());
  return window;
}

X11Window::X11Window(std::shared_ptr<X11Connection> connection, std::unique_ptr<EglWindow> context,
                     unsigned long id, const glm::ivec2& size_px)
    : connection_(std::move(connection)),
      context_(std::move(context)),
      id_(id),
      size_px_(size_px),
      scale_(ScaleIn(ResourcesOf(connection_->get()))) {
  // Another scale is told by the root window's resources.
  XSelectInput(connection_->get(), DefaultRootWindow(connection_->get()), PropertyChangeMask);
}

X11Window::~X11Window() {
  context_.reset();
  XDestroyWindow(connection_->get(), id_);
  XFlush(connection_->get());
}

void X11Window::TellDesktop() {
  Display* display = connection_->get();
  std::array<Atom, 2> protocols = {AtomOf(display, "WM_DELETE_WINDOW"),
                                   AtomOf(display, "_NET_WM_PING")};
  XSetWMProtocols(display, id_, protocols.data(), static_cast<int>(protocols.size()));
  const std::unique_ptr<XSizeHints, int (*)(void*)> sizes(XAllocSizeHints(), XFree);
  sizes->flags = PMinSize;
  sizes->min_width = kLeast_px.x;
  sizes->min_height = kLeast_px.y;
  const std::unique_ptr<XWMHints, int (*)(void*)> hints(XAllocWMHints(), XFree);
  hints->flags = InputHint | StateHint;
  hints->input = True;
  hints->initial_state = NormalState;
  std::string instance = "parti", of_class = "Parti";
  XClassHint names{instance.data(), of_class.data()};
  // Also says the machine's name, without which _NET_WM_PID means nothing.
  XSetWMProperties(display, id_, nullptr, nullptr, nullptr, 0, sizes.get(), hints.get(), &names);
  const auto pid = static_cast<unsigned long>(::getpid());
  XChangeProperty(display, id_, AtomOf(display, "_NET_WM_PID"), XA_CARDINAL, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(&pid), 1);
  SetIcon(display, id_);
}

void X11Window::SetTitle(const std::string& title) {
  SetText(connection_->get(), id_, "_NET_WM_NAME", title);
  // For those that know no UTF-8; Xlib turns it into what they read.
  Xutf8SetWMProperties(connection_->get(), id_, title.c_str(), nullptr, nullptr, 0, nullptr,
                       nullptr, nullptr);
}

X11WindowNews X11Window::SetVisible(bool mapped, bool covered) {
  const bool before = visible();
  mapped_ = mapped;
  covered_ = covered;
  X11WindowNews news;
  news.shown = news.exposed = visible() && !before;
  news.hidden = before && !visible();
  return news;
}

/// Whether the window manager asks to close; its question whether we are alive is answered.
bool X11Window::Answer(const _XEvent& message) {
  Display* display = connection_->get();
  if (message.xclient.message_type != AtomOf(display, "WM_PROTOCOLS")) return false;
  const auto protocol = static_cast<Atom>(message.xclient.data.l[0]);
  if (protocol == AtomOf(display, "_NET_WM_PING")) {
    XEvent reply = message;
    reply.xclient.window = DefaultRootWindow(display);
    XSendEvent(display, reply.xclient.window, False,
               SubstructureNotifyMask | SubstructureRedirectMask, &reply);
  }
  return protocol == AtomOf(display, "WM_DELETE_WINDOW");
}

X11WindowNews X11Window::Take(const _XEvent& event) {
  X11WindowNews news;
  if (event.type == PropertyNotify && event.xproperty.atom == XA_RESOURCE_MANAGER) {
    const double scale = ScaleIn(ResourcesOf(connection_->get()));
    news.resized = news.exposed = scale != scale_;
    scale_ = scale;
    return news;
  }
  if (event.xany.window != id_) return news;
  if (event.type == ConfigureNotify) {
    const glm::ivec2 size(event.xconfigure.width, event.xconfigure.height);
    news.resized = news.exposed = size != size_px_;
    size_px_ = glm::max(size, glm::ivec2(1));
  } else if (event.type == MapNotify) {
    return SetVisible(true, covered_);
  } else if (event.type == UnmapNotify) {
    return SetVisible(false, covered_);
  } else if (event.type == VisibilityNotify) {
    return SetVisible(mapped_, event.xvisibility.state == VisibilityFullyObscured);
  } else if (event.type == Expose) {
    news.exposed = true;
  } else if (event.type == FocusOut) {
    news.focus_lost = event.xfocus.detail != NotifyInferior;
  } else if (event.type == ClientMessage) {
    news.close_asked = Answer(event);
  } else if (event.type == DestroyNotify) {
    news.close_asked = true;  // from outside: nothing can be shown any more
    mapped_ = false;
  }
  return news;
}

}  // namespace parti::render
