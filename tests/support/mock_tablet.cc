#include "tests/support/mock_tablet.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <climits>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "base/check.h"
#include "base/text_file.h"
#include "tests/support/child.h"
#include "tests/support/umockdev_files.h"

namespace parti::tests {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

// Event times lie this far ahead of the clock. libinput takes a pen that was silent for 50 ms for
// gone, by the clock or by the next event's time, whichever comes first. On a busy machine the
// clock would come first, in the middle of a stroke; it never reaches times that are so far ahead,
// and every playing gives the same.
constexpr int64_t kAhead_us = 1'000'000'000;
constexpr int64_t kLastPause_us = 20'000;
constexpr std::chrono::milliseconds kLook(5);  // between looks at what a program does
// Becomes the program, its process told in a file.
constexpr const char* kRunner = "echo $$ >\"$0/pid\"; exec \"$@\"";

/// Lets every tool leave, then the pen come to the far corner and go.
void AppendEnd(EvdevRecording* recording) {
  auto& events = recording->events;
  const int64_t t_us = (events.empty() ? 0 : events.back().t_us) + kLastPause_us;
  std::set<uint16_t> tools;
  for (const EvdevEvent& event : events) {
    if (event.type != EV_KEY || event.code < BTN_TOOL_PEN || event.code > BTN_TOOL_LENS) continue;
    if (event.value != 0) tools.insert(event.code);
    if (event.value == 0) tools.erase(event.code);
  }
  const auto add = [&](int64_t at_us, int type, int code, int32_t value) {
    events.push_back({at_us, static_cast<uint16_t>(type), static_cast<uint16_t>(code), value});
  };
  for (const uint16_t tool : tools) add(t_us, EV_KEY, tool, 0);
  if (!tools.empty()) add(t_us, EV_SYN, SYN_REPORT, 0);
  add(t_us + kLastPause_us, EV_ABS, ABS_X, recording->axes[ABS_X].maximum);
  add(t_us + kLastPause_us, EV_ABS, ABS_Y, recording->axes[ABS_Y].maximum);
  add(t_us + kLastPause_us, EV_KEY, BTN_TOOL_PEN, 1);
  add(t_us + kLastPause_us, EV_SYN, SYN_REPORT, 0);
  add(t_us + 2 * kLastPause_us, EV_KEY, BTN_TOOL_PEN, 0);
  add(t_us + 2 * kLastPause_us, EV_SYN, SYN_REPORT, 0);
}

/// The recording as the kernel would hand it out, beginning at a time.
std::vector<input_event> KernelEvents(const std::vector<EvdevEvent>& events, int64_t start_us) {
  constexpr int64_t kSecond_us = 1'000'000;
  std::vector<input_event> raw(events.size());
  for (size_t i = 0; i < events.size(); ++i) {
    const int64_t t_us = start_us + events[i].t_us;
    raw[i].input_event_sec = t_us / kSecond_us;
    raw[i].input_event_usec = t_us % kSecond_us;
    raw[i].type = events[i].type;
    raw[i].code = events[i].code;
    raw[i].value = events[i].value;
  }
  return raw;
}

int64_t Now_us() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

void Write(const std::string& path, std::string_view text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  CHECK(out.good(), "the folder of a test can be written");
}

std::string ReadOr(const std::string& path) { return ReadFile(path).value_or(""); }

/// The end of a file that grows, enough of it to find a mark that came since the last look.
std::string TailOf(const std::string& path) {
  constexpr std::streamoff kTail = 1 << 16;
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) return "";
  in.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(in.tellg()) - kTail));
  return std::string(std::istreambuf_iterator<char>(in), {});
}

/// Takes away what AppendEnd brought: everything from the last time the pen came.
void DropEnd(std::vector<InputEvent>* events) {
  const auto came = [](const InputEvent& event) {
    const auto* pen = std::get_if<PenEvent>(&event);
    return pen && pen->kind == PenEvent::Kind::kProximityIn;
  };
  const auto last = std::find_if(events->rbegin(), events->rend(), came);
  CHECK(last != events->rend(), "the pen came to the far corner");
  events->erase(std::prev(last.base()), events->end());
}

/// Takes away the pen's coming and going before the recording.
void DropVisit(std::vector<InputEvent>* events) {
  const auto is_pen = [](const InputEvent& e) { return std::holds_alternative<PenEvent>(e); };
  const auto came = std::find_if(events->begin(), events->end(), is_pen);
  const auto went = std::find_if(came, events->end(), [&](const InputEvent& event) {
    return is_pen(event) && std::get<PenEvent>(event).kind == PenEvent::Kind::kProximityOut;
  });
  CHECK(went != events->end(), "the pen that came before went again");
  events->erase(came, std::next(went));
}

/// From the player's clock back to the recording's: the first report was its first event.
void RestoreTimes(int64_t first_us, std::vector<InputEvent>* events) {
  std::optional<double> first_s;
  for (InputEvent& event : *events) {
    auto* pen = std::get_if<PenEvent>(&event);
    if (!pen) continue;
    if (!first_s) first_s = pen->t_s;
    const double since_us = std::round((pen->t_s - *first_s) * 1e6);
    pen->t_s = (static_cast<double>(first_us) + since_us) / 1e6;
  }
}

/// The mocked node's events. A named pipe takes whole events or none, and lets none be lost: what
/// there is no room for waits until the program has read.
class Pipe {
 public:
  explicit Pipe(const std::string& path) {
    ::unlink(path.c_str());
    CHECK(::mkfifo(path.c_str(), 0600) == 0, "the folder of a test can be written");
    fd_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    CHECK(fd_ >= 0, "a pipe just made can be opened");
  }
  ~Pipe() { ::close(fd_); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void Fill(std::vector<input_event> events) { events_ = std::move(events); }
  bool filled() const { return !events_.empty(); }

  /// Pushes as many as there is room for.
  void Push() {
    constexpr size_t kAtOnce = PIPE_BUF / sizeof(input_event);  // goes in whole, or not at all
    while (pushed_ < events_.size()) {
      const size_t bytes = std::min(kAtOnce, events_.size() - pushed_) * sizeof(input_event);
      if (::write(fd_, &events_[pushed_], bytes) != static_cast<ssize_t>(bytes)) return;
      pushed_ += bytes / sizeof(input_event);
    }
  }

 private:
  int fd_ = -1;
  std::vector<input_event> events_;
  size_t pushed_ = 0;
};

}  // namespace

MockTablet::MockTablet(const EvdevRecording& recording) : recording_(recording) {
  std::string name = (fs::temp_directory_path() / "parti-tablet-XXXXXX").string();
  CHECK(::mkdtemp(name.data()) != nullptr, "tests can make folders");
  folder_ = name;
  AppendEnd(&recording_);
  fs::create_directory(folder_ / "udev");
  Write((folder_ / "udev" / UdevDataName()).string(), UdevData());
  Write(File("device"), UmockdevDevice(recording_));
  Write(File("ioctls"), UmockdevIoctls(recording_));
}

MockTablet::~MockTablet() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::string MockTablet::EndMark() const {
  const auto corner_mm = [this](int code) {
    const EvdevAxis& axis = recording_.axes.at(code);
    return static_cast<double>(axis.maximum - axis.minimum) / axis.resolution;
  };
  return fmt::format(" {},{}", corner_mm(ABS_X), corner_mm(ABS_Y));
}

Result<MockTablet::Outcome> MockTablet::Run(const std::vector<std::string>& program,
                                            const Watch& watch, double patience_s) const {
  fs::remove(folder_ / "pid");
  Pipe events(File("event5.pipe"));
  const std::string watched = watch.file.empty() ? File("output") : watch.file;
  const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
  Child child(CommandFor(program), File("output"), File("errors"));
  bool interrupted = watch.end.empty();
  while (Clock::now() < deadline) {
    if (const auto status = child.Ended()) {
      return Outcome{*status, ReadOr(File("output")), ReadOr(File("errors"))};
    }
    const std::string tail = TailOf(watched);
    if (!watch.ready.empty() && !events.filled() && tail.find(watch.ready) != std::string::npos) {
      events.Fill(KernelEvents(recording_.events, Now_us() + kAhead_us));
    }
    events.Push();
    if (!interrupted && tail.find(watch.end) != std::string::npos) {
      ::kill(std::atoi(ReadOr(File("pid")).c_str()), SIGINT);
      interrupted = true;
    }
    std::this_thread::sleep_for(kLook);
  }
  return Fail(ErrorCode::kDevice, fmt::format("{} did not end within {} s; its errors: {}",
                                              program.front(), patience_s, ReadOr(File("errors"))));
}

std::vector<std::string> MockTablet::CommandFor(const std::vector<std::string>& program) const {
  const std::string node = kMockNode;
  std::vector<std::string> words{
      "umockdev-run", "-d", File("device"), "-i", node + "=" + File("ioctls"), "--", "env",
      "MOCK_FOLDER=" + folder_.string(),
      // The sanitizers' runtime wants to be loaded first, and can do without.
      "ASAN_OPTIONS=verify_asan_link_order=0",
      fmt::format("LD_PRELOAD={}:libumockdev-preload.so.0", PARTI_MOCK_NODE), "sh", "-c", kRunner,
      folder_.string()};
  words.insert(words.end(), program.begin(), program.end());
  return words;
}

Result<input::Drawing> PlayThroughLibinput(const EvdevRecording& recording) {
  const MockTablet tablet(recording);
  const std::string out = (tablet.folder() / "seen.pen").string();
  const auto outcome =
      tablet.Run({PARTI_PROGRAM, "record", out, "--device", kMockNode},
                 {.file = out, .ready = "device 0 added", .end = tablet.EndMark()});
  if (!outcome) return Fail(outcome);
  if (outcome->status != 0) {
    return Fail(ErrorCode::kDevice, "parti record failed: " + outcome->errors);
  }
  auto reading = input::ReadDrawing(ReadOr(out), out);
  if (reading.damage) return tl::unexpected(*reading.damage);
  DropEnd(&reading.drawing.events);
  if (!recording.events.empty()) {
    RestoreTimes(recording.events.front().t_us, &reading.drawing.events);
  }
  if (recording.begins_with_visit) DropVisit(&reading.drawing.events);
  return reading.drawing;
}

}  // namespace parti::tests
