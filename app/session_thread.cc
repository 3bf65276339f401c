#include "app/session_thread.h"

#include <fmt/format.h>

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "app/document.h"
#include "app/document_drafts.h"
#include "app/output.h"
#include "app/session.h"
#include "base/check.h"

namespace parti::app {

class SessionThread::Impl {
 public:
  explicit Impl(SessionThreadOptions options)
      : options_(std::move(options)), session_(options_.session) {
    Publish();
    thread_ = std::thread([this] { Work(); });
  }
  ~Impl() { Stop(); }

  uint64_t Post(SessionRequest request) {
    const std::lock_guard lock(mutex_);
    CHECK(!stopping_, "nothing can be posted after Stop()");
    waiting_.push_back(std::move(request));
    posted_.notify_one();
    return ++last_number_;
  }

  std::shared_ptr<const SessionSnapshot> Newest() const {
    const std::lock_guard lock(mutex_);
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
  }

 private:
  void Work() {
    if (!options_.path.empty()) Note(Open(options_.path));
    Publish();
    while (auto request = Next()) {
      ++snapshot_.executed;
      Note(std::visit([this](auto& r) { return Do(r); }, *request));
      Publish();
    }
  }

  /// Waits for a request; nothing when all are done and it is time to stop.
  std::optional<SessionRequest> Next() {
    std::unique_lock lock(mutex_);
    posted_.wait(lock, [this] { return stopping_ || !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    auto request = std::optional<SessionRequest>(std::move(waiting_.front()));
    waiting_.pop_front();
    return request;
  }

  void Note(const Result<void>& done) {
    if (!done) snapshot_.last_error = {snapshot_.executed, done.error()};
  }

  void Publish() {
    snapshot_.state = std::make_shared<const SessionState>(session_.state());
    const std::lock_guard lock(mutex_);
    snapshot_.busy = !waiting_.empty();
    newest_ = std::make_shared<const SessionSnapshot>(snapshot_);
    ready_.Wake();
  }

  Result<void> Do(const Stroke& stroke) {
    const auto done = session_.AddStroke(stroke);
    Keep();
    return done;
  }

  Result<void> Do(const Command& command) {
    const auto done = session_.Execute(command);
    Keep();
    return done;
  }

  Result<void> Do(const DocumentRequest& request) {
    switch (request.kind) {
      case DocumentRequest::Kind::kNew:
        session_ = Session(options_.session);
        snapshot_.document = {};
        snapshot_.acknowledged = snapshot_.executed;
        return {};
      case DocumentRequest::Kind::kOpen:
        return Open(request.path);
      case DocumentRequest::Kind::kSaveAs:
        return SaveAs(request.path);
      case DocumentRequest::Kind::kExport:
        return ExportModel(session_.state().model, session_.state().camera, request.path);
      case DocumentRequest::Kind::kRecordForReport:
        return Fail(ErrorCode::kNothingMade, "no session has been recorded");
    }
    return {};
  }

  Result<void> Open(const std::string& path) {
    auto document = OpenDocument(path);
    if (!document) return Fail(document);
    auto model =
        BuiltOn(std::move(document->lots), std::move(document->trees), grammar::Unfit::kSkip);
    if (!model) return Fail(model);
    session_ = Session(std::move(*model), document->view, options_.session);
    snapshot_.document = {path, true};
    snapshot_.acknowledged = snapshot_.executed;
    return {};
  }

  Result<void> SaveAs(const std::string& path) {
    if (auto done = SaveDocument(DocumentOf(session_), path); !done) return done;
    snapshot_.document = {path, true};
    snapshot_.acknowledged = snapshot_.executed;
    return {};
  }

  /// Brings the document's file up to what was executed; a failure stays in the status.
  void Keep() {
    DocumentStatus& status = snapshot_.document;
    if (status.path.empty()) {
      const auto path = NewDraftPath(options_.folders.data);
      if (path) status.path = *path;
      if (!path) status.trouble = path.error();
    }
    if (!status.path.empty()) {
      const auto done = SaveDocument(DocumentOf(session_), status.path);
      status.trouble = done ? std::nullopt : std::optional(done.error());
    }
    status.unwritten = status.trouble ? status.unwritten + 1 : 0;
    if (!status.trouble) snapshot_.acknowledged = snapshot_.executed;
  }

  const SessionThreadOptions options_;
  WakeFd ready_;

  mutable std::mutex mutex_;  // held to move a value, never longer; guards:
  std::condition_variable posted_;
  std::deque<SessionRequest> waiting_;
  uint64_t last_number_ = 0;
  bool stopping_ = false;
  std::shared_ptr<const SessionSnapshot> newest_;

  // The session thread's own.
  Session session_;
  SessionSnapshot snapshot_;

  std::thread thread_;
};

SessionThread::SessionThread(SessionThreadOptions options)
    : impl_(std::make_unique<Impl>(std::move(options))) {}
SessionThread::~SessionThread() = default;

uint64_t SessionThread::Post(SessionRequest request) { return impl_->Post(std::move(request)); }
std::shared_ptr<const SessionSnapshot> SessionThread::Newest() const { return impl_->Newest(); }
const WakeFd& SessionThread::ready() const { return impl_->ready(); }
void SessionThread::Stop() { impl_->Stop(); }

}  // namespace parti::app
