#include "tests/support/wayland.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::tests {
namespace {

using std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(20);  // a busy machine
constexpr int kBeside_px = 40;  ///< of the screen, right of and below the desktop
constexpr const char* kSocket = "wayland-parti";

/// What Weston's log says of Xwayland: ":7"; "" nothing yet.
std::string ServerIn(const std::string& log) {
  constexpr std::string_view kSays = "xserver listening on display ";
  const size_t at = log.find(kSays);
  if (at == std::string::npos) return "";
  const size_t from = at + kSays.size(), end = log.find('\n', from);
  return end == std::string::npos ? "" : log.substr(from, end - from);
}

}  // namespace

std::unique_ptr<WaylandDesktop> WaylandDesktop::Start(const glm::ivec2& size_px, std::string* why) {
  auto screen = Xvfb::Start(size_px + glm::ivec2(kBeside_px), why);
  if (!screen) return nullptr;
  // A pointer that is over Weston's window before it is there does not always enter it.
  const glm::ivec2 beside = size_px + glm::ivec2(kBeside_px / 2);
  screen->Do({"mousemove", std::to_string(beside.x), std::to_string(beside.y)});
  std::unique_ptr<WaylandDesktop> desktop(new WaylandDesktop(TestFolder(), std::move(screen)));
  if (!std::filesystem::exists("/usr/bin/Xwayland") || !desktop->Begin(size_px)) {
    *why = "Weston or Xwayland is missing or does not start: install weston and xwayland";
    return nullptr;
  }
  return desktop;
}

bool WaylandDesktop::Begin(const glm::ivec2& size_px) {
  const std::string log = folder_ + "/weston.log";
  weston_ = std::make_unique<Child>(
      std::vector<std::string>{
          "env", "DISPLAY=" + screen_->name(), "XDG_RUNTIME_DIR=" + folder_, "weston",
          "--backend=x11-backend.so", "--use-pixman", "--shell=kiosk-shell.so", "--xwayland",
          "--no-config", "--idle-time=0", fmt::format("--socket={}", kSocket),
          fmt::format("--width={}", size_px.x), fmt::format("--height={}", size_px.y)},
      log, folder_ + "/weston.err");
  for (const auto end = steady_clock::now() + kPatience; steady_clock::now() < end;) {
    server_ = ServerIn(ReadFile(log).value_or("") + ReadFile(folder_ + "/weston.err").value_or(""));
    if (!server_.empty()) return true;
    if (weston_->Ended()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

WaylandDesktop::~WaylandDesktop() {
  weston_.reset();
  screen_.reset();
  if (!server_.empty()) RemoveTracesOf(server_);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::vector<std::string> WaylandDesktop::environment() const {
  return {"DISPLAY=" + server_, std::string("WAYLAND_DISPLAY=") + kSocket,
          "XDG_RUNTIME_DIR=" + folder_};
}

}  // namespace parti::tests
