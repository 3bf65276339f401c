#include "tests/support/mock_tablet.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/input-event-codes.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
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
#include "tests/support/umockdev_files.h"

namespace parti::tests {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

// Event times lie this far ahead of the clock. libinput takes a pen that was silent for 50 ms for
// gone, by the clock; on a busy machine that would happen in the middle of a stroke. With times
// that the clock never reaches it does not, and every playing gives the same.
constexpr int64_t kAhead_us = 1'000'000'000;
constexpr int64_t kLastPause_us = 20'000;
constexpr std::chrono::milliseconds kLook(5);        // between looks at what a program does
constexpr std::chrono::milliseconds kCleaning(500);  // for umockdev to take its folder away
// Runs the program, telling its process and then its status in files; umockdev-run itself may hang
// with events that nobody reads.
constexpr const char* kRunner =
    "\"$@\" & echo $! >\"$0/pid\"; wait $!; s=$?; echo $s >\"$0/status\"; exit $s";

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

void Redirect(int fd, const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags, 0600);
  if (file < 0 || ::dup2(file, fd) < 0) ::_exit(126);
}

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

/// From the player's clock back to the recording's: the first report was its first event.
void RestoreTimes(int64_t first_us, double speed, std::vector<InputEvent>* events) {
  std::optional<double> first_s;
  for (InputEvent& event : *events) {
    auto* pen = std::get_if<PenEvent>(&event);
    if (!pen) continue;
    if (!first_s) first_s = pen->t_s;
    const double since_us = std::round((pen->t_s - *first_s) * 1e6) * speed;
    pen->t_s = (static_cast<double>(first_us) + since_us) / 1e6;
  }
}

/// A named pipe, so that the player gets its events no sooner than they are pushed: what it plays
/// before the program has opened the tablet is lost.
class Pipe {
 public:
  explicit Pipe(const std::string& path) {
    ::unlink(path.c_str());
    CHECK(::mkfifo(path.c_str(), 0600) == 0, "the folder of a test can be written");
    fd_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    CHECK(fd_ >= 0, "a pipe just made can be opened");
  }
  ~Pipe() { Close(); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void Fill(std::string text) { text_ = std::move(text); }

  /// Pushes as much as there is room for; closes after the last.
  void Push() {
    if (fd_ < 0 || !text_) return;
    const ssize_t taken = ::write(fd_, text_->data(), text_->size());
    if (taken > 0) text_->erase(0, static_cast<size_t>(taken));
    if (text_->empty()) Close();
  }

  /// Nothing more comes: the player stops waiting.
  void Close() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }

  bool filled() const { return text_.has_value(); }

 private:
  int fd_ = -1;
  std::optional<std::string> text_;
};

/// A child in a process group of its own; killed with all its children unless it was waited for.
class Child {
 public:
  Child(const std::vector<std::string>& words, const std::string& output,
        const std::string& errors) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ != 0) return;
    ::setpgid(0, 0);
    Redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    Redirect(STDOUT_FILENO, output, O_WRONLY | O_CREAT | O_TRUNC);
    Redirect(STDERR_FILENO, errors, O_WRONLY | O_CREAT | O_TRUNC);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  ~Child() {
    if (pid_ <= 0 || ended_) return;
    ::kill(-pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool Ended() {
    if (!ended_) ended_ = ::waitpid(pid_, nullptr, WNOHANG) == pid_;
    return ended_;
  }

  void GiveTime(std::chrono::milliseconds time) {
    const auto deadline = Clock::now() + time;
    while (!Ended() && Clock::now() < deadline) std::this_thread::sleep_for(kLook);
  }

 private:
  pid_t pid_ = -1;
  bool ended_ = false;
};

}  // namespace

MockTablet::MockTablet(const EvdevRecording& recording, double speed)
    : recording_(recording), speed_(speed) {
  std::string name = (fs::temp_directory_path() / "parti-tablet-XXXXXX").string();
  CHECK(::mkdtemp(name.data()) != nullptr, "tests can make folders");
  folder_ = name;
  AppendEnd(&recording_);
  fs::create_directory(folder_ / "udev");
  Write(File("udev/c13:69"), UdevData());
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
  for (const char* earlier : {"pid", "status"}) fs::remove(folder_ / earlier);
  Pipe events(File("events"));
  const std::string watched = watch.file.empty() ? File("output") : watch.file;
  const auto deadline = Clock::now() + std::chrono::duration<double>(patience_s);
  Child child(CommandFor(program), File("output"), File("errors"));
  bool interrupted = watch.end.empty();
  while (Clock::now() < deadline) {
    if (child.Ended()) break;
    const std::string status = ReadOr(File("status"));
    if (status.ends_with('\n')) {
      // The player would wait for more, or for someone to read what it plays.
      events.Close();
      child.GiveTime(kCleaning);
      return Outcome{std::atoi(status.c_str()), ReadOr(File("output")), ReadOr(File("errors"))};
    }
    const int program_id = std::atoi(ReadOr(File("pid")).c_str());
    const std::string tail = TailOf(watched);
    if (!watch.ready.empty() && !events.filled() && tail.find(watch.ready) != std::string::npos) {
      events.Fill(UmockdevScript(recording_, Now_us() + kAhead_us, speed_));
    }
    events.Push();
    if (!interrupted && program_id > 0 && tail.find(watch.end) != std::string::npos) {
      ::kill(program_id, SIGINT);
      interrupted = true;
    }
    std::this_thread::sleep_for(kLook);
  }
  return Fail(ErrorCode::kDevice,
              fmt::format("{} could not be run, or did not end within {} s; its errors: {}",
                          program.front(), patience_s, ReadOr(File("errors"))));
}

std::vector<std::string> MockTablet::CommandFor(const std::vector<std::string>& program) const {
  const std::string node = kMockNode;
  std::vector<std::string> words{
      "umockdev-run", "-d", File("device"), "-i", node + "=" + File("ioctls"), "-s",
      node + "=" + File("events"), "--", "env", "MOCK_NODE=13:69", "MOCK_UDEV_DATA=" + File("udev"),
      // The sanitizers' runtime wants to be loaded first, and can do without.
      "ASAN_OPTIONS=verify_asan_link_order=0",
      "LD_PRELOAD=" PARTI_MOCK_NODE ":libumockdev-preload.so.0", "sh", "-c", kRunner,
      folder_.string()};
  words.insert(words.end(), program.begin(), program.end());
  return words;
}

Result<input::Drawing> PlayThroughLibinput(const EvdevRecording& recording, double speed) {
  const MockTablet tablet(recording, speed);
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
    RestoreTimes(recording.events.front().t_us, speed, &reading.drawing.events);
  }
  return reading.drawing;
}

}  // namespace parti::tests
