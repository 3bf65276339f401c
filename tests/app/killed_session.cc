#include "tests/app/killed_session.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "app/replay.h"
#include "base/check.h"
#include "base/text_file.h"
#include "tests/support/data.h"

namespace parti::tests {
namespace {

/// The child's life: never returns.
[[noreturn]] void Run(const app::SessionThreadOptions& options,
                      const std::vector<app::SessionRequest>& requests, int pipe) {
  app::SessionThread thread(options);
  for (const auto& request : requests) thread.Post(request);
  uint64_t reported = 0;
  while (reported < requests.size()) {
    pollfd news{thread.ready().fd(), POLLIN, 0};
    ::poll(&news, 1, -1);
    thread.ready().Clear();
    const uint64_t now = thread.Newest()->acknowledged;
    if (now > reported && ::write(pipe, &now, sizeof now) == sizeof now) reported = now;
  }
  thread.Stop();
  ::_exit(0);
}

}  // namespace

KilledSession::KilledSession(const app::SessionThreadOptions& options,
                             const std::vector<app::SessionRequest>& requests) {
  int ends[2];
  CHECK(::pipe(ends) == 0, "a test may have a pipe");
  child_ = ::fork();
  CHECK(child_ >= 0, "a test may have a child");
  if (child_ == 0) Run(options, requests, ends[1]);
  ::close(ends[1]);
  pipe_ = ends[0];
}

KilledSession::~KilledSession() {
  KillAfter(std::chrono::microseconds(0));
  ::close(pipe_);
}

bool KilledSession::ReadOne() {
  uint64_t number = 0;
  if (::read(pipe_, &number, sizeof number) != sizeof number) return false;
  acknowledged_ = number;
  return true;
}

void KilledSession::WaitFor(uint64_t number) {
  while (acknowledged_ < number && ReadOne()) {
  }
}

uint64_t KilledSession::KillAfter(std::chrono::microseconds wait) {
  if (child_ < 0) return acknowledged_;
  std::this_thread::sleep_for(wait);
  ::kill(child_, SIGKILL);
  ::waitpid(child_, nullptr, 0);
  child_ = -1;
  while (ReadOne()) {
  }
  return acknowledged_;
}

std::vector<app::SessionRequest> HouseRequests() {
  const auto text = ReadFile(SourceFile("assets/drawings/house.pen"));
  CHECK(text.has_value(), "the project has its demo");
  app::Session session;
  app::ReplayReport report;
  const auto played = app::Replay(input::ReadDrawing(*text).drawing, &session, &report);
  CHECK(played.has_value(), "the demo can be played");
  std::vector<app::SessionRequest> requests;
  for (const app::HistoryEntry& entry : session.history()) {
    if (entry.command) {
      requests.emplace_back(*entry.command);
    } else {
      requests.emplace_back(entry.stroke->stroke);
    }
  }
  return requests;
}

}  // namespace parti::tests
