// A seat whose devices come and go as a script says: mocked by umockdev, seen by LibinputSource,
// whose events it prints. It must run with the preloaded libraries of tests/support/mock_seat.cc.
//
//   mock_seat FOLDER SCRIPT       FOLDER/eventN.device, .ioctls, udev/   as umockdev_files.h
//
// A line of the script is one of:  plug N | unplug N | deny N | view W H SCALE |
// left-handed 0|1 | suspend | resume | why | wait SECONDS | ahead SECONDS |
// send N T_US TYPE CODE VALUE   with times since the script began.  A look at the source, whose
// lines end with "--", follows whatever is not `send`, and the last of several.
#include <fcntl.h>
#include <fmt/format.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "base/check.h"
#include "base/text_file.h"
#include "input/event_text.h"
#include "input/libinput_source.h"
#include "tests/support/umockdev_files.h"

namespace parti::tests {
namespace {

constexpr double kQuiet_s = 0.03;  // no events for so long: that was all

int64_t Now_us() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return int64_t{now.tv_sec} * 1'000'000 + now.tv_nsec / 1000;
}

class Seat {
 public:
  explicit Seat(std::string folder)
      : folder_(std::move(folder)), testbed_(umockdev_testbed_new()), start_us_(Now_us()) {
    input::LibinputOptions options{.mice_and_keys = true};
    options.opener.open = [this, own = options.opener.open](const char* node, int flags) {
      return denied_.contains(node) ? -EACCES : own(node, flags);
    };
    auto source = input::LibinputSource::OpenSeat("seat0", options);
    CHECK(source.has_value(), "libinput can be started");
    source_ = std::make_unique<input::LibinputSource>(std::move(*source));
  }

  void Do(const std::string& line) {
    std::istringstream words(line);
    std::string verb;
    words >> verb;
    if (verb == "send") return Send(words);
    if (verb == "ahead") {
      double ahead_s = 0;
      words >> ahead_s;
      start_us_ = Now_us() + static_cast<int64_t>(ahead_s * 1e6);
      return;
    }
    Change(verb, words);
    Look();
  }

  void Look() {
    do {
      Print();
    } while (source_->Wait(kQuiet_s));
    fmt::print("--\n");
  }

 private:
  void Print() {
    const auto events = source_->Dispatch();
    CHECK(events.has_value(), "libinput goes on");
    for (const InputEvent& event : *events) fmt::print("{}\n", input::EventText(event));
  }

  void Change(const std::string& verb, std::istringstream& words) {
    int number = 0;
    if (verb == "view") {
      Vec2 size_px(0, 0);
      double scale = 1;
      words >> size_px.x >> size_px.y >> scale;
      return source_->SetView(size_px, scale);
    }
    if (verb == "suspend") return source_->Suspend();
    if (verb == "resume") return CHECK(source_->Resume().has_value(), "the seat comes back");
    if (verb == "why") return fmt::print("{}\n", FormatError(source_->WhyNothing()));
    if (verb == "wait") return Wait(words);
    words >> number;
    if (verb == "left-handed") return source_->SetLeftHanded(number != 0);
    const MockPlace place{.number = number};
    if (verb == "plug") return Plug(place);
    if (verb == "unplug") return Unplug(place);
    const std::string node = fmt::format("/dev/input/event{}", number);
    if (verb == "deny") denied_.insert(node);
  }

  std::string File(int number, const char* ending) const {
    return fmt::format("{}/event{}.{}", folder_, number, ending);
  }

  void Plug(const MockPlace& place) {
    const std::string pipe = File(place.number, "pipe");
    ::unlink(pipe.c_str());
    CHECK(::mkfifo(pipe.c_str(), 0600) == 0, "the folder of a test can be written");
    pipes_[place.number] = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    const std::string device = *ReadFile(File(place.number, "device"));
    const std::string ioctls = File(place.number, "ioctls");
    const std::string node = fmt::format("/dev/input/event{}", place.number);
    GError* error = nullptr;
    CHECK(umockdev_testbed_add_from_string(testbed_, device.c_str(), &error), "umockdev's format");
    CHECK(umockdev_testbed_load_ioctl(testbed_, node.c_str(), ioctls.c_str(), &error),
          "umockdev's format");
  }

  void Unplug(const MockPlace& place) {
    umockdev_testbed_uevent(testbed_, ("/sys" + SysfsNodePath(place)).c_str(), "remove");
    for (const std::string& path : {SysfsNodePath(place), SysfsPath(place)}) {
      umockdev_testbed_remove_device(testbed_, ("/sys" + path).c_str());
    }
    ::close(pipes_[place.number]);
    pipes_.erase(place.number);
  }

  void Send(std::istringstream& words) {
    int number = 0;
    int64_t t_us = 0;
    input_event event{};
    words >> number >> t_us >> event.type >> event.code >> event.value;
    constexpr int64_t kSecond_us = 1'000'000;
    event.input_event_sec = (start_us_ + t_us) / kSecond_us;
    event.input_event_usec = (start_us_ + t_us) % kSecond_us;
    CHECK(!words.fail() && pipes_.contains(number), "a sound script");
    while (::write(pipes_[number], &event, sizeof event) != sizeof event) {
      CHECK(errno == EAGAIN, "a pipe takes events");
      Print();  // makes room
    }
  }

  void Wait(std::istringstream& words) {
    double wait_s = 0;
    words >> wait_s;
    const int64_t end_us = Now_us() + static_cast<int64_t>(wait_s * 1e6);
    while (Now_us() < end_us) {
      Print();
      source_->Wait(static_cast<double>(end_us - Now_us()) * 1e-6);
    }
  }

  std::string folder_;
  UMockdevTestbed* testbed_;
  int64_t start_us_;
  std::set<std::string, std::less<>> denied_;
  std::map<int, int> pipes_;
  std::unique_ptr<input::LibinputSource> source_;
};

int Main(const std::string& folder, const std::string& script) {
  Seat seat(folder);
  std::ifstream lines(script);
  bool sent = false;
  for (std::string line; std::getline(lines, line);) {
    const bool sends = line.starts_with("send");
    if (sent && !sends) seat.Look();
    seat.Do(line);
    sent = sends;
  }
  if (sent) seat.Look();
  return 0;
}

}  // namespace
}  // namespace parti::tests

int main(int count, char** words) {
  if (count != 3) return 2;
  return parti::tests::Main(words[1], words[2]);
}
