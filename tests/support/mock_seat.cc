#include "tests/support/mock_seat.h"

#include <fmt/format.h>
#include <linux/input-event-codes.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "base/check.h"
#include "base/text_file.h"
#include "input/event_text.h"
#include "tests/support/child.h"

namespace parti::tests {
namespace fs = std::filesystem;
namespace {

constexpr double kPatience_s = 20;

void Write(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  CHECK(out.good(), "the folder of a test can be written");
}

Result<std::vector<SeatLook>> LooksIn(const std::string& output) {
  std::vector<SeatLook> looks(1);
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    if (line == "--") {
      looks.emplace_back();
    } else if (const auto event = input::ReadEvent(line)) {
      looks.back().events.push_back(*event);
    } else {
      looks.back().words.push_back(line);
    }
  }
  looks.pop_back();
  return looks;
}

}  // namespace

MockSeat::MockSeat() {
  std::string name = (fs::temp_directory_path() / "parti-seat-XXXXXX").string();
  CHECK(::mkdtemp(name.data()) != nullptr, "tests can make folders");
  folder_ = name;
  fs::create_directory(folder_ / "udev");
  Do("ahead 1000");  // see mock_tablet.cc: the clock must never come to the events' times
}

MockSeat::~MockSeat() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void MockSeat::Describe(const EvdevRecording& device, const MockPlace& place) {
  const std::string base = (folder_ / fmt::format("event{}", place.number)).string();
  Write(base + ".device", UmockdevDevice(device, place));
  Write(base + ".ioctls", UmockdevIoctls(device, place));
  Write(folder_ / "udev" / UdevDataName(place), UdevData(place));
}

void MockSeat::Send(int number, const std::vector<EvdevEvent>& events) {
  std::vector<EvdevEvent> reports;
  for (const EvdevEvent& event : events) {
    const int64_t last_us = reports.empty() ? event.t_us : reports.back().t_us;
    if (event.t_us != last_us) reports.push_back({last_us, EV_SYN, SYN_REPORT, 0});
    reports.push_back(event);
  }
  reports.push_back({reports.back().t_us, EV_SYN, SYN_REPORT, 0});
  Play(number, reports);
}

void MockSeat::Play(int number, const std::vector<EvdevEvent>& events) {
  for (const EvdevEvent& e : events) {
    Do(fmt::format("send {} {} {} {} {}", number, e.t_us, e.type, e.code, e.value));
  }
}

Result<std::vector<SeatLook>> MockSeat::Run() {
  Write(folder_ / "script", script_);
  const std::string output = (folder_ / "output").string();
  const std::string errors = (folder_ / "errors").string();
  Child child({"env", "MOCK_FOLDER=" + folder_.string(), "XKB_DEFAULT_LAYOUT=" + layout_,
               "ASAN_OPTIONS=verify_asan_link_order=0",
               fmt::format("LD_PRELOAD={}:libumockdev-preload.so.0", PARTI_MOCK_NODE),
               PARTI_MOCK_SEAT, folder_.string(), (folder_ / "script").string()},
              output, errors);
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(kPatience_s);
  while (Clock::now() < deadline) {
    const auto status = child.Ended();
    if (status == 0) return LooksIn(ReadFile(output).value_or(""));
    if (status) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return Fail(ErrorCode::kDevice,
              fmt::format("the mocked seat failed: {}", ReadFile(errors).value_or("")));
}

EvdevEvent Raw(double t_ms, int type, int code, int value) {
  return {std::llround(t_ms * 1e3), static_cast<uint16_t>(type), static_cast<uint16_t>(code),
          value};
}

EvdevRecording TouchScreen(Vec2 size_mm) {
  constexpr int kUnitsPerMm = 40, kFingers = 10;
  EvdevRecording screen;
  screen.name = "Mocked Touch Screen";
  screen.vendor = 0x1234;
  screen.product = 0x0002;
  screen.properties = {1 << INPUT_PROP_DIRECT};
  screen.codes[EV_SYN] = {};
  screen.SetCode(EV_KEY, BTN_TOUCH);
  const int width = static_cast<int>(size_mm.x * kUnitsPerMm);
  const int height = static_cast<int>(size_mm.y * kUnitsPerMm);
  for (const int code : {ABS_X, ABS_MT_POSITION_X}) {
    screen.axes[code] = {.maximum = width, .resolution = kUnitsPerMm};
  }
  for (const int code : {ABS_Y, ABS_MT_POSITION_Y}) {
    screen.axes[code] = {.maximum = height, .resolution = kUnitsPerMm};
  }
  screen.axes[ABS_MT_SLOT] = {.maximum = kFingers - 1};
  screen.axes[ABS_MT_TRACKING_ID] = {.maximum = 65535};
  for (const auto& [code, axis] : screen.axes) screen.SetCode(EV_ABS, code);
  return screen;
}

EvdevRecording Mouse() {
  EvdevRecording mouse;
  mouse.name = "Mocked Mouse";
  mouse.vendor = 0x1234;
  mouse.product = 0x0003;
  mouse.codes[EV_SYN] = {};
  for (const int code : {REL_X, REL_Y, REL_WHEEL, REL_HWHEEL}) mouse.SetCode(EV_REL, code);
  for (const int code : {BTN_LEFT, BTN_RIGHT, BTN_MIDDLE}) mouse.SetCode(EV_KEY, code);
  return mouse;
}

EvdevRecording KeyboardDevice() {
  EvdevRecording keyboard;
  keyboard.name = "Mocked Keyboard";
  keyboard.vendor = 0x1234;
  keyboard.product = 0x0004;
  keyboard.codes[EV_SYN] = {};
  for (int code = KEY_ESC; code <= KEY_KPDOT; ++code) keyboard.SetCode(EV_KEY, code);
  return keyboard;
}

EvdevRecording KeysOnly(const std::string& name, const std::vector<int>& keys) {
  EvdevRecording device;
  device.name = name;
  device.vendor = 0x1234;
  device.product = 0x0005;
  device.codes[EV_SYN] = {};
  for (const int code : keys) device.SetCode(EV_KEY, code);
  return device;
}

}  // namespace parti::tests
