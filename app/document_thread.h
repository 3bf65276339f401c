// The thread that writes: takes changes from the session's thread and keeps requests that wait for
// it, so that what was drawn is on the disk even while a long derivation runs.
// What is written, and what happens when it can't be, is document_keeper.h's.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/document_keeper.h"

namespace parti::app {

/// What is kept of a stroke or a command before it is executed.
PostedRequest Kept(const SessionRequest& request);

/// Changes that wait while one commit runs become one transaction.
class DocumentThread {
 public:
  /// Called on the document's thread after each write, with what is on the disk now; and from time
  /// to time while posted requests are not executed.
  using News = std::function<void(const DocumentStatus&, int64_t acknowledged)>;

  DocumentThread(UserFolders folders, News news);
  ~DocumentThread();  ///< writes what was given, then closes the document
  DocumentThread(const DocumentThread&) = delete;
  DocumentThread& operator=(const DocumentThread&) = delete;

  /// A request that was posted and waits to be executed. Those after a request that changes
  /// documents belong to another one: they are kept when that is done. Doesn't block; any thread.
  void Posted(int64_t number, std::shared_ptr<const SessionRequest> request);

  /// What an executed request did; in order. Doesn't block.
  void Executed(DocumentChange change);

  /// Waits until all that was given is on the disk, as far as it can be.
  void Flush();

  /// Runs `work` with the keeper after everything that was given so far, and waits for it and for
  /// its news: what is published next goes with the status that it left.
  template <typename Work>
  auto Run(Work work) -> std::invoke_result_t<Work, DocumentKeeper&> {
    std::packaged_task<std::invoke_result_t<Work, DocumentKeeper&>(DocumentKeeper&)> task(
        std::move(work));
    Add([&task](DocumentKeeper& keeper) { task(keeper); }).wait();
    return task.get_future().get();
  }

 private:
  struct Call {
    std::function<void(DocumentKeeper&)> work;
    std::promise<void> told;  // kept when its news are out
  };
  struct Waiting {
    int64_t number = 0;
    std::shared_ptr<const SessionRequest> request;
  };
  struct Batch {
    std::vector<DocumentChange> changes;
    std::vector<KeptRequest> requests;
    std::optional<Call> call;
    bool stop = false;
  };

  std::future<void> Add(std::function<void(DocumentKeeper&)> work);
  void Work();
  Batch Next();
  bool HasWork() const;
  std::vector<KeptRequest> TakeRequests();

  const News news_;
  DocumentKeeper keeper_;  // the thread's own

  std::mutex mutex_;  // held to move values, never longer; guards:
  std::condition_variable given_;
  std::condition_variable rests_;
  std::deque<DocumentChange> changes_;
  std::deque<Call> calls_;  // each after all changes
  std::deque<Waiting> waiting_;
  int64_t last_posted_ = 0, last_executed_ = 0;
  bool stop_ = false;
  bool resting_ = false;  // what was taken is written

  std::thread thread_;
};

}  // namespace parti::app
