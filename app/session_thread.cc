#include "app/session_thread.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <limits>
#include <mutex>
#include <thread>

#include "app/document_report.h"
#include "app/document_thread.h"
#include "app/output.h"
#include "app/replacing.h"
#include "app/session.h"
#include "base/check.h"

namespace parti::app {
namespace {

using Clock = std::chrono::steady_clock;

// What a person would begin to wonder about.
constexpr auto kLong = std::chrono::milliseconds(200);

/// Documents hold finite numbers only, and times that don't run backwards.
void Clean(Stroke* stroke) {
  const auto is_finite = [](const StrokeSample& s) {
    return std::isfinite(s.position.x) && std::isfinite(s.position.y) && std::isfinite(s.t_s);
  };
  std::erase_if(*stroke, [&](const StrokeSample& s) { return !is_finite(s); });
  double last_s = -std::numeric_limits<double>::infinity();
  for (StrokeSample& sample : *stroke) {
    sample.t_s = last_s = std::max(sample.t_s, last_s);
    if (sample.pressure && !std::isfinite(*sample.pressure)) sample.pressure.reset();
  }
}

/// What can't be written into a document and read again can't be done.
Result<void> Checked(const Command& command) {
  const auto again = ParseCommand(TextOf(command));
  return again ? Result<void>() : Fail(again);
}

bool IsLook(const SessionRequest& request) {
  const auto* command = std::get_if<Command>(&request);
  return command && IsLooking(*command);
}

/// What a person reads while it takes its time.
std::string Doing(const DocumentRequest& request) {
  switch (request.kind) {
    case DocumentRequest::Kind::kNew:
      return "";
    case DocumentRequest::Kind::kOpen:
      return "opening " + request.path;
    default:
      return "writing " + request.path;
  }
}

/// That requests which a kill left over are not executed any more.
std::optional<Error> LaidAside(const Document& document, const std::string& path) {
  const auto count = std::count_if(document.laid_aside.begin(), document.laid_aside.end(),
                                   [](const PostedRequest& request) { return request.begun > 0; });
  if (count == 0) return std::nullopt;
  return Error{
      ErrorCode::kLimitReached,
      fmt::format("what ended the program twice was left out: {} of what was drawn last", count),
      fmt::format("draw on without it, and report it with a copy of {}: it is kept in there",
                  path)};
}

}  // namespace

class SessionThread::Impl {
 public:
  explicit Impl(SessionThreadOptions options)
      : options_(std::move(options)), session_(options_.session) {
    document_.emplace(options_.folders, [this](const DocumentStatus& status, int64_t acknowledged) {
      TakeNews(status, acknowledged);
    });
    // What is posted belongs to the document that is opened first, and waits for it.
    document_->Posted(0, std::make_shared<const SessionRequest>(DocumentRequest{}));
    PublishState();
    if (!options_.path.empty()) SetDoing(Doing(FirstOpening()));
    thread_ = std::thread([this] { Work(); });
  }
  ~Impl() { Stop(); }

  uint64_t Post(SessionRequest request) {
    if (auto* stroke = std::get_if<Stroke>(&request)) Clean(stroke);
    const auto shared = std::make_shared<const SessionRequest>(std::move(request));
    const std::lock_guard lock(mutex_);
    CHECK(!stopping_, "nothing can be posted after Stop()");
    const uint64_t number = ++last_number_;
    waiting_.push_back({number, shared});
    document_->Posted(static_cast<int64_t>(number), shared);
    posted_.notify_one();
    return number;
  }

  std::shared_ptr<const SessionSnapshot> Newest() const {
    const std::lock_guard lock(newest_mutex_);
    return newest_;
  }

  const WakeFd& ready() const { return ready_; }

  void Stop() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
      posted_.notify_one();
    }
    if (thread_.joinable()) thread_.join();
    document_.reset();  // writes what was executed
  }

  bool StopWithin(std::chrono::milliseconds most) {
    {
      std::unique_lock lock(mutex_);
      stopping_ = true;
      posted_.notify_one();
      leaving_ = !at_ease_.wait_for(lock, most, [this] { return ended_; });
      at_ease_.wait(lock, [this] { return ended_ || (!must_finish_ && !DocumentsWait()); });
      if (!ended_) {
        const std::vector<KeptRequest> left = Left();
        lock.unlock();
        Rescue({}, left);
        document_->Flush();
        return false;
      }
    }
    Stop();
    return true;
  }

 private:
  struct Request {
    uint64_t number = 0;
    std::shared_ptr<const SessionRequest> what;
    bool moot = false;  // the next one makes it so
  };

  DocumentRequest FirstOpening() const { return {DocumentRequest::Kind::kOpen, options_.path}; }

  void Work() {
    StartAnew(true);
    if (!options_.path.empty()) {
      const auto opened = Open(FirstOpening(), 0);
      if (!opened) Note(0, opened.error());
    }
    document_->Executed({});
    PublishState();
    Set(&must_finish_, false);
    while (auto request = Next()) {
      SetBegun();
      auto done = request->moot ? Result<void>() : Do(*request);
      if (!done) {
        Note(request->number, done.error(), GivingUp(*request->what));
      } else if (!request->moot && !IsLook(*request->what)) {
        NoteMended(request->number);
      }
      const bool on_session = !std::holds_alternative<DocumentRequest>(*request->what);
      DocumentChange change = ChangeBy(static_cast<int64_t>(request->number), done && on_session);
      change.looks = IsLook(*request->what);
      document_->Executed(std::move(change));
      PublishState(request->number);
      Set(&must_finish_, false);
    }
    Rescue(DocumentOf(session_), LeftNow());
    Set(&ended_, true);
  }

  /// What can't be written where it belongs is kept elsewhere before the program ends.
  void Rescue(const Document& in_memory, const std::vector<KeptRequest>& left) {
    // Where that fails, too, the document's own trouble is what there is to tell.
    static_cast<void>(
        document_->Run([&](DocumentKeeper& keeper) { return keeper.Rescue(in_memory, left); }));
  }

  std::vector<KeptRequest> LeftNow() {
    const std::lock_guard lock(mutex_);
    return Left();
  }

  /// What is not executed yet, and more than looks; mutex_ is held.
  std::vector<KeptRequest> Left() const {
    std::vector<KeptRequest> left;
    const auto add = [&](const Request& request) {
      if (!request.what || IsLook(*request.what)) return;
      if (std::holds_alternative<DocumentRequest>(*request.what)) return;
      left.push_back({static_cast<int64_t>(request.number), Kept(*request.what)});
    };
    add(current_);
    for (const Request& request : waiting_) add(request);
    return left;
  }

  void Set(bool* flag, bool value) {
    const std::lock_guard lock(mutex_);
    *flag = value;
    at_ease_.notify_one();
  }

  /// mutex_ is held.
  bool DocumentsWait() const {
    return std::any_of(waiting_.begin(), waiting_.end(), [](const Request& request) {
      return std::holds_alternative<DocumentRequest>(*request.what);
    });
  }

  /// Waits for a request; nothing when all that have to be are done and it is time to stop.
  std::optional<Request> Next() {
    std::unique_lock lock(mutex_);
    posted_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    current_ = {};  // executed, and given to the document
    if (waiting_.empty() || (leaving_ && !DocumentsWait())) return std::nullopt;
    Request request = std::move(waiting_.front());
    waiting_.pop_front();
    request.moot = !waiting_.empty() && IsMoot(*request.what, *waiting_.front().what);
    must_finish_ = std::holds_alternative<DocumentRequest>(*request.what);
    current_ = request;
    return request;
  }

  Result<void> Do(const Request& request) {
    if (const auto* stroke = std::get_if<Stroke>(request.what.get())) {
      return session_.AddStroke(*stroke);
    }
    if (const auto* command = std::get_if<Command>(request.what.get())) {
      auto may = Checked(*command);
      return may ? session_.Execute(*command) : may;
    }
    const auto& about = std::get<DocumentRequest>(*request.what);
    SetDoing(Doing(about));
    return DoDocument(about, request.number);
  }

  Result<void> DoDocument(const DocumentRequest& request, uint64_t number) {
    switch (request.kind) {
      case DocumentRequest::Kind::kNew:
        return StartAnew(request.give_up);
      case DocumentRequest::Kind::kOpen:
        return Open(request, number);
      case DocumentRequest::Kind::kSaveAs:
        return document_->Run([&](DocumentKeeper& keeper) {
          return keeper.SaveAs(request.path, DocumentOf(session_), request.replace);
        });
      case DocumentRequest::Kind::kExport:
      case DocumentRequest::Kind::kRecordForReport:
        return WriteBeside(request);
    }
    return {};
  }

  /// What is written of a document that stays as it is.
  Result<void> WriteBeside(const DocumentRequest& request) {
    if (!request.replace) {
      if (auto free = CheckNothingIsAt(request.path); !free) return free;
    }
    if (request.kind == DocumentRequest::Kind::kExport) {
      return ExportModel(session_.state().model, session_.state().camera, request.path);
    }
    return document_->Run([&](DocumentKeeper& keeper) {
      return WriteReport(keeper.Everything(DocumentOf(session_)), request.path);
    });
  }

  Result<void> StartAnew(bool give_up) {
    Session fresh(options_.session);
    auto done = document_->Run(
        [&](DocumentKeeper& keeper) { return keeper.New(DocumentOf(fresh), give_up); });
    if (done) session_ = std::move(fresh);
    return done;
  }

  Result<void> Open(const DocumentRequest& request, uint64_t number) {
    const auto document = document_->Run(
        [&](DocumentKeeper& keeper) { return keeper.Open(request.path, request.give_up); });
    if (!document) return Fail(document);
    auto session = SessionOf(*document, options_.session);
    if (!session) {
      static_cast<void>(StartAnew(true));  // can't fail: nothing has changed in it
      return Fail(session);
    }
    session_ = std::move(*session);
    DoLeftOver(document->posted, number);
    if (const auto lost = LaidAside(*document, request.path)) Note(number, *lost);
    return {};
  }

  /// Executes what had been posted when the program was killed. Its numbers end with 0; what fails
  /// of it is told as a failure of request `opening`.
  void DoLeftOver(const std::vector<PostedRequest>& posted, uint64_t opening) {
    Set(&must_finish_, true);  // what ends with the program too often is laid aside
    auto number = -static_cast<int64_t>(posted.size());
    for (const PostedRequest& request : posted) {
      ++number;
      if (request.begun > 0) {
        document_->Run([&](DocumentKeeper& keeper) { keeper.BeginLeftOver(number); });
      }
      const auto done = DoAgain(request);
      if (!done) Note(opening, done.error());
      document_->Executed(ChangeBy(number, done.has_value()));
    }
  }

  Result<void> DoAgain(const PostedRequest& request) {
    if (request.command.empty()) return session_.AddStroke(request.stroke);
    const auto command = ParseCommand(request.command);
    return command ? session_.Execute(*command) : Fail(command);
  }

  /// What the session did since the last call.
  DocumentChange ChangeBy(int64_t number, bool done) {
    DocumentChange change{number};
    for (const HistoryEntry& entry : session_.history()) {
      change.stroke = entry.stroke;
      if (entry.command) change.command = TextOf(*entry.command);
    }
    if (done || change.stroke) {
      change.span = session_.timeline().span();
      change.state = session_.timeline().step(change.span.now).record;
    }
    session_.ForgetHistory();
    return change;
  }

  /// The request that would not have failed if what is not on the disk might go.
  std::optional<DocumentRequest> GivingUp(const SessionRequest& failed) {
    const auto* request = std::get_if<DocumentRequest>(&failed);
    const bool leaves = request && (request->kind == DocumentRequest::Kind::kNew ||
                                    request->kind == DocumentRequest::Kind::kOpen);
    if (!leaves || request->give_up) return std::nullopt;
    const bool may =
        document_->Run([](DocumentKeeper& keeper) { return keeper.MayLeave(false).has_value(); });
    if (may) return std::nullopt;
    DocumentRequest again = *request;
    again.give_up = true;
    return again;
  }

  void Note(uint64_t number, const Error& error,
            const std::optional<DocumentRequest>& giving_up = {}) {
    const std::lock_guard lock(publish_mutex_);
    snapshot_.last_error = {number, error, false, giving_up};
  }

  /// What failed before request `number`.
  void NoteMended(uint64_t number) {
    const std::lock_guard lock(publish_mutex_);
    auto& failed = snapshot_.last_error;
    if (failed && failed->number < number) failed->mended = true;
  }

  void SetBegun() {
    const std::lock_guard lock(publish_mutex_);
    begun_ = Clock::now();
  }

  void SetDoing(const std::string& doing) {
    const std::lock_guard lock(publish_mutex_);
    snapshot_.doing = doing;
    if (!doing.empty()) Publish();  // else with the state that came of it
  }

  void PublishState(uint64_t executed = 0) {
    auto state = std::make_shared<const SessionState>(session_.state());
    const Timeline::Span span = session_.timeline().span();
    const std::lock_guard lock(publish_mutex_);
    snapshot_.state = std::move(state);
    snapshot_.can_undo = span.now > span.first;
    snapshot_.can_redo = span.now < span.last;
    snapshot_.executed = std::max(snapshot_.executed, executed);
    snapshot_.busy = false;
    snapshot_.doing.clear();
    begun_.reset();
    Publish();
  }

  /// On the document's thread.
  void TakeNews(const DocumentStatus& status, int64_t acknowledged) {
    const std::lock_guard lock(publish_mutex_);
    const auto number = static_cast<uint64_t>(std::max<int64_t>(acknowledged, 0));
    const bool busy = begun_ && Clock::now() - *begun_ >= kLong;
    if (snapshot_.document == status && snapshot_.acknowledged == number &&
        snapshot_.busy == busy) {
      return;
    }
    snapshot_.busy = busy;
    snapshot_.document = status;
    snapshot_.acknowledged = number;
    if (snapshot_.state) Publish();
  }

  /// publish_mutex_ is held.
  void Publish() {
    auto newest = std::make_shared<const SessionSnapshot>(snapshot_);
    {
      const std::lock_guard lock(newest_mutex_);
      newest_ = std::move(newest);
    }
    ready_.Wake();
  }

  const SessionThreadOptions options_;
  WakeFd ready_;

  std::mutex mutex_;  // held to move a value, never longer; guards:
  std::condition_variable posted_;
  std::deque<Request> waiting_;
  Request current_;  // is being executed
  uint64_t last_number_ = 0;
  bool stopping_ = false;
  bool leaving_ = false;     // what waits stays for the next opening
  bool must_finish_ = true;  // what the thread is at can't be left; at first the opening
  bool ended_ = false;
  std::condition_variable at_ease_;  // one of these two has changed

  mutable std::mutex newest_mutex_;  // held to copy a pointer; guards:
  std::shared_ptr<const SessionSnapshot> newest_;

  std::mutex publish_mutex_;  // between the session's thread and the document's; guards:
  SessionSnapshot snapshot_;
  std::optional<Clock::time_point> begun_;  // the request that is being executed

  Session session_;  // the session thread's own
  std::optional<DocumentThread> document_;
  std::thread thread_;
};

SessionThread::SessionThread(SessionThreadOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
SessionThread::~SessionThread() = default;

uint64_t SessionThread::Post(SessionRequest request) { return impl_->Post(std::move(request)); }
std::shared_ptr<const SessionSnapshot> SessionThread::Newest() const { return impl_->Newest(); }
const WakeFd& SessionThread::ready() const { return impl_->ready(); }
void SessionThread::Stop() { impl_->Stop(); }
bool SessionThread::StopWithin(std::chrono::milliseconds most) { return impl_->StopWithin(most); }

}  // namespace parti::app
