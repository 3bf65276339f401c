#include "app/document_thread.h"

#include <algorithm>
#include <chrono>

namespace parti::app {
namespace {

// How often writing is tried again where it failed, and how often it is looked for the file.
constexpr auto kTryAgain = std::chrono::seconds(2);
// How often news come while the session is at work, so that long work is seen.
constexpr auto kStillThere = std::chrono::milliseconds(250);
// Changes that one transaction takes at most: the others need not wait for a long one.
constexpr size_t kMostChanges = 64;

}  // namespace

PostedRequest Kept(const SessionRequest& request) {
  if (const auto* stroke = std::get_if<Stroke>(&request)) return {"", *stroke};
  return {TextOf(std::get<Command>(request))};
}

DocumentThread::DocumentThread(UserFolders folders, News news)
    : news_(std::move(news)), keeper_(std::move(folders)), thread_([this] { Work(); }) {}

DocumentThread::~DocumentThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    given_.notify_one();
  }
  thread_.join();
}

void DocumentThread::Posted(int64_t number, std::shared_ptr<const SessionRequest> request) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back({number, std::move(request)});
  last_posted_ = number;
  given_.notify_one();
}

void DocumentThread::Executed(DocumentChange change) {
  const std::lock_guard lock(mutex_);
  while (!waiting_.empty() && waiting_.front().number <= change.number) waiting_.pop_front();
  last_executed_ = std::max(last_executed_, change.number);
  changes_.push_back(std::move(change));
  given_.notify_one();
}

void DocumentThread::Flush() {
  std::unique_lock lock(mutex_);
  rests_.wait(lock, [this] { return resting_ && !HasWork(); });
}

std::future<void> DocumentThread::Add(std::function<void(DocumentKeeper&)> work) {
  const std::lock_guard lock(mutex_);
  calls_.push_back({std::move(work), {}});
  given_.notify_one();
  return calls_.back().told.get_future();
}

bool DocumentThread::HasWork() const {
  const bool may_keep =
      !waiting_.empty() && !std::holds_alternative<DocumentRequest>(*waiting_.front().request);
  return stop_ || may_keep || !changes_.empty() || !calls_.empty();
}

/// Requests up to the next one about documents.
std::vector<KeptRequest> DocumentThread::TakeRequests() {
  std::vector<KeptRequest> requests;
  while (!waiting_.empty()) {
    const auto& [number, request] = waiting_.front();
    if (std::holds_alternative<DocumentRequest>(*request)) break;
    // A view that another follows at once was never seen (docs/document.md).
    const bool moot = waiting_.size() > 1 && IsMoot(*request, *waiting_[1].request);
    if (!moot) requests.push_back({number, Kept(*request)});
    waiting_.pop_front();
  }
  return requests;
}

DocumentThread::Batch DocumentThread::Next() {
  std::unique_lock lock(mutex_);
  const auto has_work = [this] { return HasWork(); };
  resting_ = true;
  rests_.notify_all();
  if (last_executed_ < last_posted_) {
    given_.wait_for(lock, kStillThere, has_work);
  } else {
    given_.wait_for(lock, kTryAgain, has_work);
  }
  resting_ = false;
  Batch batch;
  const auto end =
      changes_.begin() + static_cast<std::ptrdiff_t>(std::min(changes_.size(), kMostChanges));
  std::move(changes_.begin(), end, std::back_inserter(batch.changes));
  changes_.erase(changes_.begin(), end);
  if (!changes_.empty()) return batch;
  if (!calls_.empty()) {
    batch.call = std::move(calls_.front());
    calls_.pop_front();
  } else {
    batch.requests = TakeRequests();
    batch.stop = stop_ && batch.requests.empty();
  }
  return batch;
}

void DocumentThread::Work() {
  while (true) {
    Batch batch = Next();
    const bool idle = batch.changes.empty() && batch.requests.empty() && !batch.call;
    if (!batch.changes.empty()) keeper_.Apply(std::move(batch.changes));
    if (!batch.requests.empty()) keeper_.Keep(batch.requests);
    if (batch.call) batch.call->work(keeper_);
    if (idle) keeper_.TryAgain();
    news_(keeper_.status(), keeper_.acknowledged());
    if (batch.call) batch.call->told.set_value();
    keeper_.Tidy();
    if (batch.stop) return;
  }
}

}  // namespace parti::app
